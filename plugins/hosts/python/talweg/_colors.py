"""Colours of a surface from numbers at its vertices or faces."""

from __future__ import annotations

import colorsys
from dataclasses import dataclass
from typing import Any, Optional, Tuple

import numpy as np

from ._attributes import Parts
from ._errors import BadUsage
from ._shading import MATERIAL
from ._types import Array, Floats

# From dark blue to yellow in perceptually even steps, without red, the colour of the drawing.
_RAMP = np.array([[0.27, 0.00, 0.33], [0.28, 0.17, 0.48], [0.23, 0.32, 0.55], [0.17, 0.45, 0.56],
                  [0.13, 0.57, 0.55], [0.16, 0.69, 0.50], [0.37, 0.79, 0.38], [0.68, 0.86, 0.19],
                  [0.99, 0.91, 0.14]])


@dataclass(frozen=True)
class Colors:
    """Colours as sRGB in [0, 1]: (n, 3) at vertices or (m, 3) at faces."""

    values: Floats
    at_faces: bool
    extent: Optional[Tuple[float, float]] = None  #: the numbers at the ends of the ramp
    name: str = ""


def ramp(values: Array) -> Floats:
    """Colours (k, 3) of the ramp for numbers in [0, 1]."""
    steps = np.linspace(0, 1, len(_RAMP))
    return np.stack([np.interp(values, steps, _RAMP[:, k]) for k in range(3)], axis=-1)


def of(given: Any, parts: Parts, vertices: int, faces: int) -> Optional[Colors]:
    """The colours for the argument ``colors`` of show().

    :raises BadUsage: for an attribute that the mesh does not have, or another shape.
    """
    if given is None:
        return None
    name = given if isinstance(given, str) else ""
    if name:
        at_faces = name not in parts.vertex_attributes
        given = parts.face_attributes.get(name) if at_faces else parts.vertex_attributes[name]
        if given is None:
            known = ", ".join([*parts.vertex_attributes, *parts.face_attributes]) or "none"
            raise BadUsage(f"The mesh has no attribute {name} at vertices or faces; it has {known}.")
    values = np.asarray(given)
    if not name:
        at_faces = len(values) == faces != vertices if values.ndim > 0 else False
    if (values.ndim not in (1, 2) or len(values) != (faces if at_faces else vertices)
            or values.ndim == 2 and values.shape[1] not in (3, 4) or values.dtype.kind not in "biuf"):
        raise BadUsage("colors must be the name of an attribute, or numbers or colours for "
                       f"{vertices} vertices or {faces} faces, not {values.dtype} {values.shape}.")
    if values.ndim == 2:
        scale = 255 if values.dtype.kind in "iu" else 1
        return Colors(np.clip(np.nan_to_num(values[:, :3] / scale), 0, 1), at_faces, name=name)
    if values.dtype.kind == "f":
        return _on_ramp(values, at_faces, name)
    kinds, number = np.unique(values, return_inverse=True)
    return Colors(np.array([_of_label(int(kind)) for kind in kinds])[number], at_faces, name=name)


def _on_ramp(values: Array, at_faces: bool, name: str) -> Colors:
    finite = np.isfinite(values)
    low, high = (float(values[finite].min()), float(values[finite].max())) if finite.any() else (0, 0)
    part = (np.where(finite, values, low) - low) / (high - low if high > low else 1)
    return Colors(np.where(finite[:, None], ramp(part), MATERIAL), at_faces, (low, high), name)


def _of_label(label: int) -> Tuple[float, float, float]:
    """A colour for a label, the same on every mesh. Labels with close numbers differ clearly."""
    return colorsys.hsv_to_rgb(label * 0.618033988749895 % 1, 0.38 + 0.17 * (label % 2), 0.88)
