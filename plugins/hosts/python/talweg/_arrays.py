"""Arrays across the interface: numpy's arrays are passed without a copy, the plugin's are copied once."""

from __future__ import annotations

import ctypes
from typing import Any, Tuple, Type

import numpy as np

from . import _interface as c
from ._errors import BadUsage, Error
from ._types import Array, Integers

_TYPES = {("f", 8): c.FLOAT64, ("f", 4): c.FLOAT32, ("i", 4): c.INT32, ("u", 4): c.UINT32,
          ("i", 8): c.INT64, ("u", 8): c.UINT64, ("i", 1): c.INT8, ("u", 1): c.UINT8,
          ("i", 2): c.INT16, ("u", 2): c.UINT16}
_DTYPES = {c.FLOAT64: np.float64, c.FLOAT32: np.float32, c.INT32: np.int32, c.UINT32: np.uint32,
           c.INT64: np.int64, c.UINT64: np.uint64, c.INT8: np.int8, c.UINT8: np.uint8,
           c.INT16: np.int16, c.UINT16: np.uint16}
_WIDER = {"f": np.float64, "i": np.int64, "u": np.uint64}
_LONGEST_STRIDE = 2**32


def readable(values: Any, columns: int, what: str, error: Type[Error] = BadUsage) -> Array:
    """The values as an array that the interface can read: the caller's own array wherever possible.

    A copy is made of lists, of numbers of other sizes or byte orders (float16, ...), and of arrays whose rows
    are not contiguous or run backwards.

    :param columns: 1 for shape (n,) or (n, 1), else for shape (n, columns).
    :raises error: for another shape, or for values that are not real numbers.
    """
    try:
        array = np.asarray(values)
    except ValueError:
        raise error(f"{what} cannot be made an array: its rows are not equally long.") from None
    if array.ndim == 2 and columns == 1 and array.shape[1] == 1:
        array = array[:, 0]
    expected = "(n,)" if columns == 1 else f"(n, {columns})"
    if array.ndim != (1 if columns == 1 else 2) or (columns > 1 and array.shape[1] != columns):
        raise error(f"{what} must have the shape {expected}, not {array.shape}.")
    kind = array.dtype.kind
    if kind not in _WIDER:
        raise error(f"{what} must hold numbers, not {array.dtype}.")
    if (kind, array.dtype.itemsize) not in _TYPES:
        array = array.astype(_WIDER[kind])
    elif not array.dtype.isnative:
        array = array.astype(array.dtype.newbyteorder("="))
    return array if _can_be_passed(array) else np.ascontiguousarray(array)


def _can_be_passed(array: Array) -> bool:
    size = array.dtype.itemsize
    if array.size == 0:
        return True
    if array.ndim == 2 and array.strides[1] != size:
        return False
    row = size * (array.shape[1] if array.ndim == 2 else 1)
    return len(array) == 1 or row <= array.strides[0] <= _LONGEST_STRIDE


def view(array: Array) -> c.Array:
    """The interface's view of an array from readable(); the array must outlive the view."""
    columns = array.shape[1] if array.ndim == 2 else 1
    stride = array.strides[0] if len(array) > 1 else 0
    return c.Array(array.ctypes.data, len(array), stride, columns,
                   _TYPES[array.dtype.kind, array.dtype.itemsize])


def _lent(array: c.Array) -> Array:
    """A numpy view of a plugin's array, which is dense by the rules of the interface: (n,) or (n,
    columns)."""
    dtype = np.dtype(_DTYPES[array.type])
    shape: Tuple[int, ...] = (array.rows, array.columns) if array.columns > 1 else (array.rows,)
    if array.rows == 0:
        return np.empty(shape, dtype)
    bytes_ = (ctypes.c_char * (array.rows * array.columns * dtype.itemsize)).from_address(array.data)
    return np.frombuffer(bytes_, dtype).reshape(shape)


def copied(array: c.Array) -> Array:
    """A copy of a plugin's array: (n,) or (n, columns)."""
    return _lent(array).copy()


def copied_indices(array: c.Array) -> Integers:
    """A copy of a plugin's array of indices as int64; -1 for "none"."""
    lent = _lent(array)
    if lent.dtype == np.uint32 and (lent.size == 0 or lent.view(np.int32).min() >= -1):
        return lent.view(np.int32).astype(np.int64)  # NO_VERTEX is -1 as int32: one pass over the array
    indices = lent.astype(np.int64)
    indices[indices == c.NO_VERTEX] = -1
    return indices
