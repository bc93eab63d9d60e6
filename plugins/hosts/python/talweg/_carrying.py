"""Attributes across the interface: plugins interpolate them for the meshes that they make.

The interface has attributes of 1 to 64 columns; at corners, 2 or 3 columns of real numbers. Attributes of
other widths are passed in parts and joined afterwards.
"""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, NamedTuple, Optional, Tuple

import numpy as np

from . import _arrays
from . import _interface as c
from ._attributes import Attributes
from ._errors import BadUsage
from ._instance import Instance
from ._types import Array

if TYPE_CHECKING:
    from ._mesh import Mesh

RULES = {"linear": c.CARRY_LINEAR, "rounded": c.CARRY_ROUNDED, "nearest": c.CARRY_NEAREST,
         "direction": c.CARRY_DIRECTION}
_MOST_COLUMNS, _MOST_OF_CORNERS = 64, 3
_NORMALS = ("normal", "normals")


class _Given(NamedTuple):
    element: int
    name: str
    array: Array
    parts: int  # the number of the interface's attributes that it is split into


def rule_of(name: str, array: Array, at_corners: bool) -> int:
    """The default rule for the values of new vertices, the same as the driver's for files."""
    columns = int(np.prod(array.shape[2 if at_corners else 1:]))
    if name.lower() in _NORMALS and columns == 3 and array.dtype.kind == "f":
        return c.CARRY_DIRECTION
    if at_corners:
        return c.CARRY_LINEAR
    if "label" in name.lower():
        return c.CARRY_NEAREST
    if array.dtype.kind == "f":
        return c.CARRY_LINEAR
    return c.CARRY_ROUNDED if array.dtype == np.uint8 else c.CARRY_NEAREST


def fill_of(name: str, array: Array) -> float:
    """The value on lids: white for colours, 0 for everything else."""
    if "col" not in name.lower() or array.shape[-1] not in (3, 4):
        return 0.0
    return 1.0 if array.dtype.kind == "f" else float(np.iinfo(array.dtype).max)


