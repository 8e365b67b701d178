"""When two evaluations of a decoder count as the same (spec/RNA.md, 8.2)."""

import numpy as np
from numpy.typing import NDArray

RELATIVE, ABSOLUTE = 1e-4, 1e-5
TIES = 0.02
"""Part of an int8 decoder's rows that may differ: sums halfway between two steps may round
either way."""


def close_rows(
    actual: NDArray[np.floating],
    expected: NDArray[np.floating],
    reach: float | NDArray[np.floating] = 1.0,
) -> NDArray[np.bool_]:
    """(n,) bool: the rows of two (n, m) transports that agree in every column.

    reach: (n,) or one for all, how large a row's queries are, 1 or more. Sums of terms so large
    that cancel leave a rounding as large.
    """
    wide = expected.astype(np.float64)
    allowed = (ABSOLUTE + RELATIVE * np.abs(wide)) * np.reshape(reach, (-1, 1))
    close = np.abs(actual.astype(np.float64) - wide) <= allowed
    rows: NDArray[np.bool_] = np.logical_and.reduce(close, axis=1)
    return rows
