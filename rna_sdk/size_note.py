"""Whether an asset's size looks like another unit than metres."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_LARGE = 10.0
"""Metres. A phone in millimetres, a fox, a chair and a person in centimetres are beyond it."""


def size_note(low: NDArray[np.float32], high: NDArray[np.float32]) -> str | None:
    """A line about an asset that may be in centimetres; None for one of usual size.

    low, high: (3,) corners of its box, metres.
    """
    largest = float((high - low).max())
    if largest < _LARGE:
        return None
    return (
        f"the asset is {largest:.4g} m in size, {largest / 100:.3g} m if its source is in "
        "centimetres: then scale the source, or place it with transform: {scale: 0.01}"
    )
