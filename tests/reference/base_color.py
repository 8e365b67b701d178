"""Base colour at hits, word for word as spec/RNA.md, 4.6, has it: slow, in float64."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package import BaseColor, Mesh

Float = NDArray[np.float64]


def base_color_reference(
    mesh: Mesh,
    records: Sequence[BaseColor],
    triangle: NDArray[np.integer],
    u: NDArray[np.floating],
    v: NDArray[np.floating],
    level: NDArray[np.floating],
) -> Float:
    """(n, 3) linear RGB. triangle, u, v, level: (n,), of the hits."""
    result = np.ones((len(triangle), 3))
    for record in records:
        rows = np.flatnonzero((triangle >= record.first) & (triangle < record.first + record.count))
        result[rows] = record.factor
        if record.image is None:
            continue
        assert mesh.uvs is not None
        weights = np.stack([1.0 - u[rows] - v[rows], u[rows], v[rows]], axis=1, dtype=np.float64)
        uv = np.einsum("nk,nkc->nc", weights, mesh.uvs[mesh.triangles[triangle[rows]]])
        matrix = np.array(record.transform).reshape(2, 3)
        place, levels = uv @ matrix[:, :2].T + matrix[:, 2], _levels(record)
        for row, where in zip(rows, place, strict=True):
            k = min(int(level[row]), len(levels) - 1)
            rest = level[row] - k if k < len(levels) - 1 else 0.0
            space = record.color_space
            color = (1.0 - rest) * linear(_looked_up(levels[k], where, record.wrap), space)
            if rest > 0.0:
                color += rest * linear(_looked_up(levels[k + 1], where, record.wrap), space)
            result[row] *= color
    return result


def _levels(record: BaseColor) -> list[Float]:
    """The image and its means, encoded as it is."""
    assert record.image is not None
    levels = [linear(record.image / 255.0, record.color_space)]
    while max(levels[-1].shape[:2]) > 1:
        height, width = levels[-1].shape[:2]
        rows, columns = _means(height), _means(width)
        levels.append(np.einsum("ah,hwc,bw->abc", rows, levels[-1], columns))
    return [encoded(level, record.color_space) for level in levels]


def linear(value: Float, space: str) -> Float:
    """Linear values of encoded values from 0 to 1."""
    if space == "linear":
        return value
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)


def encoded(value: Float, space: str) -> Float:
    """The inverse of `linear`."""
    if space == "linear":
        return value
    return np.where(value <= 0.0031308, value * 12.92, 1.055 * value ** (1 / 2.4) - 0.055)


def _means(size: int) -> Float:
    """(half, size): the weight of each texel in the mean over each interval."""
    half = max(1, size // 2)
    ends = np.arange(half + 1) * size / half
    texel = np.arange(size)
    covered = np.minimum(ends[1:, None], texel + 1.0) - np.maximum(ends[:-1, None], texel)
    weights: Float = np.clip(covered, 0.0, None) * half / size
    return weights


def _looked_up(level: Float, place: Float, wrap: tuple[str, str]) -> Float:
    height, width = level.shape[:2]
    s, t = place[0] * width - 0.5, place[1] * height - 0.5
    i, j = int(np.floor(s)), int(np.floor(t))
    f, g = s - i, t - j
    columns = [_inside(i + k, width, wrap[0]) for k in (0, 1)]
    rows = [_inside(j + k, height, wrap[1]) for k in (0, 1)]
    upper, lower = ((1.0 - f) * level[r, columns[0]] + f * level[r, columns[1]] for r in rows)
    result: Float = (1.0 - g) * upper + g * lower
    return result


def _inside(texel: int, size: int, wrap: str) -> int:
    """The texel of the image that stands at this one."""
    if wrap == "clamp":
        return min(max(texel, 0), size - 1)
    if wrap == "repeat":
        return texel % size
    m = texel % (2 * size)
    return m if m < size else 2 * size - 1 - m
