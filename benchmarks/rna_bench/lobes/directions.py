"""Sets of directions, and directions of lights that are von Mises-Fisher distributions."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def random_directions(count: int, rng: np.random.Generator) -> np.ndarray:
    """Unit, (count, 3) float64."""
    d = rng.normal(size=(count, 3))
    return np.asarray(d / np.linalg.norm(d, axis=1, keepdims=True))


def even_directions(count: int) -> NDArray[np.float32]:
    """Unit, (count, 3) float32, evenly spread: a Fibonacci spiral."""
    k = np.arange(count) + 0.5
    z, phi = 1 - 2 * k / count, k * np.pi * (3 - np.sqrt(5))
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(phi), z, r * np.sin(phi)], axis=1).astype(np.float32)


def log_c(kappa: np.ndarray) -> np.ndarray:
    """log of kappa / (4 pi sinh kappa), what makes exp(kappa cos) a density."""
    inner = np.log(kappa) - np.log(2 * np.pi) - np.log1p(-np.exp(-2 * kappa))
    return np.asarray(inner - kappa)


def directions_of_lights(
    axis: np.ndarray, kappa: np.ndarray, each: int, rng: np.random.Generator
) -> np.ndarray:
    """`each` directions of lights, stratified by their cosine: (n, K, each, 3) float64, unit.

    axis: (n, K, 3), unit. kappa: (n, K).
    """
    u = (rng.random((*kappa.shape, each)) + np.arange(each)) / each
    k = kappa[..., None]
    z = 1 + np.log(u + (1 - u) * np.exp(-2 * k) + 1e-30) / k
    r, phi = np.sqrt(np.maximum(0.0, 1 - z * z)), 2 * np.pi * rng.random(u.shape)
    across = np.where(np.abs(axis[..., :1]) > 0.5, (0.0, 1.0, 0.0), (1.0, 0.0, 0.0))
    t = np.cross(axis, across)
    t /= np.linalg.norm(t, axis=-1, keepdims=True)
    parts = zip((r * np.cos(phi), r * np.sin(phi), z), (t, np.cross(axis, t), axis), strict=True)
    d = sum(weight[..., None] * v[:, :, None] for weight, v in parts)
    return np.asarray(d / np.linalg.norm(d, axis=-1, keepdims=True))
