"""Strands of hair as arrays, and changes of single strands: resample, taper."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class Strands:
    """Strands from root to tip, right-handed, +Y up; strand k is points[offsets[k]:offsets[k + 1]].

    Attributes:
        points: (p, 3) float32.
        radii: (p,) float32, in the unit of the points.
        offsets: (s + 1,) int64, ascending from 0 to p.

    Raises:
        ValueError: shapes that do not belong together, or a strand of fewer than two points.
    """

    points: np.ndarray
    radii: np.ndarray
    offsets: np.ndarray

    def __post_init__(self) -> None:
        p = len(self.points)
        if self.points.shape != (p, 3) or self.radii.shape != (p,):
            found = f"points {self.points.shape}, radii {self.radii.shape}"
            raise ValueError(f"strands: found {found}, expected (p, 3) and (p,)")
        if len(self.offsets) < 2 or (self.offsets[0], self.offsets[-1]) != (0, p):
            raise ValueError(f"strands: found offsets {self.offsets}, expected 0 up to {p}")
        if self.counts.min() < 2:
            strand = int(self.counts.argmin())
            found = f"{self.counts[strand]} in strand {strand}"
            raise ValueError(f"strands: found {found}, expected at least 2 points per strand")

    def __len__(self) -> int:
        return len(self.offsets) - 1

    @property
    def counts(self) -> np.ndarray:
        """Points of each strand, (s,) int64."""
        return np.diff(self.offsets)

    def moved(self, scale: float, offset: np.ndarray) -> "Strands":
        """The strands, points and radii times `scale`, then moved by `offset` (3,)."""
        points = self.points * np.float32(scale) + np.asarray(offset, np.float32)
        return Strands(points, self.radii * np.float32(scale), self.offsets)


def of_equal_length(points: np.ndarray, radii: np.ndarray) -> Strands:
    """Strands from points (s, n, 3) and radii that broadcast to (s, n)."""
    s, n = points.shape[:2]
    radii = np.broadcast_to(np.asarray(radii, np.float32), (s, n)).reshape(-1).copy()
    points = np.ascontiguousarray(points, np.float32).reshape(-1, 3)
    return Strands(points, radii, np.arange(s + 1, dtype=np.int64) * n)


def fit(strands: Strands) -> Strands:
    """The strands scaled and moved into the ball of radius 1 around the origin."""
    centre = 0.5 * (strands.points.min(axis=0) + strands.points.max(axis=0))
    scale = 1.0 / (np.linalg.norm(strands.points - centre, axis=1) + strands.radii).max()
    return strands.moved(scale, -scale * centre)


def join(parts: list[Strands]) -> Strands:
    """All strands of the parts, in their order."""
    ends = np.cumsum(np.concatenate([part.counts for part in parts]))
    return Strands(
        np.concatenate([part.points for part in parts]),
        np.concatenate([part.radii for part in parts]),
        np.concatenate([[0], ends]).astype(np.int64),
    )


def resample(strands: Strands, points: int, keep: np.ndarray | float = 1.0) -> Strands:
    """Each strand by `points` points, evenly spaced on a Catmull-Rom spline through the old ones.

    Roots stay, and so do tips but where `keep`, () or (s,), says what part of the length to keep.
    Radii are interpolated linearly.
    """
    if points < 2:
        raise ValueError(f"resample: found {points} points, expected at least 2")
    keep = np.broadcast_to(np.asarray(keep, np.float32), (len(strands),))
    out = np.empty((len(strands), points, 3), np.float32)
    radii = np.empty((len(strands), points), np.float32)
    for count in np.unique(strands.counts):
        rows = np.flatnonzero(strands.counts == count)
        pick = strands.offsets[rows, None] + np.arange(count)
        out[rows], radii[rows] = _resample(
            old=strands.points[pick], radii=strands.radii[pick], n=points, keep=keep[rows, None]
        )
    return of_equal_length(out, radii)


def _resample(
    old: np.ndarray, radii: np.ndarray, n: int, keep: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """(s, m, 3), (s, m) to (s, n, 3), (s, n). The knots are the chords' lengths."""
    s, m = old.shape[:2]
    chords = np.maximum(np.linalg.norm(np.diff(old, axis=1), axis=2), 1e-12)
    knots = np.concatenate([np.zeros((s, 1), np.float32), np.cumsum(chords, axis=1)], axis=1)
    slopes = np.diff(old, axis=1) / chords[..., None]
    tangents = np.empty_like(old)
    before, after = chords[:, :-1, None], chords[:, 1:, None]
    tangents[:, 1:-1] = (after * slopes[:, :-1] + before * slopes[:, 1:]) / (before + after)
    for end, inner in ((0, 1), (-1, -2)):  # no curvature at the ends
        tangents[:, end] = slopes[:, end]
        if m > 2:
            tangents[:, end] = 1.5 * slopes[:, end] - 0.5 * tangents[:, inner]

    at = knots[:, -1:] * keep * np.linspace(0.0, 1.0, n, dtype=np.float32)
    segment = np.zeros((s, n), np.int64)
    for k in range(1, m - 1):
        segment += at >= knots[:, k : k + 1]
    row = np.arange(s)[:, None]
    width = chords[row, segment][..., None]
    t = np.clip((at - knots[row, segment])[..., None] / width, 0.0, 1.0)
    # Cubic Hermite basis.
    points = (
        (1 + 2 * t) * (1 - t) ** 2 * old[row, segment]
        + t * (1 - t) ** 2 * width * tangents[row, segment]
        + t**2 * (3 - 2 * t) * old[row, segment + 1]
        - t**2 * (1 - t) * width * tangents[row, segment + 1]
    )
    t = t[..., 0]
    return points, (1 - t) * radii[row, segment] + t * radii[row, segment + 1]


def taper(strands: Strands, radius: float, tip: float = 0.3, start: float = 0.5) -> Strands:
    """The strands with `radius` up to `start`, a part of the points, and `tip` times it at the end.

    Thinning is linear in the number of the point.
    """
    number = np.arange(len(strands.points)) - np.repeat(strands.offsets[:-1], strands.counts)
    along = number / np.repeat(strands.counts - 1, strands.counts)
    thinning = np.clip((along - start) / max(1.0 - start, 1e-6), 0.0, 1.0)
    radii = radius * (1.0 - (1.0 - tip) * thinning)
    return Strands(strands.points, radii.astype(np.float32), strands.offsets)
