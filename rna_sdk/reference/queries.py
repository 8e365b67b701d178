"""Decoder inputs in plain numpy: the twin of `kernels/query_kernel.py`, for tests and for readers.

The formulas of `spec/RNA.md`, "Input blocks", written as they are; in float64, rounded to
float32 at the end.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

# spec/RNA.md, "Input blocks": index of refraction of fibers, and how far features bend a normal.
ETA = 1.55
BEND = 0.1

Float = NDArray[np.float64]
Blocks = dict[str, Callable[[], Float]]


def queries_reference(
    planes: NDArray[np.floating],
    bounds: NDArray[np.floating],
    inputs: tuple[str, ...],
    positions: NDArray[np.floating],
    normals: NDArray[np.floating],
    wo: NDArray[np.floating],
    wi: NDArray[np.floating],
    of_lobes: bool = False,
) -> NDArray[np.float32]:
    """(n, K) float32: the blocks named in `inputs`, side by side, for points of a surface.

    planes: (3, R, R, C); bounds: (2, 3) lower and upper corner; positions, normals, wo, wi:
    (n, 3), finite, object space, directions of any length but zero. of_lobes: wi is the mirror
    direction of wo, and the half vector is n.
    """
    n, o, i = unit(normals), unit(wo), unit(wi)
    m = n if of_lobes else _halfway(o, i)
    blocks: Blocks = {
        **_common_blocks(planes, bounds, positions, o, i),
        "normal": lambda: n,
        "half_vector": lambda: _half_vector(n, o, i, m),
        "highlight": lambda: _highlight(n, m),
    }
    blocks["learned_normal"] = lambda: _learned_normal(n, blocks["features"](), m)
    return _joined(blocks, inputs)


def fiber_queries_reference(
    planes: NDArray[np.floating],
    bounds: NDArray[np.floating],
    inputs: tuple[str, ...],
    positions: NDArray[np.floating],
    tangents: NDArray[np.floating],
    h: NDArray[np.floating],
    wo: NDArray[np.floating],
    wi: NDArray[np.floating],
) -> NDArray[np.float32]:
    """(n, K) float32: the blocks named in `inputs`, side by side, for points of fibers.

    h: (n,), finite; the others as in `queries_reference`.
    """
    t, o, i = unit(tangents), unit(wo), unit(wi)
    offset = np.clip(np.asarray(h, np.float64), -1, 1)
    blocks: Blocks = {
        **_common_blocks(planes, bounds, positions, o, i),
        "tangent": lambda: t,
        "h": lambda: offset[:, None],
        "fiber_angles": lambda: _fiber_angles(t, o, i),
        "fiber_lobes": lambda: _fiber_lobes(t, offset, o, i),
    }
    return _joined(blocks, inputs)


def _common_blocks(
    planes: NDArray[np.floating],
    bounds: NDArray[np.floating],
    positions: NDArray[np.floating],
    wo: Float,
    wi: Float,
) -> Blocks:
    low, high = np.asarray(bounds, np.float64)
    p = np.clip((np.asarray(positions, np.float64) - low) / (high - low), 0, 1)
    return {
        "features": lambda: triplane_features(planes, p),
        "position": lambda: 2 * p - 1,
        "wo": lambda: wo,
        "wi": lambda: wi,
    }


def _joined(blocks: Blocks, inputs: tuple[str, ...]) -> NDArray[np.float32]:
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


def _half_vector(n: Float, wo: Float, wi: Float, m: Float) -> Float:
    """(n, 5): n.m, log2(1 - min(n.m, 1) + 1e-4) / 6, n.wi, n.wo, wi.m."""
    return np.stack([*_along(n, m), _dot(n, wi), _dot(n, wo), _dot(wi, m)], axis=1)


def _along(n: Float, m: Float) -> tuple[Float, Float]:
    """n.m, log2(1 - min(n.m, 1) + 1e-4) / 6."""
    cosine = _dot(n, m)
    return cosine, np.log2(1 - np.minimum(cosine, 1) + 1e-4) / 6


def _learned_normal(n: Float, features: Float, m: Float) -> Float:
    """(n, 2): q.m, log2(1 - min(q.m, 1) + 1e-4) / 6, with q along n + 0.1 (f0, f1, f2)."""
    bend = np.zeros((len(features), 3))
    bend[:, : features.shape[1]] = features[:, :3]
    q = n + BEND * bend
    length = np.linalg.norm(q, axis=1, keepdims=True)
    nothing = length < 1e-6
    q = np.where(nothing, n, q / np.where(nothing, 1, length))
    return np.stack(_along(q, m), axis=1)


def _highlight(n: Float, m: Float) -> Float:
    """(n, 1): log2(|n x m|^2 + 1e-8) / 12, and 0 of opposite directions."""
    aside = np.where(m.any(axis=1), np.linalg.norm(np.cross(n, m), axis=1), 1)
    return np.log2(aside**2 + 1e-8)[:, None] / 12


def _halfway(wo: Float, wi: Float) -> Float:
    """m, unit; 0 where directions are opposite, whose m is across n, q and wi."""
    m = wi + wo
    length = np.linalg.norm(m, axis=1, keepdims=True)
    opposite = length < 1e-6
    return np.where(opposite, 0, m / np.where(opposite, 1, length))


def _fiber_angles(t: Float, wo: Float, wi: Float) -> Float:
    """(n, 6): s_i, s_o, s_i + s_o, log2((s_i + s_o)^2 + 1e-3) / 6, cos phi, sin phi."""
    s_o, s_i = _dot(t, wo), _dot(t, wi)
    log_cone = np.log2((s_i + s_o) ** 2 + 1e-3) / 6
    return np.stack([s_i, s_o, s_i + s_o, log_cone, *_azimuth(t, wo, wi)], axis=1)


def _azimuth(t: Float, wo: Float, wi: Float) -> tuple[Float, Float]:
    """Cosine and sine of phi, the angle around t from wo to wi."""
    s_o, s_i = _dot(t, wo), _dot(t, wi)
    d = _cosine(s_o) * _cosine(s_i)
    along = d < 1e-6
    d = np.where(along, 1, d)
    cos_phi = np.clip((_dot(wo, wi) - s_o * s_i) / d, -1, 1)
    sin_phi = np.clip(_dot(t, np.cross(wo, wi)) / d, -1, 1)
    return np.where(along, 1, cos_phi), np.where(along, 0, sin_phi)


def _fiber_lobes(t: Float, h: Float, wo: Float, wi: Float) -> Float:
    """(n, 3): cos(phi - Phi_p) for p = 0, 1, 2, with Phi_p = 2 g_o - 2 p g_t - p pi."""
    s_o = _dot(t, wo)
    g_o = np.arcsin(h)
    g_t = np.arcsin(h * _cosine(s_o) / np.sqrt(ETA**2 - s_o**2))
    cos_phi, sin_phi = _azimuth(t, wo, wi)
    lobes = [2 * g_o - 2 * p * g_t - p * np.pi for p in range(3)]
    return np.stack([cos_phi * np.cos(a) + sin_phi * np.sin(a) for a in lobes], axis=1)


def _cosine(sine: Float) -> Float:
    """Cosine of an angle within 90 degrees."""
    return np.sqrt(np.maximum(0, 1 - sine**2))


def _dot(a: Float, b: Float) -> Float:
    result: Float = np.sum(a * b, axis=1)
    return result


def unit(vectors: NDArray[np.floating]) -> Float:
    wide = np.asarray(vectors, np.float64)
    result: Float = wide / np.linalg.norm(wide, axis=1, keepdims=True)
    return result
