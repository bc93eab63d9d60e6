"""Names for type hints, which programs do not need at run time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable

ArrayLike = Any  # any argument of numpy.asarray

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[Any]
    Floats = NDArray[np.float64]
    Integers = NDArray[np.int64]
else:
    Array = Floats = Integers = Any

#: (stage, fraction in [0, 1] of the stage); False cancels
Progress = Callable[[str, float], Any]
