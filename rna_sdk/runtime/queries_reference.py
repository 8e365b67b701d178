"""Decoder inputs in plain numpy: the twin of `query_kernel.py`, for tests and for readers.

The formulas of `spec/RNA-1.0.md`, "Input blocks", written as they are; in float64, rounded to
float32 at the end.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Float = NDArray[np.float64]


def queries_reference(
    planes: NDArray[np.floating],
    bounds: NDArray[np.floating],
    inputs: tuple[str, ...],
    positions: NDArray[np.floating],
    normals: NDArray[np.floating],
    wo: NDArray[np.floating],
    wi: NDArray[np.floating],
) -> NDArray[np.float32]:
    """(n, K) float32: the blocks named in `inputs`, side by side.

    planes: (3, R, R, C); bounds: (2, 3) lower and upper corner; positions, normals, wo, wi:
    (n, 3), finite, object space, directions of any length but zero.
    """
    low, high = np.asarray(bounds, np.float64)
    p = np.clip((np.asarray(positions, np.float64) - low) / (high - low), 0, 1)
    n, o, i = _unit(normals), _unit(wo), _unit(wi)
    blocks: dict[str, Callable[[], Float]] = {
        "features": lambda: triplane_features(planes, p),
        "position": lambda: 2 * p - 1,
        "normal": lambda: n,
        "wo": lambda: o,
        "wi": lambda: i,
        "half_vector": lambda: _half_vector(n, o, i),
    }
    return np.concatenate([blocks[name]() for name in inputs], axis=1).astype(np.float32)


def triplane_features(planes: NDArray[np.floating], p: Float) -> Float:
    """(n, C): bilinear samples of the XY, YZ and ZX planes at p, (n, 3) in [0, 1], summed."""
    x, y, z = p.T
    pairs = ((x, y), (y, z), (z, x))
    total = np.zeros((len(p), planes.shape[-1]))
    for plane, (u, v) in zip(planes, pairs, strict=True):
        total += _bilinear(plane, u, v)
    return total


def _bilinear(plane: NDArray[np.floating], u: Float, v: Float) -> Float:
    """plane[row of v][column of u] at u, v in [0, 1]; texel k is centred at (k + 0.5) / R."""
    size = len(plane)
    column, row = (np.clip(t * size - 0.5, 0, size - 1) for t in (u, v))
    column0, row0 = (np.floor(t).astype(np.int64) for t in (column, row))
    column1, row1 = (np.minimum(t + 1, size - 1) for t in (column0, row0))
    fu, fv = (column - column0)[:, None], (row - row0)[:, None]
    texels = plane.astype(np.float64)
    lower = (1 - fu) * texels[row0, column0] + fu * texels[row0, column1]
    upper = (1 - fu) * texels[row1, column0] + fu * texels[row1, column1]
    result: Float = (1 - fv) * lower + fv * upper
    return result


def _half_vector(n: Float, wo: Float, wi: Float) -> Float:
    """(n, 5): n.h, log2(1 - min(n.h, 1) + 1e-4) / 6, n.wi, n.wo, wi.h."""
    h = wi + wo
    length = np.linalg.norm(h, axis=1, keepdims=True)
    opposite = length < 1e-6
    h = np.where(opposite, n, h / np.where(opposite, 1, length))
    n_h = _dot(n, h)
    log_gap = np.log2(1 - np.minimum(n_h, 1) + 1e-4) / 6
    return np.stack([n_h, log_gap, _dot(n, wi), _dot(n, wo), _dot(wi, h)], axis=1)


def _dot(a: Float, b: Float) -> Float:
    result: Float = np.sum(a * b, axis=1)
    return result


def _unit(vectors: NDArray[np.floating]) -> Float:
    wide = np.asarray(vectors, np.float64)
    result: Float = wide / np.linalg.norm(wide, axis=1, keepdims=True)
    return result
