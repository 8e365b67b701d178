"""Whether an asset's size looks like another unit than metres."""

import numpy as np
from numpy.typing import NDArray

_LARGE = 10.0
"""Metres. A phone in millimetres, a fox, a chair and a person in centimetres are beyond it."""


def metres(length: float) -> str:
    """A length of three digits without an exponent: "5,000,000 m", "2 m", "0.0305 m"."""
    rounded = float(f"{length:.3g}")
    return f"{rounded:,.0f} m" if rounded >= 100.0 else f"{rounded:.3g} m"


def size_note(low: NDArray[np.float32], high: NDArray[np.float32]) -> str | None:
    """A line about an asset that may be in centimetres; None for one of usual size.

    low, high: (3,) corners of its box, metres.
    """
    largest = float((high - low).max())
    if largest < _LARGE:
        return None
    return (
        f"the asset is {metres(largest)} in size, {metres(largest / 100)} if its source is in "
        "centimetres: then scale the source, or place it with transform: {scale: 0.01}"
    )
