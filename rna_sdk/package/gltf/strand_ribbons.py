"""Strands as a mesh of flat ribbons, for programs that show triangles alone."""

import math

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.geometry.curves import Curves
from rna_sdk.package.geometry.mesh import Mesh

MAX_TRIANGLES = 300_000
_A_SEGMENT = 2  # triangles
_FEWEST_SEGMENTS = 8  # of a strand, before strands are left out
_AS_WIDE = math.pi / 2.0  # half the width of a ribbon that is as wide as r = 1, seen from all sides

Array = NDArray[np.float64]


def ribbons(curves: Curves, max_triangles: int = MAX_TRIANGLES) -> Mesh:
    """The strands as ribbons of the same mean width, which have two sides.

    More than `max_triangles` are avoided first by fewer points a strand, 9 at least, then by
    every k-th strand alone, k times as thick.
    """
    counts = np.diff(curves.offsets.astype(np.int64))
    most = max_triangles // _A_SEGMENT  # segments
    segments = int(counts.max()) - 1
    segments = min(segments, max(_FEWEST_SEGMENTS, most // len(counts)))
    every = math.ceil(len(counts) / max(1, most // segments))
    points, radii = _resampled(curves, segments + 1, every)
    return _swept(points, radii * (every * _AS_WIDE))


def _resampled(curves: Curves, count: int, every: int) -> tuple[Array, Array]:
    """Points (s, count, 3) and radii (s, count) of every k-th strand, evenly by number."""
    first = curves.offsets[:-1:every].astype(np.int64)[:, None]
    last = curves.offsets[1::every].astype(np.int64)[:, None] - 1
    at = (last - first) * np.linspace(0.0, 1.0, count)
    low = np.minimum(first + at.astype(np.int64), last - 1)
    share = first + at - low
    points, radii = curves.points.astype(np.float64), curves.radii.astype(np.float64)
    mixed = points[low] + share[..., None] * (points[low + 1] - points[low])
    return mixed, radii[low] + share * (radii[low + 1] - radii[low])


def _swept(points: Array, radii: Array) -> Mesh:
    strands, count = radii.shape
    across, face = _frames(_tangents(points))
    half = radii[..., None] * across
    positions = np.stack([points - half, points + half], axis=2)
    quad = np.array([[0, 2, 1], [1, 2, 3]])
    starts = (np.arange(strands)[:, None] * count + np.arange(count - 1)) * 2
    triangles = starts.reshape(-1, 1, 1) + quad
    return Mesh(
        positions.reshape(-1, 3).astype(np.float32),
        np.repeat(face.reshape(-1, 3), 2, axis=0).astype(np.float32),
        None,
        triangles.reshape(-1, 3).astype(np.uint32),
    )


def _tangents(points: Array) -> Array:
    """Unit directions at points (s, n, 3); a segment's where both sides cancel."""
    steps = _unit(np.diff(points, axis=1))
    sums = np.concatenate([steps[:, :1], steps[:, 1:] + steps[:, :-1], steps[:, -1:]], axis=1)
    directions = np.concatenate([steps, steps[:, -1:]], axis=1)
    short = np.linalg.norm(sums, axis=2, keepdims=True) < 1e-6
    return _unit(np.where(short, directions, sums))


def _frames(tangents: Array) -> tuple[Array, Array]:
    """Unit directions across the strands and out of their ribbons, without a twist: (s, n, 3)."""
    out = np.empty_like(tangents)
    across = _across(tangents[:, 0])
    for j in range(tangents.shape[1]):
        t = tangents[:, j]
        carried = across - t * (across * t).sum(axis=1, keepdims=True)
        lost = np.linalg.norm(carried, axis=1, keepdims=True) < 1e-6
        out[:, j] = across = _unit(np.where(lost, _across(t), carried))
    return out, np.cross(tangents, out)


def _across(t: Array) -> Array:
    """A unit direction across each unit direction (s, 3)."""
    axis = np.eye(3)[np.abs(t).argmin(axis=1)]
    return _unit(np.cross(t, axis))


def _unit(vectors: Array) -> Array:
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    along_x = np.broadcast_to(np.array([1.0, 0.0, 0.0]), vectors.shape)
    return np.where(lengths > 0.0, vectors / np.maximum(lengths, 1e-300), along_x)
