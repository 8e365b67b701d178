"""Random numbers and directions: Owen-scrambled Sobol' points, and mixtures over the sphere.

Numbers are a pure function of seed, pixel, sample and dimension, so an image depends neither on
the number of threads nor on how it was cut into bands. Every prefix of 2^k samples of a pixel is
a (0, k, 2)-net in each dimension, so an image that was stopped early is well distributed too.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit, prange

# Part of the environment samples that follow the cosine about the shading normal. The rest is
# uniform over the sphere, because a translucent asset passes light from behind.
COSINE_SHARE = 0.5


@dataclass(frozen=True)
class Sampler:
    """The random numbers of one sample of every pixel.

    seed: of the whole image. sample: number of this sample, from 0.
    """

    seed: int
    sample: int

    def square(self, pixels: np.ndarray, dimension: int) -> np.ndarray:
        """Points in the unit square, one a pixel: (n, 2) float64 in [0, 1).

        pixels: (n,) uint32. dimension: which decision of the sample they are for.
        """
        points = np.empty((len(pixels), 2), np.float64)
        _scrambled_sobol(pixels, self.sample, dimension, self.seed, points)
        return points


def sample_sphere_mixture(n_world: np.ndarray, u: np.ndarray) -> np.ndarray:
    """Unit directions: COSINE_SHARE of them cosine-distributed about n, the rest uniform.

    n_world: (n, 3) float32, unit; a zero vector counts as (0, 1, 0). u: (n, 2) in [0, 1).
    Returns (n, 3) float32 with density `sphere_mixture_pdf`.
    """
    wi_world = np.empty((len(n_world), 3), np.float32)
    _sample_sphere_mixture(n_world, u, wi_world)
    return wi_world


def sphere_mixture_pdf(n_world: np.ndarray, wi_world: np.ndarray) -> np.ndarray:
    """Density of `sample_sphere_mixture` in wi, per steradian: (n,) float64.

    n_world, wi_world: (n, 3) float32, unit.
    """
    pdf = np.empty(len(n_world), np.float64)
    _sphere_mixture_pdf(n_world, wi_world, pdf)
    return pdf


@njit(cache=True)
def _hash(x):
    """A 32-bit mix: "lowbias32" of C. Wellons, Prospecting for Hash Functions (2018)."""
    x = np.uint32(x)
    x = np.uint32((x ^ (x >> np.uint32(16))) * np.uint32(0x7FEB352D))
    x = np.uint32((x ^ (x >> np.uint32(15))) * np.uint32(0x846CA68B))
    return np.uint32(x ^ (x >> np.uint32(16)))


@njit(cache=True)
def _reverse_bits(x):
    x = np.uint32(((x >> np.uint32(1)) & 0x55555555) | ((x & 0x55555555) << np.uint32(1)))
    x = np.uint32(((x >> np.uint32(2)) & 0x33333333) | ((x & 0x33333333) << np.uint32(2)))
    x = np.uint32(((x >> np.uint32(4)) & 0x0F0F0F0F) | ((x & 0x0F0F0F0F) << np.uint32(4)))
    x = np.uint32(((x >> np.uint32(8)) & 0x00FF00FF) | ((x & 0x00FF00FF) << np.uint32(8)))
    return np.uint32((x >> np.uint32(16)) | (x << np.uint32(16)))


@njit(cache=True)
def _owen_scramble(x, seed):
    """Nested uniform scramble of the bits of x.

    B. Burley, Practical Hash-based Owen Scrambling (JCGT 9(4), 2020), listing 1, with the
    permutation of Laine and Karras.
    """
    x = np.uint32(_reverse_bits(x) + np.uint32(seed))
    x = np.uint32(x ^ np.uint32(x * np.uint32(0x6C50B47C)))
    x = np.uint32(x ^ np.uint32(x * np.uint32(0xB82F1E52)))
    x = np.uint32(x ^ np.uint32(x * np.uint32(0xC7AFE638)))
    x = np.uint32(x ^ np.uint32(x * np.uint32(0x8D22F6E6)))
    return _reverse_bits(x)


@njit(cache=True)
def _second_sobol_dimension(index):
    """Bits of the second Sobol' coordinate; the first is `_reverse_bits`."""
    x, column = np.uint32(0), np.uint32(0x80000000)
    while index > 0:
        if index & np.uint32(1):
            x = np.uint32(x ^ column)
        index = np.uint32(index >> np.uint32(1))
        column = np.uint32(column ^ (column >> np.uint32(1)))
    return x


@njit(cache=True, parallel=True)
def _scrambled_sobol(pixels, sample, dimension, seed, points):
    image_key = _hash(_hash(seed) + np.uint32(dimension))
    for i in prange(len(pixels)):
        key = _hash(image_key ^ _hash(pixels[i] + np.uint32(1)))
        index = _owen_scramble(np.uint32(sample), key)
        first = _owen_scramble(_reverse_bits(index), _hash(key + np.uint32(1)))
        second = _owen_scramble(_second_sobol_dimension(index), _hash(key + np.uint32(2)))
        points[i, 0] = first * 2.0**-32
        points[i, 1] = second * 2.0**-32


@njit(cache=True)
def _axis(n_world, i):
    """Normal i in float64, or the vertical where it is zero."""
    x, y, z = np.float64(n_world[i, 0]), np.float64(n_world[i, 1]), np.float64(n_world[i, 2])
    return (x, y, z) if x * x + y * y + z * z > 0.5 else (0.0, 1.0, 0.0)


@njit(cache=True, parallel=True)
def _sample_sphere_mixture(n_world, u, wi_world):
    for i in prange(len(n_world)):
        u1, phi = u[i, 0], 2.0 * np.pi * u[i, 1]
        if u1 < COSINE_SHARE:
            cos_theta = np.sqrt(1.0 - u1 / COSINE_SHARE)
        else:
            cos_theta = 1.0 - 2.0 * (u1 - COSINE_SHARE) / (1.0 - COSINE_SHARE)
        sin_theta = np.sqrt(max(0.0, 1.0 - cos_theta * cos_theta))
        a, b = sin_theta * np.cos(phi), sin_theta * np.sin(phi)
        x, y, z = _axis(n_world, i)
        # Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6(1), 2017).
        sign = np.copysign(1.0, z)
        c = -1.0 / (sign + z)
        d = x * y * c
        wi_world[i, 0] = a * (1.0 + sign * x * x * c) + b * d + cos_theta * x
        wi_world[i, 1] = a * sign * d + b * (sign + y * y * c) + cos_theta * y
        wi_world[i, 2] = -a * sign * x - b * y + cos_theta * z


@njit(cache=True, parallel=True)
def _sphere_mixture_pdf(n_world, wi_world, pdf):
    for i in prange(len(n_world)):
        x, y, z = _axis(n_world, i)
        cosine = x * wi_world[i, 0] + y * wi_world[i, 1] + z * wi_world[i, 2]
        pdf[i] = COSINE_SHARE * max(0.0, cosine) / np.pi + (1.0 - COSINE_SHARE) / (4.0 * np.pi)
