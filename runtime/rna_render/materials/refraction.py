"""Smooth interfaces between air and a dielectric: how much they reflect, and where light goes on.

Exact Fresnel equations for unpolarised light, and Snell's law: Born and Wolf, Principles of Optics,
section 1.5.
"""

import numpy as np


def fresnel(cos_i: np.ndarray, eta: np.ndarray) -> np.ndarray:
    """The share that is reflected: (n,), 1 for total reflection.

    cos_i: (n,) in [0, 1], of the side that light comes from. eta: (n,) index of the other side over
    that of this one.
    """
    sin2_t = (1.0 - cos_i**2) / eta**2
    cos_t = np.sqrt(np.maximum(1.0 - sin2_t, 0.0))
    parallel = (eta * cos_i - cos_t) / np.maximum(eta * cos_i + cos_t, 1e-30)
    across = (cos_i - eta * cos_t) / np.maximum(cos_i + eta * cos_t, 1e-30)
    return np.asarray(np.where(sin2_t >= 1.0, 1.0, 0.5 * (parallel**2 + across**2)))


def reflected(d: np.ndarray, n: np.ndarray) -> np.ndarray:
    """Unit directions (n, 3), mirrored; d: towards the surface; n: unit normals against d."""
    mirrored: np.ndarray = d - 2.0 * np.sum(d * n, axis=1, keepdims=True) * n
    return mirrored


def refracted(d: np.ndarray, n: np.ndarray, eta: np.ndarray) -> np.ndarray:
    """Unit directions (n, 3) behind the surface; arguments as of `reflected` and `fresnel`.

    Only where `fresnel` is below 1.
    """
    cos_i = -np.sum(d * n, axis=1)
    cos_t = np.sqrt(np.maximum(1.0 - (1.0 - cos_i**2) / eta**2, 0.0))
    behind = d / eta[:, None] + (cos_i / eta - cos_t)[:, None] * n
    unit: np.ndarray = behind / np.linalg.norm(behind, axis=1, keepdims=True)
    return unit
