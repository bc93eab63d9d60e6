"""Attributes of meshes: arrays by name, with a row for each vertex, face or corner of a face."""

from __future__ import annotations

from typing import Any, Dict, Mapping, NamedTuple, Sequence, Tuple

import numpy as np

from ._errors import BadUsage
from ._types import Array, ArrayLike

Attributes = Dict[str, Array]


class Parts(NamedTuple):
    """A mesh as plain lists, from any package, unchecked."""

    vertices: Any
    faces: Any
    vertex_attributes: Mapping[str, ArrayLike] = {}
    face_attributes: Mapping[str, ArrayLike] = {}
    corner_attributes: Mapping[str, ArrayLike] = {}
    face_names: Mapping[str, Sequence[str]] = {}
    references: Sequence[str] = ()
    frame: str = ""


def checked(given: Mapping[str, ArrayLike], rows: Tuple[int, ...], what: str) -> Attributes:
    """The attributes as arrays of numbers, without a copy.

    :param rows: the beginning of their shapes: (vertices,), (faces,) or (faces, 3).
    :param what: "vertex", "face" or "corner".
    :raises BadUsage: for another shape, or values that are not numbers; the sentence names the attribute.
    """
    result: Attributes = {}
    for name, values in given.items():
        if not isinstance(name, str) or not name:
            raise BadUsage(f"The name of a {what} attribute must be a text, not {name!r}.")
        try:
            array = np.asarray(values)
        except ValueError:
            raise BadUsage(f"The {what} attribute {name} cannot be made an array: its rows are not "
                           "equally long.") from None
        if array.dtype.kind not in "biuf":
            raise BadUsage(f"The {what} attribute {name} must hold numbers, not {array.dtype}.")
        if array.shape[:len(rows)] != rows:
            expected = ", ".join(map(str, rows))
            raise BadUsage(f"The {what} attribute {name} must have the shape ({expected}, ...), not "
                           f"{array.shape}.")
        result[name] = array
    return result


def of_numbers(given: Mapping[str, ArrayLike]) -> Attributes:
    """The numeric attributes of another package's mesh, which may have texts and objects, too."""
    arrays = {name: np.asarray(values) for name, values in given.items()}
    return {name: array for name, array in arrays.items() if array.dtype.kind in "biuf"}
