"""Grows many strands between few guides."""

import numpy as np

from .strands import Strands, of_equal_length, resample

_REACH = 4.0  # a neighbour is at most this many times the usual distance of roots away


def interpolate(
    guides: Strands,
    count: int,
    *,
    points: int = 16,
    seed: int = 0,
    neighbours: int = 8,
    alike: float = 0.85,
    clump: float = 0.0,
    noise: float = 0.0,
    shorten: float = 0.0,
) -> Strands:
    """`count` strands of `points` points that fill the space between the guides.

    A strand belongs to one guide. Its root lies between that guide's root and two of the nearest
    ones, nearest to its own; its shape is blended in the same way, but only of guides that run
    alike, so that a parting stays open. Every guide gets the same number of strands, give or take
    one. The same seed gives the same strands.

    Args:
        neighbours: guides around a guide that its strands may lean to.
        alike: two guides run alike when the mean cosine of their directions, from root to tip, is
            at least this.
        clump: the part of the way towards its guide that a strand has gone at its tip, 0 to 1.
        noise: amplitude of smooth waves at the tip, as a part of the strand's length.
        shorten: a strand loses up to this part of its length, at random.
    """
    if count < 1:
        raise ValueError(f"interpolate: found {count} strands, expected at least 1")
    rng = np.random.default_rng(seed)
    even = resample(guides, points)
    shapes = even.points.reshape(len(guides), points, 3)
    roots = shapes[:, 0]
    relative = shapes - roots[:, None]

    guide = rng.permutation(np.arange(count) % len(guides))
    near, alike_near = _neighbours(shapes, neighbours, alike)
    pick = rng.integers(0, near.shape[1], (2, count))
    others, blends = near[guide, pick], alike_near[guide, pick]  # (2, s)
    weights = np.sort(rng.dirichlet((1.0, 1.0, 1.0), count), axis=1)[:, ::-1].astype(np.float32)

    at = np.stack([guide, *others], axis=1)
    shape = np.stack([guide, *np.where(blends, others, guide)], axis=1)
    grown = np.zeros((count, points, 3), np.float32)
    for j in range(3):
        grown += weights[:, j, None, None] * (roots[at[:, j], None] + relative[shape[:, j]])
    along = np.linspace(0.0, 1.0, points, dtype=np.float32)
    grown += clump * along[:, None] ** 1.5 * (shapes[guide] - grown)
    grown += noise * _waves(grown, along, rng)
    radii = even.radii.reshape(len(guides), points)[guide]
    return resample(of_equal_length(grown, radii), points, 1.0 - shorten * rng.random(count))


def _neighbours(shapes: np.ndarray, k: int, alike: float) -> tuple[np.ndarray, np.ndarray]:
    """(g, k) the nearest guides by their roots, and whether each runs alike.

    A guide too far away is replaced by the guide itself.
    """
    g = len(shapes)
    roots = shapes[:, 0].astype(np.float64)
    roots = roots - roots.mean(axis=0)
    k = max(1, min(k, g - 1))
    near, distance = np.empty((g, k), np.int64), np.empty((g, k))
    squares = np.sum(roots**2, axis=1)
    for first in range(0, g, 512):
        rows = np.arange(first, min(first + 512, g))
        apart = squares[rows, None] + squares - 2.0 * roots[rows] @ roots.T
        if g > 1:
            apart[np.arange(len(rows)), rows] = np.inf
        near[rows] = np.argpartition(apart, k - 1, axis=1)[:, :k]
        result = np.take_along_axis(apart, near[rows], axis=1)
        distance[rows] = np.sqrt(np.maximum(result, 0.0))
    reach = _REACH * np.median(distance.min(axis=1))
    near = np.where(distance <= reach, near, np.arange(g)[:, None])

    directions = np.diff(shapes, axis=1)
    directions /= np.maximum(np.linalg.norm(directions, axis=2, keepdims=True), 1e-20)
    cosines = np.stack(
        [np.einsum("gnc,gnc->gn", directions, directions[column]).mean(axis=1) for column in near.T]
    )
    return near, cosines.T >= alike


def _waves(grown: np.ndarray, along: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """(s, n, 3) two random sine waves a strand; 0 at the root, about its length at the tip."""
    length = np.linalg.norm(np.diff(grown, axis=1), axis=2).sum(axis=1)
    waves = np.zeros_like(grown)
    for low, high in ((0.4, 1.0), (1.5, 3.0)):  # periods a strand
        frequency = rng.uniform(low, high, (len(grown), 1))
        phase = rng.uniform(0.0, 2.0 * np.pi, (len(grown), 1))
        towards = rng.normal(size=(len(grown), 1, 3)).astype(np.float32) / low
        wave = np.sin(2.0 * np.pi * frequency * along + phase).astype(np.float32)
        waves += 0.4 * wave[..., None] * towards
    return np.asarray(waves * (length[:, None] * along)[..., None].astype(np.float32))
