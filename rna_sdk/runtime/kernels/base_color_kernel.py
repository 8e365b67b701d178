"""The compiled kernel that looks up base colours: spec/RNA.md, 4.6."""

import math

import numpy as np
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled

REPEAT, CLAMP, MIRROR = 0, 1, 2

LEVELS = 14
"""Largest number of levels of an image: from 8192 texels a side to 1."""


@compiled(fastmath=())
def _around(x: float, size: int, wrap: int) -> tuple[int, int, float]:
    """The texels that x is between, of `size` along the image's side, and its place between."""
    place = x * size - 0.5
    first = math.floor(place)
    return _inside(first, size, wrap), _inside(first + 1, size, wrap), place - first


@compiled(fastmath=())
def _inside(texel: int, size: int, wrap: int) -> int:
    """The texel of the image that stands at this one."""
    if wrap == CLAMP:
        return min(max(texel, 0), size - 1)
    if wrap == REPEAT:
        return texel % size
    m = texel % (2 * size)
    return m if m < size else 2 * size - 1 - m


@compiled(fastmath=())
def _add_level(
    texels: NDArray[np.uint8],
    is_srgb: bool,
    level: NDArray[np.int64],
    wrap: NDArray[np.int64],
    place: tuple[float, float],
    weight: float,
    color: NDArray[np.float32],
) -> None:
    """Add `weight` times the level's linear colour at a place of the image.

    level: its first texel, height and width. is_srgb: what its values are encoded in.
    """
    left, right, a = _around(place[0], level[2], wrap[0])
    upper, lower, b = _around(place[1], level[1], wrap[1])
    upper, lower = level[0] + upper * level[2], level[0] + lower * level[2]
    corners = upper + left, upper + right, lower + left, lower + right
    weights = (1.0 - a) * (1.0 - b), a * (1.0 - b), (1.0 - a) * b, a * b
    for c in range(3):
        total = 0.0
        for k in range(4):
            total += weights[k] * texels[corners[k], c]
        value = total / 255.0
        if is_srgb:
            value = value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4
        color[c] += np.float32(weight * value)


@compiled(rows="primitives u v widths result", fastmath=())
def look_up(
    primitives: NDArray[np.int64],
    u: NDArray[np.float32],
    v: NDArray[np.float32],
    widths: NDArray[np.float32],
    density: NDArray[np.float32],
    result: NDArray[np.float32],
    uvs: NDArray[np.float32],
    triangles: NDArray[np.uint32],
    record: NDArray[np.int32],
    image: NDArray[np.int64],
    factor: NDArray[np.float32],
    wrap: NDArray[np.int64],
    transform: NDArray[np.float64],
    counts: NDArray[np.int64],
    levels: NDArray[np.int64],
    is_srgb: NDArray[np.bool_],
    texels: NDArray[np.uint8],
) -> None:
    """result (n, 3), of hits: their primitives, u, v and widths.

    record: (t,), the number of each triangle's record, -1 for none; density: (t,), texels a metre.
    Of each record r the image, -1 for none, factor (r, 3), wrap (r, 2), transform (r, 6) and
    is_srgb (r,). counts: (images,) of levels; levels: (images, LEVELS, 3) first texel, height
    and width.
    """
    for i in range(len(primitives)):
        triangle = primitives[i]
        r = record[triangle]
        k = image[r] if r >= 0 else -1
        if k < 0:
            for c in range(3):  # statements of whole arrays take seconds to compile
                result[i, c] = factor[r, c] if r >= 0 else np.float32(1.0)
            continue
        corner, s, t = triangles[triangle], np.float64(u[i]), np.float64(v[i])
        first = 1.0 - s - t
        x = first * uvs[corner[0], 0] + s * uvs[corner[1], 0] + t * uvs[corner[2], 0]
        y = first * uvs[corner[0], 1] + s * uvs[corner[1], 1] + t * uvs[corner[2], 1]
        of = transform[r]
        place = of[0] * x + of[1] * y + of[2], of[3] * x + of[4] * y + of[5]
        texels_wide = widths[i] * density[triangle]
        level = math.log2(texels_wide) if texels_wide > 1.0 else 0.0
        level = min(level, counts[k] - 1.0)
        lower = int(level)
        rest, color = level - lower, result[i]
        for c in range(3):
            color[c] = 0.0
        _add_level(texels, is_srgb[r], levels[k, lower], wrap[r], place, 1.0 - rest, color)
        if rest > 0.0:
            _add_level(texels, is_srgb[r], levels[k, lower + 1], wrap[r], place, rest, color)
        for c in range(3):
            color[c] *= factor[r, c]
