"""Nearby light (spec/RNA.md, 7.3): the light that enters an asset beside a point, by distance.

An estimate takes one ray, along a column of light that stands beside the point in the plane across
the light's direction. `tests/reference/nearby.py` says the same in numpy.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from rna_sdk.machine.compiled import compiled
from rna_trace.vectors import along, vector_at

if TYPE_CHECKING:
    from rna_trace.parts_scene import PartsScene

# How far columns stand beside x: the log-logistic distribution of this median, times the geometric
# mean of the outer lengths, and of this shape. It was fitted to the noise of pictures.
_OF_LENGTHS, _SHAPE = 1.2, 1.5
_LEAST = 2.0**-24  # of a random number
_FAR = 2.0  # times the diagonal of the asset: where columns of distant light begin
_CHUNK = 1 << 17  # rows at a time

R2 = 1.0 / np.array([1.32471795724474602596, 1.32471795724474602596**2])
"""Two steps whose multiples fill the square evenly, by the two-dimensional golden ratio: M.
Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018."""


def nearby_estimate(
    scene: PartsScene,
    lengths: Sequence[float],
    x: np.ndarray,
    wi: np.ndarray,
    u: np.ndarray,
    distance: np.ndarray | float = np.inf,
) -> np.ndarray:
    """An unbiased estimate of nearby light by one ray for each point: (n, 3) float32.

    x, wi: (n, 3) float32 in the scene's space, wi unit. u: (n, 2) in [0, 1), any well spread
    points. distance: of the light.
    """
    shares = np.zeros((len(x), len(lengths)), np.float32)
    _add_estimate(scene, np.array(lengths, np.float64), x, wi, u, distance, shares)
    return shares


def nearby_light(
    scene: PartsScene,
    lengths: Sequence[float],
    x: np.ndarray,
    wi: np.ndarray,
    rays: int,
    seed: int = 0,
) -> np.ndarray:
    """Nearby light of a distant light, the mean of estimates by so many rays: (n, 3) float32."""
    rng, every = np.random.default_rng(seed), np.array(lengths, np.float64)
    result = np.zeros((len(x), len(lengths)), np.float32)
    for first in range(0, len(x), _CHUNK):
        rows = slice(first, first + _CHUNK)
        points, towards = np.ascontiguousarray(x[rows]), np.ascontiguousarray(wi[rows])
        shift = rng.random((len(points), 2))
        for ray in range(rays):
            u = (shift + ray * R2) % 1.0
            _add_estimate(scene, every, points, towards, u, np.inf, result[rows])
    result /= np.float32(rays)
    return result


def _add_estimate(
    scene: PartsScene,
    lengths: np.ndarray,
    x: np.ndarray,
    wi: np.ndarray,
    u: np.ndarray,
    distance: np.ndarray | float,
    shares: np.ndarray,
) -> None:
    """`nearby_estimate`, added to `shares`, (n, 3) float32."""
    reach = np.minimum(distance, np.float32(_FAR * scene.diagonal), dtype=np.float32)
    reach = np.broadcast_to(reach, len(x))
    origin, rho = np.empty_like(x), np.empty(len(x))
    column_rays(x, wi, u, lengths, np.ascontiguousarray(reach), origin, rho)
    column_shares(u, rho, reach - scene.first_opaque(origin, -wi), lengths, shares)


@compiled(rows="x wi u reach origin rho", fastmath=())
def column_rays(
    x: np.ndarray,
    wi: np.ndarray,
    u: np.ndarray,
    lengths: np.ndarray,
    reach: np.ndarray,
    origin: np.ndarray,
    rho: np.ndarray,
) -> None:
    """Where the columns of an estimate begin, (n, 3) float32, and how far beside x they stand.

    x, wi: (n, 3) float32, wi of unit length. u: (n, 2) from 0 to 1. lengths: (3,) float64. reach:
    (n,) float32, how far along wi they begin.
    """
    median = _OF_LENGTHS * np.sqrt(lengths[0] * lengths[-1])
    for i in range(len(x)):
        share = _inside(u[i, 0])
        radius = median * (share / (1.0 - share)) ** (1.0 / _SHAPE)
        angle = 2.0 * np.pi * u[i, 1]
        side = radius * np.cos(angle), radius * np.sin(angle)
        offset = along(vector_at(wi, i), side[0], side[1], np.float64(reach[i]))
        for axis in range(3):
            origin[i, axis] = x[i, axis] + offset[axis]
        rho[i] = radius


@compiled(rows="u rho height shares", fastmath=())
def column_shares(
    u: np.ndarray, rho: np.ndarray, height: np.ndarray, lengths: np.ndarray, shares: np.ndarray
) -> None:
    """The estimate of each column, added to (n, 3) float32.

    u: as for `column_rays`. rho: (n,) how far it stands beside x. height: (n,) where it meets the
    asset, along wi from x; not finite where it meets nothing.
    """
    for i in range(len(rho)):
        if np.isfinite(height[i]):
            share = _inside(u[i, 0])
            distance = np.sqrt(rho[i] * rho[i] + height[i] * height[i])
            density = _SHAPE * share * (1.0 - share)
            for k in range(len(lengths)):
                beside = rho[i] / lengths[k]
                shares[i, k] += np.exp(-distance / lengths[k]) * beside * beside / density


@compiled(inline=True, fastmath=())
def _inside(share: float) -> float:
    return float(min(max(share, _LEAST), 1.0 - _LEAST))
