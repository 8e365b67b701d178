"""Base colours: spec/RNA.md, 4.6, in float64, hit by hit as the text has it; and their hits."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from rna_sdk.package import BaseColor, Mesh

TOLERANCE = 1e-4
STORED = 0.005
"""Half a step of 8 bits in sRGB at white, and a little: levels above 0 may be stored so."""
TRIALS = 32
_ULP = 2.0**-23

Ranges = list[tuple[str, int, int]]


@dataclass(frozen=True)
class BaseColorHits:
    """Records of hits (n), expected base colours and tolerances (n, 3) float64, and classes."""

    records: bytes
    expected: np.ndarray
    tolerance: np.ndarray
    classes: Ranges


@dataclass(frozen=True)
class Hit:
    """b1, b2, level: as float32 has them."""

    triangle: int
    b1: float
    b2: float
    level: float


def base_color(
    mesh: Mesh, records: Sequence[BaseColor], hit: Hit, rounding: np.random.Generator | None = None
) -> np.ndarray:
    """(3,) linear RGB; rounding: moves what readers round to float32."""
    for record in records:
        if record.first <= hit.triangle < record.first + record.count:
            factor = np.array(record.factor)
            if record.image is None:
                return factor
            uv = mesh.uvs[mesh.triangles[hit.triangle]].astype(np.float64)
            u, v = moved(np.array([1 - hit.b1 - hit.b2, hit.b1, hit.b2]) @ uv, rounding)
            a, b, c, d, e, f = record.transform
            p = moved(np.array([a * u, b * v, c]), rounding).sum()
            q = moved(np.array([d * u, e * v, f]), rounding).sum()
            return factor * _filtered(record, p, q, hit.level)
    return np.ones(3)


def _filtered(record: BaseColor, p: float, q: float, level: float) -> np.ndarray:
    levels = pyramid(record.image.tobytes(), record.image.shape, record.color_space)
    k = math.floor(level)
    if k >= len(levels) - 1:
        return linear(_looked_up(levels[-1], p, q, record.wrap), record.color_space)
    near, far = (
        linear(_looked_up(levels[k + i], p, q, record.wrap), record.color_space) for i in (0, 1)
    )
    return (1 - (level - k)) * near + (level - k) * far


@cache
def pyramid(data: bytes, shape: tuple[int, ...], space: str) -> list[np.ndarray]:
    """The image, and its means in linear colours down to one texel, encoded as it is."""
    levels = [linear(np.frombuffer(data, np.uint8).reshape(shape) / 255, space)]
    while levels[-1].shape[0] > 1 or levels[-1].shape[1] > 1:
        levels.append(_narrowed(_narrowed(levels[-1]).swapaxes(0, 1)).swapaxes(0, 1))
    if space == "linear":
        return levels
    return [np.where(v <= 0.0031308, v * 12.92, 1.055 * v ** (1 / 2.4) - 0.055) for v in levels]


def linear(values: np.ndarray, space: str) -> np.ndarray:
    """Linear values of encoded values from 0 to 1."""
    if space == "linear":
        return values
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def _narrowed(texels: np.ndarray) -> np.ndarray:
    """Half the rows, each the mean over an interval of rows, some of which count in part."""
    n = len(texels)
    half = max(1, n // 2)
    means = []
    for i in range(half):
        low, high = i * n / half, (i + 1) * n / half
        shares = [max(0.0, min(high, k + 1) - max(low, k)) for k in range(n)]
        means.append(np.tensordot(shares, texels, 1) / (high - low))
    return np.array(means)


def _looked_up(texels: np.ndarray, p: float, q: float, wrap: tuple[str, str]) -> np.ndarray:
    height, width = texels.shape[:2]
    s, t = p * width - 0.5, q * height - 0.5
    i, j = math.floor(s), math.floor(t)
    total = np.zeros(3)
    for row, g in ((j, 1 - (t - j)), (j + 1, t - j)):
        for column, f in ((i, 1 - (s - i)), (i + 1, s - i)):
            inside = _inside(row, height, wrap[1]), _inside(column, width, wrap[0])
            total += g * f * texels[inside]
    return total


def _inside(i: int, n: int, wrap: str) -> int:
    if wrap == "clamp":
        return min(max(i, 0), n - 1)
    m = i % (n if wrap == "repeat" else 2 * n)
    return m if m < n else 2 * n - 1 - m


def moved(values: np.ndarray, rounding: np.random.Generator | None) -> np.ndarray:
    """By two units in the last place of the largest in float32, each up or down."""
    if rounding is None:
        return values
    size = 2 * _ULP * max(float(np.abs(values).max()), 2.0**-100)
    return values + size * rounding.choice([-1.0, 1.0], values.shape)


def make_base_color_hits(
    seed: int, part: int, mesh: Mesh, records: Sequence[BaseColor]
) -> BaseColorHits:
    """Hits on every triangle of one part, class by class, with what they are answered."""
    rng, hits, classes = np.random.default_rng(seed), [], []
    for name, of_class in _classes(rng, mesh, records):
        first = len(hits)
        hits += of_class
        classes.append((name, first, len(hits) - first))
    rows = [_answered(mesh, records, hit) for hit in hits]
    words = np.zeros((len(hits), 8), np.uint32)
    words[:, 0], words[:, 7] = [hit.triangle for hit in hits], part
    numbers = np.float32([(hit.b1, hit.b2, hit.level) for hit in hits])
    words[:, 1:4] = numbers.view(np.uint32)
    expected, tolerance = (np.array([row[k] for row in rows]) for k in (0, 1))
    return BaseColorHits(words.astype("<u4").tobytes(), expected, tolerance, classes)


def _answered(mesh: Mesh, records: Sequence[BaseColor], hit: Hit) -> tuple[np.ndarray, np.ndarray]:
    """The base colour, and its tolerance."""
    exact, rng = base_color(mesh, records, hit), np.random.default_rng(hit.triangle)
    change = np.zeros(3)
    for _ in range(TRIALS):
        b1, b2 = (b + _ULP / 2 * rng.choice([-1.0, 1.0]) for b in (hit.b1, hit.b2))
        moved = base_color(mesh, records, replace(hit, b1=b1, b2=b2), rng)
        change = np.maximum(change, np.abs(moved - exact))
    return exact, (TOLERANCE if hit.level == 0 else STORED) + change


def _classes(
    rng: np.random.Generator, mesh: Mesh, records: Sequence[BaseColor]
) -> Iterator[tuple[str, list[Hit]]]:
    number = np.full(len(mesh.triangles), -1)
    for k, record in enumerate(records):
        number[record.first : record.first + record.count] = k
    pictured = np.isin(number, [k for k, one in enumerate(records) if one.image is not None])
    whole = [1.0, 2.0, 3.0]
    yield "the image itself", _hits(rng, np.flatnonzero(pictured), [0.0], 120)
    yield "edges and corners", _hits(rng, np.flatnonzero(pictured), [0.0], 60, edge=True)
    yield "levels", _hits(rng, np.flatnonzero(pictured), whole, 60)
    between = rng.uniform(0, 5, 120).astype(np.float32).tolist()
    yield "between levels", _hits(rng, np.flatnonzero(pictured), between, 120)
    yield "beyond the last level", _hits(rng, np.flatnonzero(pictured), [6.5, 14.0, 1e9], 36)
    yield "a factor alone", _hits(rng, np.flatnonzero((number >= 0) & ~pictured), [0.0, 2.5], 12)
    yield "no record", _hits(rng, np.flatnonzero(number < 0), [0.0, 2.5], 12)


def _hits(
    rng: np.random.Generator,
    triangles: np.ndarray,
    levels: Sequence[float],
    count: int,
    edge: bool = False,
) -> list[Hit]:
    b1, b2 = rng.dirichlet((1, 1, 1), count)[:, 1:].astype(np.float32).T
    if edge:
        b1[::2], b2[1::4], b1[1::4] = 0, 0, 1
    chosen = rng.permutation(triangles)[np.arange(count) % len(triangles)]
    rows = zip(chosen.tolist(), b1.tolist(), b2.tolist(), strict=True)
    return [Hit(*row, levels[k % len(levels)]) for k, row in enumerate(rows)]
