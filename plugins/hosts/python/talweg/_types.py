"""Names for type hints; nothing of them is needed while programs run."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable

ArrayLike = Any  # what numpy.asarray takes

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[Any]
    Floats = NDArray[np.float64]
    Integers = NDArray[np.int64]
else:
    Array = Floats = Integers = Any

#: (stage, fraction in [0, 1] of that stage); False to cancel
Progress = Callable[[str, float], Any]
