"""What comes out: curves, fields and reports."""

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
    """What was done and measured: the names and units of docs/driver.md, "The report".

    Lengths in mesh units, angles in radians, times in ms, memory in MiB. "Before" and "drawn" are
    the curve as it was given. None: a plugin that does not measure it.
    """

    version: Optional[str] = None
    faces: Optional[int] = None
    vertices: Optional[int] = None
    tau: Optional[float] = None
    slack: Optional[float] = None
    slack_from: Optional[str] = None  #: "trembling", "edges", "segments", "given" or "none"
    left_out: Optional[int] = None  #: points of strokes that say nothing beside others
    left_out_max: Optional[float] = None  #: how far they lie from what was smoothed
    max_deviation: Optional[float] = None
    ridge_strength: Optional[float] = None  #: the next ones are there only if it is above 0
    ridge_band: Optional[float] = None
    ridge_moved: Optional[float] = None  #: [0, 1]: the part of the drawing that was moved onto ridges
    ridge_moved_max: Optional[float] = None
    ridge_already: Optional[float] = None  #: [0, 1]: the part that lay on ridges as it was drawn
    ridge_clicks_moved: Optional[int] = None
    ridge_clicks_moved_max: Optional[float] = None
    pins_added: Optional[int] = None
    edge_length_near: Optional[float] = None
    roughness_near: Optional[float] = None  #: of the mesh along the drawing, in edge_length_near
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
    window_turning_2_before: Optional[float] = None  #: in two
    window_turning_2_after: Optional[float] = None
    deviation: Optional[str] = None  #: which distance the next ones are: "surface", "euclidean", "none"
    deviation_to_drawn_max: Optional[float] = None
    deviation_to_drawn_mean: Optional[float] = None
    deviation_from_drawn_max: Optional[float] = None
    deviation_from_drawn_mean: Optional[float] = None
    deviation_at: Optional[Tuple[float, ...]] = None  #: (3,), where the largest is
    deviation_exact: Optional[bool] = None  #: False: a budget was used up; the above are upper bounds
    deviation_at_least: Optional[float] = None  #: the largest distance known
    missed_points: Optional[int] = None  #: that the result was to pass
    missed_max: Optional[float] = None  #: through space
    missed_at: Optional[Tuple[float, ...]] = None  #: (3,), of the farthest
    farthest: Optional[float] = None  #: result and drawing apart, either way, or a point that is missed; at least
    farthest_at_most: Optional[float] = None  #: the same where that is exact, infinite where nothing is known
    farthest_at: Optional[Tuple[float, ...]] = None  #: (3,)
    farthest_of: Optional[str] = None  #: what is farthest: "result", "drawing", "point", "none"
    moved: Optional[float] = None
    flips: Optional[int] = None
    iterations: Optional[int] = None
    faces_touched: Optional[int] = None
    trace_fallbacks: Optional[int] = None
    stretches_redrawn: Optional[int] = None  #: 0: a fair curve starts from the whole drawing
    mollification: Optional[float] = None  #: most that an edge was lengthened for the paper's distance
    crossings_before: Optional[int] = None
    crossings_after: Optional[int] = None
    termination: Optional[str] = None  #: "converged", "missed", "collapsed", "limit"
    warnings: Tuple[str, ...] = ()
    decisive: Tuple[str, ...] = ()  #: those of them by which a result may be of no use
    decisive_at: Tuple[float, ...] = ()  #: x, y and z of the place of each; infinite where it has none
    time_ms: Dict[str, float] = field(default_factory=dict)
    peak_memory_mib: Optional[float] = None
    #: Entries under any other name, e.g. of somebody else's plugin
    more: Dict[str, Any] = field(default_factory=dict)

    def __str__(self) -> str:
        named = ((f.name, getattr(self, f.name)) for f in fields(self))
        return "\n".join(f"{name}: {value}" for name, value in named if value not in (None, (), {}))


_NAMES = {f.name for f in fields(Report)} - {"time_ms", "more"}


def value_of(entry: c.ReportEntry) -> Any:
    """A value, or a tuple of them: float, int, bool or str."""
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
    """What a run gives."""

    curves: List[Curve]  #: one for each given curve, in their order
    reports: List[Report]  #: one for each curve
    total: Report  #: of all curves together
    #: If asked for: (number of vertices,) each, e.g. "distance" in mesh units
    fields: Dict[str, Array] = field(default_factory=dict)
    drawn: List[Curve] = field(default_factory=list)  #: the curves as they were given
    #: The mesh, opened again only if it is used; its arrays are shared, not copied. It is pickled with
    #: the result: send ``curves`` and ``reports`` instead where that is too much.
    mesh: Optional[Mesh] = None
    #: If asked for: those that were made; each a MadeMesh if the plugin tells where they come from
    meshes: List[Mesh] = field(default_factory=list)

    def __repr__(self) -> str:
        ended = f", {self.total.termination}" if self.total.termination else ""
        return f"<talweg.Result: {self.curves}{ended}>"

    @property
    def curve(self) -> Curve:
        """The only curve. :raises BadUsage: if there are several."""
        if len(self.curves) != 1:
            raise BadUsage(f"There are {len(self.curves)} curves; ask for .curves.")
        return self.curves[0]

    @property
    def report(self) -> Report:
        """The only curve's report; of several curves the total."""
        return self.reports[0] if len(self.reports) == 1 else self.total

    def show(self, **how: Any) -> Any:
        """talweg.show() of the result and its drawing on their mesh; ``how`` as there."""
        from ._show import show  # pylint: disable=import-outside-toplevel,cyclic-import

        if self.mesh is None:
            raise BadUsage("The result does not know its mesh; use talweg.show(mesh, result).")
        return show(self.mesh, self, **how)

    def _repr_png_(self) -> Optional[bytes]:
        """What a notebook shows."""
        from ._show import png  # pylint: disable=import-outside-toplevel,cyclic-import

        return png(self)


@dataclass(frozen=True, eq=False)
class Distance:
    """Distance to curves and the potential over it, (number of vertices,) each, mesh units."""

    distance: Floats  #: infinite where no curve can be reached
    potential: Floats  #: by how much the surface is lifted; 0 where no curve can be reached
    distance_max: float
    potential_max: float
    slack: Tuple[float, ...]  #: of each curve
