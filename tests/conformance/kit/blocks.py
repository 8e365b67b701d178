"""Decoder inputs in float64: spec/RNA.md, 5 and 6.3, formula by formula.

Directions come in as float32 and are normalised here.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from rna_sdk.package.decoder.query_arrays import in_order

ETA = 1.55


@dataclass(frozen=True)
class Points:
    """Finite queries (n, ...), float64: p in [0, 1]; axis (normal or tangent), wo, wi unit; h."""

    p: np.ndarray
    axis: np.ndarray
    h: np.ndarray
    wo: np.ndarray
    wi: np.ndarray

    @classmethod
    def of(cls, arrays: dict[str, np.ndarray], bounds: np.ndarray) -> "Points":
        """arrays: of queries, rows that are valid. bounds: (2, 3) float64."""
        position, axis, h, wo, wi = (rows.astype(np.float64) for rows in in_order(arrays))
        p = np.clip((position - bounds[0]) / (bounds[1] - bounds[0]), 0, 1)
        return cls(p, unit(axis), np.clip(h, -1, 1), unit(wo), unit(wi))

    def rounded(self, rng: np.random.Generator) -> "Points":
        """As a reader has them who rounds to float32: components moved by one unit, either way."""
        p = np.clip(_moved(self.p, rng, 1), 0, 1)
        axis, wo, wi = (unit(_moved(v, rng, 1)) for v in (self.axis, self.wo, self.wi))
        return Points(p, axis, self.h, wo, wi)


def _moved(values: np.ndarray, rng: np.random.Generator, units: float) -> np.ndarray:
    """values, each moved by so many units in the last place of float32, up or down."""
    step = np.spacing(np.abs(values).astype(np.float32)).astype(np.float64)
    return values + units * rng.choice([-1.0, 1.0], values.shape) * step


def moved_blocks(blocks: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Blocks, each value moved by two units in the last place of float32, up or down."""
    return _moved(blocks, rng, 2)


def decoder_inputs(
    points: Points, inputs: tuple[str, ...], planes: np.ndarray, of_lobes: bool = False
) -> np.ndarray:
    """(n, K) float64: the blocks named in `inputs`; planes: (3, R, R, C) float64, decoded.

    of_lobes: the half vector is the normal, 12.1.
    """
    features = triplane(planes, points.p)
    n, wo, wi = points.axis, points.wo, points.wi
    m = n if of_lobes else halfway(wo, wi)
    made: dict[str, Callable[[], np.ndarray]] = {
        "features": lambda: features,
        "position": lambda: 2 * points.p - 1,
        "normal": lambda: n,
        "tangent": lambda: n,
        "h": lambda: points.h[:, None],
        "wo": lambda: wo,
        "wi": lambda: wi,
        "half_vector": lambda: half_vector(n, wo, wi, m),
        "highlight": lambda: highlight(n, m),
        "learned_normal": lambda: learned_normal(n, features, m),
        "fiber_angles": lambda: fiber_angles(n, wo, wi),
        "fiber_lobes": lambda: fiber_lobes(n, points.h, wo, wi),
    }
    return np.concatenate([made[name]() for name in inputs], axis=1)


def triplane(planes: np.ndarray, p: np.ndarray) -> np.ndarray:
    """(n, C): section 5."""
    size, total = planes.shape[1], 0.0
    for plane, (u, v) in zip(planes, ((0, 1), (1, 2), (2, 0)), strict=True):
        s = np.clip(p[:, u] * size - 0.5, 0, size - 1)
        t = np.clip(p[:, v] * size - 0.5, 0, size - 1)
        i, j = np.floor(s).astype(int), np.floor(t).astype(int)
        a, b = (s - i)[:, None], (t - j)[:, None]
        i1, j1 = np.minimum(i + 1, size - 1), np.minimum(j + 1, size - 1)
        near = (1 - a) * plane[j, i] + a * plane[j, i1]
        far = (1 - a) * plane[j1, i] + a * plane[j1, i1]
        total = total + (1 - b) * near + b * far
    return total


def halfway(wo: np.ndarray, wi: np.ndarray) -> np.ndarray:
    """m; NaN where directions are opposite."""
    total = wi + wo
    opposite = np.linalg.norm(total, axis=1, keepdims=True) < 1e-6
    return np.where(opposite, np.nan, unit(np.where(opposite, wi, total)))


def cosines(n: np.ndarray, m: np.ndarray) -> np.ndarray:
    """n.m, 0 of opposite directions, whose m is across all others."""
    return np.nan_to_num(dot(n, m), nan=0.0)


def half_vector(n: np.ndarray, wo: np.ndarray, wi: np.ndarray, m: np.ndarray) -> np.ndarray:
    return np.stack([cosines(n, m), _log_gap(n, m), dot(n, wi), dot(n, wo), cosines(wi, m)], axis=1)


def highlight(n: np.ndarray, m: np.ndarray) -> np.ndarray:
    sine = np.linalg.norm(np.cross(n, m), axis=1)
    return np.log2(np.nan_to_num(sine, nan=1.0) ** 2 + 1e-8)[:, None] / 12


def learned_normal(n: np.ndarray, features: np.ndarray, m: np.ndarray) -> np.ndarray:
    f = np.zeros((len(n), 3))
    f[:, : features.shape[1]] = features[:, :3]
    bent = n + 0.1 * f
    none = np.linalg.norm(bent, axis=1, keepdims=True) < 1e-6
    q = np.where(none, n, unit(np.where(none, n, bent)))
    return np.stack([cosines(q, m), _log_gap(q, m)], axis=1)


def _log_gap(n: np.ndarray, m: np.ndarray) -> np.ndarray:
    return np.log2(np.maximum(0, 1 - cosines(n, m)) + 1e-4) / 6


def azimuth(t: np.ndarray, wo: np.ndarray, wi: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """cos phi, sin phi; by the angle itself."""
    across_o, across_i = np.cross(t, wo), np.cross(t, wi)
    d = np.linalg.norm(across_o, axis=1) * np.linalg.norm(across_i, axis=1)
    phi = np.arctan2(dot(t, np.cross(wo, wi)), dot(across_o, across_i))
    phi = np.where(d < 1e-6, 0.0, phi)
    return np.cos(phi), np.sin(phi)


def fiber_angles(t: np.ndarray, wo: np.ndarray, wi: np.ndarray) -> np.ndarray:
    s_i, s_o = dot(t, wi), dot(t, wo)
    cone = np.log2((s_i + s_o) ** 2 + 1e-3) / 6
    return np.stack([s_i, s_o, s_i + s_o, cone, *azimuth(t, wo, wi)], axis=1)


def fiber_lobes(t: np.ndarray, h: np.ndarray, wo: np.ndarray, wi: np.ndarray) -> np.ndarray:
    cos_phi, sin_phi = azimuth(t, wo, wi)
    phi = np.arctan2(sin_phi, cos_phi)
    c_o, s_o = np.linalg.norm(np.cross(t, wo), axis=1), dot(t, wo)
    g_o, g_t = np.arcsin(h), np.arcsin(h * c_o / np.sqrt(ETA**2 - s_o**2))
    return np.stack([np.cos(phi - (2 * g_o - 2 * p * g_t - p * np.pi)) for p in range(3)], axis=1)


def dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.sum(a * b, axis=1)


def unit(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)
