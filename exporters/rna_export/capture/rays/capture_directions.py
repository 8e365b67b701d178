"""Direction sampling and frames for view rays and lights."""

from collections.abc import Sequence

import numpy as np

from rna_sdk.package.manifest.manifest_fields import Region
from rna_trace import R2

GOLDEN = (np.sqrt(5.0) - 1.0) / 2.0
"""Share of a turn whose multiples are spread evenly, beside any multiples of R2."""

BEHIND = float(np.cos(np.radians(120.0)))
"""Cosine of the least angle between the eye and a light that is behind."""

_TRIED = 256


def spread_point(index: int, key: Sequence[int]) -> np.ndarray:
    """The `index`-th point of a sequence, (2,) in [0, 1): evenly spread at any count.

    key: seed of the sequence.
    """
    shift = np.random.default_rng(key).random(2)
    return np.asarray((shift + (index + 1) * R2) % 1.0)


def light_direction(index: int, seed: int, region: Region) -> np.ndarray:
    """The `index`-th light direction, (3,) float32: evenly spread over the region at any count."""
    (direction,) = directions_in(region, spread_point(index, [seed, 7])[None])
    return np.asarray(direction)


def directions_in(region: Region, u: np.ndarray) -> np.ndarray:
    """Directions (n, 3) float32 in a region of a domain, from u (n, 2) in [0, 1).

    Uniform in "sphere", "hemisphere" and one cone. Of several cones, half of the directions go to
    each cone alike and half in proportion to its size: no small light is starved by a large one.
    """
    if isinstance(region, str):
        return sphere(u, region)
    height = 1.0 - np.cos([cone.half_angle for cone in region])  # of the cap; its area over 2 pi
    share = np.full(len(region), 1.0 / len(region))
    if height.sum() > 0.0:
        share = 0.5 * share + 0.5 * height / height.sum()
    ends = np.cumsum(share)
    chosen = np.minimum(np.searchsorted(ends, u[:, 0], side="right"), len(region) - 1)
    within = np.clip((u[:, 0] - (ends - share)[chosen]) / share[chosen], 0.0, 1.0)
    axes = np.array([cone.axis for cone in region])[chosen]
    return around(axes, 1.0 - within * height[chosen], 2.0 * np.pi * u[:, 1])


def direction_seen_from(
    region: Region, to_eye: np.ndarray, behind: bool, rank: float, rng: np.random.Generator
) -> np.ndarray:
    """A light direction in the region, by its angle to the direction to the eye.

    to_eye: (3,). behind: whether it is one at 120 degrees or more; where the region has none, the
    light is as far from the eye as the region has. rank: in [0, 1), from the farthest of them to
    the nearest. Returns (3,) float32.
    """
    lights = directions_in(region, rng.random((_TRIED, 2)))
    cosine = lights @ (to_eye / np.linalg.norm(to_eye))
    order = np.argsort(cosine)
    count = int((cosine <= BEHIND).sum())
    of_kind = order[:count] if behind else order[count:]
    if not len(of_kind):
        of_kind = order[:1] if behind else order
    return np.asarray(lights[of_kind[int(rank * len(of_kind))]])


def sphere(u: np.ndarray, domain: str = "sphere") -> np.ndarray:
    """Uniform directions from u (n, 2) in [0, 1); `domain` "hemisphere" keeps +Y."""
    y = u[:, 0] if domain == "hemisphere" else 1.0 - 2.0 * u[:, 0]
    r = np.sqrt(np.maximum(0.0, 1.0 - y * y))
    phi = 2.0 * np.pi * u[:, 1]
    return np.stack([r * np.cos(phi), y, r * np.sin(phi)], axis=1).astype(np.float32)


def frame(n: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Two unit vectors that complete n (k, 3) to an orthonormal frame.

    Duff et al., "Building an Orthonormal Basis, Revisited", 2017.
    """
    sign = np.copysign(1.0, n[:, 2])
    a = -1.0 / (sign + n[:, 2])
    b = n[:, 0] * n[:, 1] * a
    s = np.stack([1.0 + sign * n[:, 0] ** 2 * a, sign * b, -sign * n[:, 0]], axis=1)
    t = np.stack([b, sign + n[:, 1] ** 2 * a, -n[:, 1]], axis=1)
    return s, t


def around(n: np.ndarray, cosine: np.ndarray, phi: np.ndarray) -> np.ndarray:
    """Directions at polar cosine (k,) and azimuth (k,) about n (k, 3)."""
    s, t = frame(n)
    r = np.sqrt(np.maximum(0.0, 1.0 - cosine**2))
    x, y = r * np.cos(phi), r * np.sin(phi)
    directions: np.ndarray = x[:, None] * s + y[:, None] * t + cosine[:, None] * n
    return directions.astype(np.float32)


def reflect(wi: np.ndarray, h: np.ndarray) -> np.ndarray:
    """wi mirrored about h; both (k, 3)."""
    mirrored: np.ndarray = 2.0 * np.sum(wi * h, axis=1, keepdims=True) * h - wi
    return mirrored.astype(np.float32)
