"""Mapped normals: spec/RNA.md, 4.5, in float64, hit by hit as the text has it; and their hits."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from rna_sdk.package import Mesh, NormalMap
from tests.conformance.kit.base_color import moved

TOLERANCE = 1e-4
"""Tolerance of a component of a well-conditioned normal."""
LARGEST = 1e-3
"""Tolerance of a hit that is kept."""
TRIALS = 32
_ULP = 2.0**-23
_SHORT = 1e-6

Ranges = list[tuple[str, int, int]]


@dataclass(frozen=True)
class NormalHits:
    """Records of hits (n), expected normals and their tolerances (n, 3) float64, and classes."""

    records: bytes
    expected: np.ndarray
    tolerance: np.ndarray
    classes: Ranges


def mapped_normal(
    mesh: Mesh,
    records: Sequence[NormalMap],
    triangle: int,
    b: np.ndarray,
    rounding: np.random.Generator | None = None,
) -> np.ndarray:
    """(3,) at barycentric coordinates b (3,); rounding: moves what readers round to float32."""
    corners = mesh.triangles[triangle]
    n = moved(_unit(b @ mesh.normals[corners].astype(np.float64)), rounding)
    for record in records:
        if record.first <= triangle < record.first + record.count:
            n = _bent(record.texture, mesh, corners, b, n, rounding)
    return n


def _bent(
    texture: np.ndarray,
    mesh: Mesh,
    corners: np.ndarray,
    b: np.ndarray,
    n: np.ndarray,
    rounding: np.random.Generator | None,
) -> np.ndarray:
    p, uv = (values[corners].astype(np.float64) for values in (mesh.positions, mesh.uvs))
    e1, e2 = p[1] - p[0], p[2] - p[0]
    (a1, c1), (a2, c2) = uv[1] - uv[0], uv[2] - uv[0]
    d = a1 * c2 - a2 * c1
    along_u = moved((c2 * e1 - c1 * e2) * math.copysign(1, d), rounding)
    along_v = (a1 * e2 - a2 * e1) * math.copysign(1, d)
    across = along_u - (along_u @ n) * n
    if d == 0 or np.linalg.norm(across) <= _SHORT * np.linalg.norm(along_u):
        return n
    t = _unit(across)
    up = np.cross(n, t)
    up = -up if up @ along_v > 0 else up
    x, y = (_looked_up(texture, moved(b @ uv, rounding)) - 127) / 127
    m = x * t + y * up + math.sqrt(max(0.0, 1 - x * x - y * y)) * n
    return n if np.linalg.norm(m) <= _SHORT else _unit(m)


def _looked_up(texture: np.ndarray, uv: np.ndarray) -> np.ndarray:
    texels = texture.astype(np.float64)
    height, width = texels.shape[:2]
    s, t = uv[0] * width - 0.5, uv[1] * height - 0.5
    i, j = math.floor(s), math.floor(t)
    f, g = s - i, t - j
    texel = lambda row, column: texels[row % height, column % width]  # noqa: E731
    low = (1 - f) * texel(j, i) + f * texel(j, i + 1)
    high = (1 - f) * texel(j + 1, i) + f * texel(j + 1, i + 1)
    return (1 - g) * low + g * high


def _unit(vector: np.ndarray) -> np.ndarray:
    return vector / np.linalg.norm(vector)


def make_normal_hits(seed: int, part: int, mesh: Mesh, records: Sequence[NormalMap]) -> NormalHits:
    """Hits on every triangle of one part, class by class, with what they are answered."""
    rng, made, classes, first = np.random.default_rng(seed), [], [], 0
    for name, triangle, b in _classes(rng, mesh, records):
        rows = [_answered(mesh, records, *hit) for hit in zip(triangle.tolist(), b, strict=True)]
        valid = [k for k, (_, tolerance) in enumerate(rows) if tolerance.max() <= LARGEST]
        made += [(triangle[k], b[k], *rows[k]) for k in valid]
        classes.append((name, first, len(valid)))
        first += len(valid)
    words = np.zeros((len(made), 8), np.uint32)
    words[:, 0], words[:, 7] = [hit[0] for hit in made], part
    words[:, 1:3] = np.float32([hit[1][1:] for hit in made]).view(np.uint32)
    expected, tolerance = (np.array([hit[k] for hit in made]) for k in (2, 3))
    return NormalHits(words.astype("<u4").tobytes(), expected, tolerance, classes)


def _answered(
    mesh: Mesh, records: Sequence[NormalMap], triangle: int, b: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The normal, and its tolerance."""
    exact, rng = mapped_normal(mesh, records, triangle, b), np.random.default_rng(triangle)
    change = np.zeros(3)
    for _ in range(TRIALS):
        b1, b2 = b[1:] + _ULP / 2 * rng.choice([-1.0, 1.0], 2)
        moved = mapped_normal(mesh, records, triangle, np.array([1 - b1 - b2, b1, b2]), rng)
        change = np.maximum(change, np.abs(moved - exact))
    return exact, TOLERANCE + change


def _classes(
    rng: np.random.Generator, mesh: Mesh, records: Sequence[NormalMap]
) -> list[tuple[str, np.ndarray, np.ndarray]]:
    """(name, triangles (n,), barycentric coordinates (n, 3) as float32 has them)."""
    mapped = np.zeros(len(mesh.triangles), bool)
    for record in records:
        mapped[record.first : record.first + record.count] = True
    uv = mesh.uvs[mesh.triangles].astype(np.float64)
    (a1, c1), (a2, c2) = ((uv[:, k] - uv[:, 0]).T for k in (1, 2))
    area = a1 * c2 - a2 * c1
    return [
        (name, *_points(rng, np.flatnonzero(rows), edge))
        for name, rows, edge in (
            ("ordinary", mapped & (area > 0), False),
            ("mirrored", mapped & (area < 0), False),
            ("no area in the texture", mapped & (area == 0), False),
            ("no map", ~mapped, False),
            ("edges and corners", mapped & (area != 0), True),
        )
        if rows.any()
    ]


def _points(
    rng: np.random.Generator, triangles: np.ndarray, edge: bool, count: int = 120
) -> tuple[np.ndarray, np.ndarray]:
    b1, b2 = rng.dirichlet((1, 1, 1), count)[:, 1:].astype(np.float32).T
    if edge:
        b1[::2], b2[1::4], b1[1::4] = 0, 0, 1
    wide1, wide2 = b1.astype(np.float64), b2.astype(np.float64)
    weights = np.stack([1 - wide1 - wide2, wide1, wide2], axis=1)
    return triangles[np.arange(count) % len(triangles)], weights
