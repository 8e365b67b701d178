"""Nearby light word for word as spec/RNA.md, 7.3, has it: in numpy and float64."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Float = NDArray[np.float64]


def nearby_offsets(lengths: Sequence[float], u: NDArray[np.floating]) -> tuple[Float, Float]:
    """Where the columns of an estimate stand in the plane across wi.

    u: (n, 2) from 0 to 1. Returns (n,) distances from x, and (n,) angles.
    """
    scaled = np.asarray(u[:, 0], np.float64) * len(lengths)
    k = np.minimum(scaled.astype(np.int64), len(lengths) - 1)
    rho = np.asarray(lengths, np.float64)[k] * gamma_quantile(scaled - k)
    return rho, 2.0 * np.pi * np.asarray(u[:, 1], np.float64)


def gamma_quantile(share: NDArray[np.floating]) -> Float:
    """r with 1 - (1 + r) exp(-r) = share, of the Gamma distribution of shape 2; by bisection."""
    wanted = np.log1p(-np.minimum(share, 1.0 - 2.0**-24))
    low, high = np.zeros(np.shape(share)), np.full(np.shape(share), 64.0)
    for _ in range(64):
        middle = 0.5 * (low + high)
        above = np.log1p(middle) - middle > wanted
        low, high = np.where(above, middle, low), np.where(above, high, middle)
    result: Float = 0.5 * (low + high)
    return result


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
    lengths: Sequence[float], rho: NDArray[np.floating], distance: NDArray[np.floating]
) -> Float:
    """The estimate of a column, (n, 3). distance: (n,) |x - y|; infinity where it meets nothing."""
    density = np.mean([np.exp(-rho / l) / l**2 for l in lengths], axis=0)  # noqa: E741
    return np.stack([np.exp(-distance / l) / l**2 / density for l in lengths], axis=1)  # noqa: E741
