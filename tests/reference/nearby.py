"""Nearby light word for word as spec/RNA.md, 7.3, has it: in numpy and float64."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Float = NDArray[np.float64]


def nearby_offsets(lengths: Sequence[float], u: NDArray[np.floating]) -> tuple[Float, Float]:
    """Where the columns of an estimate stand in the plane across wi.

    u: (n, 2) from 0 to 1. Returns (n,) distances from x, and (n,) angles.
    """
    share = inside(u[:, 0])
    rho = 1.2 * np.sqrt(lengths[0] * lengths[2]) * (share / (1.0 - share)) ** (2.0 / 3.0)
    return rho, 2.0 * np.pi * np.asarray(u[:, 1], np.float64)


def inside(share: NDArray[np.floating]) -> Float:
    """Random numbers (n,), as far from 0 and 1 as readers keep them."""
    return np.clip(np.asarray(share, np.float64), 2.0**-24, 1.0 - 2.0**-24)


def across(wi: NDArray[np.floating]) -> tuple[Float, Float]:
    """Two unit vectors (n, 3) across unit ones and across each other, which turn to the right.

    Duff et al., "Building an Orthonormal Basis, Revisited", 2017.
    """
    x, y, z = np.asarray(wi, np.float64).T
    sign = np.where(z >= 0.0, 1.0, -1.0)
    a = -1.0 / (sign + z)
    b = x * y * a
    first = np.stack([1.0 + sign * x * x * a, sign * b, -sign * x], axis=1)
    return first, np.stack([b, sign + y * y * a, -y], axis=1)


def nearby_shares(
    lengths: Sequence[float],
    u: NDArray[np.floating],
    rho: NDArray[np.floating],
    distance: NDArray[np.floating],
) -> Float:
    """The estimate of a column, (n, 3).

    u, rho: as for `nearby_offsets`. distance: (n,) |x - y|; infinity where it meets nothing.
    """
    density = 1.5 * inside(u[:, 0]) * (1.0 - inside(u[:, 0]))
    shares = [np.exp(-distance / length) * (rho / length) ** 2 for length in lengths]
    return np.stack(shares, axis=1) / density[:, None]
