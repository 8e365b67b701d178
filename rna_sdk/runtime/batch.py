"""The arrays of one evaluation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Rows = NDArray[np.float32]


@dataclass(frozen=True)
class Batch:
    """Each (n, 3) float32 but for h; the results are written.

    Attributes:
        axes: normals of a surface, tangents of fibers.
        h: (n,) float32, offsets across fibers; (0,) for a surface, which has none.
        results: three columns of the decoder's output each: visible and shadowed, or emission.
    """

    positions: Rows
    axes: Rows
    h: Rows
    wo: Rows
    wi: Rows
    results: tuple[Rows, ...]
