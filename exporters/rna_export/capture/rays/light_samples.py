"""Light directions for integrals over all of them at one point and view, with their density.

Three kinds are mixed in fixed numbers: uniform ones, cosines about the normal, and mirrors of wo
about half vectors of GGX, with every alpha from half of the narrowest to 0.8 alike on a logarithmic
scale.
The weights of a lobe of any width between them stay small, at grazing views too.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from rna_export.capture.rays.capture_directions import GOLDEN, around, reflect
from rna_render.world.neural_sampling import Lobe, LobeMixture

WIDEST = 0.8  # alpha of GGX

_UNIFORM, _COSINE, _MIRROR = 4, 5, 7
LIGHTS = _UNIFORM + _COSINE + _MIRROR
"""Directions of a point, which have one density together."""

_FIBER = LobeMixture(cone=(Lobe(0.6, 0.06),)).everywhere


class LightSamples(NamedTuple):
    """wi: (n, 3) float32, a direction for each point. pdf: (n,) float64, per steradian."""

    wi: np.ndarray
    pdf: np.ndarray


def surface_lights(
    n: np.ndarray, wo: np.ndarray, narrowest: float, rng: np.random.Generator
) -> Iterator[LightSamples]:
    """`LIGHTS` directions of each point of a surface, one of each point at a time.

    n, wo: (k, 3) float32, unit, one space. narrowest: alpha of GGX.
    """
    narrowest *= 0.5  # a lobe at the end of the scale would have weights that vary
    n, wo = n.astype(np.float64), wo.astype(np.float64)
    n = np.where(np.sum(n * wo, axis=1, keepdims=True) < 0.0, -n, n)
    shift = rng.random((len(n), 2))
    for count in (_UNIFORM, _COSINE, _MIRROR):
        for number in range(count):
            u = (number + shift[:, 0]) / count
            turn = 2.0 * np.pi * ((shift[:, 1] + number * GOLDEN) % 1.0)
            if count == _UNIFORM:
                wi = around(n, 1.0 - 2.0 * u, turn)
            elif count == _COSINE:
                wi = around(n, np.sqrt(1.0 - u), turn)
            else:
                wi = reflect(wo, around(n, ggx_cosine(u, narrowest), turn))
            yield LightSamples(wi.astype(np.float32), _density(n, wo, narrowest, wi))


def fiber_lights(
    tangent: np.ndarray, wo: np.ndarray, rng: np.random.Generator
) -> Iterator[LightSamples]:
    """`LIGHTS` directions of each point of strands; tangent, wo: (k, 3) float32, unit."""
    no_normals = np.zeros_like(tangent)
    shift = rng.random((len(tangent), 2))
    for number in range(LIGHTS):
        u = np.stack(
            [(number + shift[:, 0]) / LIGHTS, (shift[:, 1] + number * GOLDEN) % 1.0], axis=1
        )
        wi = _FIBER.sample(no_normals, tangent, wo, u)
        yield LightSamples(wi, _FIBER.pdf(no_normals, tangent, wo, wi).astype(np.float64))


def _density(n: np.ndarray, wo: np.ndarray, narrowest: float, wi: np.ndarray) -> np.ndarray:
    """Per steradian, (k,), of all `LIGHTS` directions together."""
    wi = wi.astype(np.float64)
    h = wi + wo
    h /= np.maximum(np.linalg.norm(h, axis=1, keepdims=True), 1e-12)
    # About h and about -h the mirror is the same.
    cosine, across = np.abs(np.sum(n * h, axis=1)), np.abs(np.sum(wo * h, axis=1))
    sine = np.linalg.norm(np.cross(n, h), axis=1)  # exact where the lobe is narrow
    mirror = ggx_of_all_widths(cosine, sine, narrowest) * cosine / np.maximum(4.0 * across, 1e-9)
    diffuse = np.maximum(np.sum(n * wi, axis=1), 0.0) / np.pi
    kinds = _UNIFORM / (4.0 * np.pi) + _COSINE * diffuse + _MIRROR * mirror
    return np.asarray(kinds / LIGHTS)


def ggx_of_all_widths(cosine: np.ndarray, sine: np.ndarray, narrowest: float) -> np.ndarray:
    """Mean of GGX's D over alpha from `narrowest` to 0.8, alike in its logarithm.

    D is alpha^2 / (pi (cos^2 alpha^2 + sin^2)^2), and d alpha / alpha is d(alpha^2) / (2 alpha^2),
    so the integral over s = alpha^2 has the integrand 1 / (cos^2 s + sin^2)^2.
    """
    low, high = narrowest**2, WIDEST**2
    scale = np.pi * np.log(high / low)
    denominator = (cosine**2 * low + sine**2) * (cosine**2 * high + sine**2)
    return np.asarray((high - low) / (scale * denominator))


def ggx_cosine(u: np.ndarray, narrowest: float) -> np.ndarray:
    """Cosine to the normal of half vectors of that density times the cosine; u: (k,) in [0, 1).

    The share within an angle is ln(high (low + q) / (low (high + q))) / ln(high / low), where q is
    the square of the angle's tangent.
    """
    low, high = narrowest**2, WIDEST**2
    ratio = (high / low) ** u
    q = low * high * (ratio - 1.0) / np.maximum(high - low * ratio, 1e-300)
    return np.asarray(1.0 / np.sqrt(1.0 + q))