class Carrier:
    """Passes the attributes of a mesh to an instance, and reads those of the meshes that the instance
    makes."""

    def __init__(self, mesh: Mesh, instance: Instance, carry: Optional[Mapping[str, str]]) -> None:
        self._instance = instance
        self._given: List[_Given] = []
        self._kept: List[Any] = []
        self._views: List[c.Attribute] = []
        parts = mesh._parts()
        #: Names of the numbers of face attributes and lines of the file, which are passed on unchanged.
        self.face_names, self.references = parts.face_names, parts.references
        self.frame = parts.frame
        names = {*parts.vertex_attributes, *parts.face_attributes, *parts.corner_attributes}
        self._rules = _checked_rules(carry or {}, names)
        for element, attributes in ((c.OF_VERTICES, parts.vertex_attributes),
                                    (c.OF_TRIANGLES, parts.face_attributes),
                                    (c.OF_CORNERS, parts.corner_attributes)):
            for name, values in attributes.items():
                self._add(element, name, np.asarray(values))
        if self._views:
            pointers = (ctypes.POINTER(c.Attribute) * len(self._views))(
                *(ctypes.pointer(view) for view in self._views))
            instance.set_attributes(pointers, len(self._views))
        self._kept.clear()  # the plugin has its own copies
        self._views.clear()

    def _add(self, element: int, name: str, array: Array) -> None:
        at_corners = element == c.OF_CORNERS
        rule = self._rules.get(name) or rule_of(name, array, at_corners)
        rows = array.shape[0] * (3 if at_corners else 1)
        flat = array.reshape(rows, int(np.prod(array.shape[2 if at_corners else 1:])))
        columns = flat.shape[1]
        if columns == 0:
            return
        if at_corners:
            if flat.dtype.kind != "f":
                flat = flat.astype(np.float64)
            if columns == 1:
                flat = np.repeat(flat, 2, axis=1)  # an attribute of corners has at least two columns
        elif flat.dtype.kind == "b":
            flat = flat.view(np.uint8) if flat.flags.c_contiguous else flat.astype(np.uint8)
        groups = _groups(flat.shape[1], _MOST_OF_CORNERS if at_corners else _MOST_COLUMNS)
        self._given.append(_Given(element, name, array, len(groups)))
        for first, last in groups:
            part = name if len(groups) == 1 else f"{name}[{first}:{last}]"
            self._hand_over(element, rule, part, flat[:, first:last])

    def _hand_over(self, element: int, rule: int, name: str, values: Array) -> None:
        readable = _arrays.readable(values, values.shape[1], f"The attribute {name}")
        self._kept.append(readable)
        view = c.Attribute(size=ctypes.sizeof(c.Attribute), element=element, carry=rule,
                           name=name.encode(), fill=fill_of(name, values),
                           values=_arrays.view(readable))
        self._views.append(view)

    def of_mesh(self, number: int) -> Tuple[Attributes, Attributes, Attributes]:
        """The attributes of vertices, of faces and of corners of a mesh of the last run."""
        came: List[Tuple[int, str, Array]] = []
        self._instance.take_attributes(number, lambda one: came.append(
            (one.element, one.name.decode(), values_of(one))))
        result: Dict[int, Attributes] = {c.OF_VERTICES: {}, c.OF_TRIANGLES: {}, c.OF_CORNERS: {}}
        place = 0
        for given in self._given:
            parts = [values for _, _, values in came[place:place + given.parts]]
            place += given.parts
            result[given.element][given.name] = _put_together(given, parts)
        for element, name, values in came[place:]:  # attributes that the plugin adds itself
            result[element][name] = values
        return result[c.OF_VERTICES], result[c.OF_TRIANGLES], result[c.OF_CORNERS]


def _checked_rules(carry: Mapping[str, str], names: Any) -> Dict[str, int]:
    for name, rule in carry.items():
        if name not in names:
            raise BadUsage(f"carry names {name!r}, and the mesh has no such attribute.")
        if rule not in RULES:
            raise BadUsage(f"carry[{name!r}] must be one of {', '.join(RULES)}, not {rule!r}.")
    return {name: RULES[rule] for name, rule in carry.items()}


def _groups(columns: int, most: int) -> List[Tuple[int, int]]:
    """Ranges of at most ``most`` columns; if there are two or more columns, every range has two or more."""
    count = -(-columns // most)
    bounds = [columns * k // count for k in range(count + 1)] if count else [0]
    return list(zip(bounds[:-1], bounds[1:]))


def values_of(one: c.Attribute) -> Array:
    """Rows for vertices and for faces, (n, columns); for corners (faces, 3, columns), with NaN at corners
    without an entry, as in lids."""
    values = _arrays.copied(one.values)
    if one.element != c.OF_CORNERS:
        return values
    if not one.corners.rows:
        return values.reshape(-1, 3, one.values.columns)
    entries = _arrays.copied_indices(one.corners)
    none = np.full((1, one.values.columns), np.nan, values.dtype)
    return np.asarray(np.concatenate([values.reshape(-1, one.values.columns), none])[entries])


def _put_together(given: _Given, parts: List[Array]) -> Array:
    dtype, tail = given.array.dtype, given.array.shape[2 if given.element == c.OF_CORNERS else 1:]
    rows = parts[0].shape[:2] if given.element == c.OF_CORNERS else parts[0].shape[:1]
    joined = np.concatenate([part.reshape(*rows, -1) for part in parts], axis=-1)
    joined = joined[..., :int(np.prod(tail))]
    if given.element == c.OF_CORNERS and dtype.kind != "f":
        joined = np.rint(np.nan_to_num(joined))
    return np.asarray(joined.reshape(*rows, *tail).astype(dtype, copy=False))
