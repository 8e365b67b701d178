"""Real spherical harmonics up to degree 3."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def harmonics(directions: NDArray[np.floating]) -> NDArray[np.float32]:
    """All 16 of them, orthonormal, in unit directions (n, 3): (n, 16) float32."""
    x, y, z = np.asarray(directions, np.float64).T
    terms = [
        (1.0, np.ones_like(x)),
        (3.0, y),
        (3.0, z),
        (3.0, x),
        (15.0, x * y),
        (15.0, y * z),
        (5.0 / 4.0, 3 * z * z - 1),
        (15.0, x * z),
        (15.0 / 4.0, x * x - y * y),
        (35.0 / 8.0, y * (3 * x * x - y * y)),
        (105.0, x * y * z),
        (21.0 / 8.0, y * (5 * z * z - 1)),
        (7.0 / 4.0, z * (5 * z * z - 3)),
        (21.0 / 8.0, x * (5 * z * z - 1)),
        (105.0 / 4.0, z * (x * x - y * y)),
        (35.0 / 8.0, x * (x * x - 3 * y * y)),
    ]
    columns = [np.sqrt(factor / (4 * np.pi)) * term for factor, term in terms]
    return np.stack(columns, axis=1).astype(np.float32)
