"""Results: curves, fields and reports."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

from . import _interface as c
from ._curves import Curve
from ._errors import BadUsage
from ._types import Array, Floats

if TYPE_CHECKING:
    from ._mesh import Mesh


@dataclass(frozen=True)
class Report:
    """Counts and measures of a run, with the names and units of docs/driver.md, "The report".

    Lengths are in mesh units, angles in radians, times in ms, memory in MiB. "Before" and "drawn" refer to
    the given curve. None: the plugin does not measure the value.
    """

    version: Optional[str] = None
    faces: Optional[int] = None
    vertices: Optional[int] = None
    tau: Optional[float] = None
    slack: Optional[float] = None
    slack_from: Optional[str] = None  #: "trembling", "edges", "segments", "given" or "none"
    left_out: Optional[int] = None  #: points of strokes that were left out, since other points make them
                                    #: redundant
    left_out_max: Optional[float] = None  #: their largest distance from the smoothed drawing
    max_deviation: Optional[float] = None
    ridge_strength: Optional[float] = None  #: the next two exist only if it is above 0
    ridge_band: Optional[float] = None
    ridge_moved: Optional[float] = None  #: [0, 1], the part of the drawing that was moved onto ridges
    ridge_moved_max: Optional[float] = None
    ridge_already: Optional[float] = None  #: [0, 1]: the part that lay on ridges as it was drawn
    ridge_clicks_moved: Optional[int] = None
    ridge_clicks_moved_max: Optional[float] = None
    pins_added: Optional[int] = None
    edge_length_near: Optional[float] = None
    roughness_near: Optional[float] = None  #: of the mesh along the drawing, in units of edge_length_near
    potential: Optional[str] = None
    engine: Optional[str] = None
    closed: Optional[bool] = None
    points: Optional[int] = None
    length: Optional[float] = None
    points_before: Optional[int] = None
    points_after: Optional[int] = None
    length_before: Optional[float] = None
    length_after: Optional[float] = None
    lifted_length_before: Optional[float] = None
    lifted_length_after: Optional[float] = None
    curvature_before: Optional[float] = None
    curvature_after: Optional[float] = None
    curvature_max_before: Optional[float] = None
    curvature_max_after: Optional[float] = None
    bending_before: Optional[float] = None  #: edge_length_near times the integral of squared curvature
    bending_after: Optional[float] = None
    window_turning_before: Optional[float] = None  #: largest net turning in one edge_length_near, radians
    window_turning_after: Optional[float] = None
    window_turning_2_before: Optional[float] = None  #: largest net turning in two edge_length_near, radians
    window_turning_2_after: Optional[float] = None
    tortuosity_before: Optional[float] = None  #: length / distance of the ends in space; infinite for loops
    tortuosity_after: Optional[float] = None
    deviation: Optional[str] = None  #: the kind of the next distances: "surface", "euclidean", "none"
    deviation_to_drawn_max: Optional[float] = None
    deviation_to_drawn_mean: Optional[float] = None
    deviation_from_drawn_max: Optional[float] = None
    deviation_from_drawn_mean: Optional[float] = None
    deviation_at: Optional[Tuple[float, ...]] = None  #: (3,), the place of the largest
    deviation_exact: Optional[bool] = None  #: False: the limit on work was reached; the distances are upper
                                            #: bounds
    deviation_at_least: Optional[float] = None  #: a lower bound of the largest distance
    missed_points: Optional[int] = None  #: way-points that the result does not pass
    missed_max: Optional[float] = None  #: the largest distance of such a point from the result, through space
    missed_at: Optional[Tuple[float, ...]] = None  #: (3,), the place of the farthest such point
    farthest: Optional[float] = None  #: a lower bound of the largest distance between result and drawing,
                                      #: either way, and of missed way-points
    farthest_at_most: Optional[float] = None  #: its upper bound, equal if exact; infinite if not known
    farthest_at: Optional[Tuple[float, ...]] = None  #: (3,), the place of this distance
    farthest_of: Optional[str] = None  #: the owner of this place: "result", "drawing", "point", "none"
    moved: Optional[float] = None
    flips: Optional[int] = None
    iterations: Optional[int] = None
    faces_touched: Optional[int] = None
    trace_fallbacks: Optional[int] = None
    stretches_redrawn: Optional[int] = None  #: stretches in which smoothing began from another path; 0: from
                                             #: the whole drawing
    mollification: Optional[float] = None  #: largest lengthening of an edge for the paper's distance
    crossings_before: Optional[int] = None
    crossings_after: Optional[int] = None
    termination: Optional[str] = None  #: "converged", "missed", "deviation", "collapsed" or "limit"
    warnings: Tuple[str, ...] = ()
    decisive: Tuple[str, ...] = ()  #: the warnings by which a result may be of no use
    decisive_at: Tuple[float, ...] = ()  #: x, y and z of the place of each decisive warning; infinite without
                                         #: a place
    time_ms: Dict[str, float] = field(default_factory=dict)
    peak_memory_mib: Optional[float] = None
    #: Entries with other names, e.g. of a plugin by others
    more: Dict[str, Any] = field(default_factory=dict)

    def __str__(self) -> str:
        named = ((f.name, getattr(self, f.name)) for f in fields(self))
        return "\n".join(f"{name}: {value}" for name, value in named if value not in (None, (), {}))


_NAMES = {f.name for f in fields(Report)} - {"time_ms", "more"}


def value_of(entry: c.ReportEntry) -> Any:
    """The value of an entry, or a tuple of values: float, int, bool or str."""
    if entry.type == c.VALUE_TEXT:
        values: List[Any] = [entry.texts[k].decode() for k in range(entry.count)]
    else:
        kind = {c.VALUE_INTEGER: int, c.VALUE_BOOLEAN: bool}.get(entry.type, float)
        values = [kind(entry.numbers[k]) for k in range(entry.count)]
    return tuple(values) if entry.is_list else values[0]


def report_of(entries: Dict[str, Any]) -> Report:
    known: Dict[str, Any] = {}
    times: Dict[str, float] = {}
    more: Dict[str, Any] = {}
    for key, value in entries.items():
        if key in _NAMES:
            known[key] = value
        elif key.startswith("time_ms."):
            times[key[len("time_ms."):]] = value
        else:
            more[key] = value
    return Report(time_ms=times, more=more, **known)


@dataclass(frozen=True, eq=False, repr=False)
class Result:
    """The result of a run."""

    curves: List[Curve]  #: a curve for each given one, in the same order
    reports: List[Report]  #: a report for each curve
    total: Report  #: the report of all curves together
    #: If requested: arrays by name, (number of vertices,) each, e.g. "distance" in mesh units
    fields: Dict[str, Array] = field(default_factory=dict)
    drawn: List[Curve] = field(default_factory=list)  #: the given curves
    #: The mesh, which is opened again only at a use; its arrays are shared, not copied. It is pickled with
    #: the result: send ``curves`` and ``reports`` alone if it is too large.
    mesh: Optional[Mesh] = None
    #: If requested: the made meshes; each is a MadeMesh if the plugin returns its origin
    meshes: List[Mesh] = field(default_factory=list)

    def __repr__(self) -> str:
        ended = f", {self.total.termination}" if self.total.termination else ""
        return f"<talweg.Result: {self.curves}{ended}>"

    @property
    def curve(self) -> Curve:
        """The only curve. :raises BadUsage: if there are several curves."""
        if len(self.curves) != 1:
            raise BadUsage(f"The result has {len(self.curves)} curves, so it has no .curve; .curves lists them.")
        return self.curves[0]

    @property
    def report(self) -> Report:
        """The report of the only curve; for several curves the total."""
        return self.reports[0] if len(self.reports) == 1 else self.total

    def show(self, **how: Any) -> Any:
        """talweg.show() of the result and its drawing on their mesh, with the same arguments."""
        from ._show import show  # pylint: disable=import-outside-toplevel,cyclic-import

        if self.mesh is None:
            raise BadUsage("The result does not know its mesh; use talweg.show(mesh, result).")
        return show(self.mesh, self, **how)

    def _repr_png_(self) -> Optional[bytes]:
        """The picture for a notebook."""
        from ._show import png  # pylint: disable=import-outside-toplevel,cyclic-import

        return png(self)


@dataclass(frozen=True, eq=False)
class Distance:
    """Distance to the nearest curve and the potential, (number of vertices,) each, mesh units."""

    distance: Floats  #: infinite where no curve can be reached
    potential: Floats  #: the lift of the surface; 0 where no curve can be reached
    distance_max: float
    potential_max: float
    slack: Tuple[float, ...]  #: the slack of each curve
