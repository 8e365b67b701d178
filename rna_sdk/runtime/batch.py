"""The arrays of one evaluation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Rows = NDArray[np.float32]


@dataclass(frozen=True)
class Batch:
    """Each (n, 3) float32 but for h; the last two are written.

    Attributes:
        axes: normals of a surface, tangents of fibers.
        h: (n,) float32, offsets across fibers; (0,) for a surface, which has none.
    """

    positions: Rows
    axes: Rows
    h: Rows
    wo: Rows
    wi: Rows
    visible: Rows
    shadowed: Rows
