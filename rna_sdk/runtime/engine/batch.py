"""The arrays of one evaluation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Rows = NDArray[np.float32]


@dataclass(frozen=True)
class Batch:
    """Arguments and results; each (n, 3) float32 except h.

    Attributes:
        axes: normals of a surface, tangents of fibers.
        h: (n,) float32, offsets across fibers; (0,) for a surface, which has none.
        results: written by the evaluation: visible and shadowed, or emission.
    """

    positions: Rows
    axes: Rows
    h: Rows
    wo: Rows
    wi: Rows
    results: tuple[Rows, ...]
