"""Base colour of triangles in Dr.Jit: spec/RNA.md, 4.6."""

from collections.abc import Sequence

import drjit as dr
import mitsuba as mi
import numpy as np

from rna_sdk.package import BaseColor
from rna_sdk.runtime import base_color_levels

_NONE = 0xFFFFFFFF
_LEVELS = 14  # of 8192 texels a side
_REPEAT, _CLAMP, _MIRROR = range(3)
_NUMBERS = {"repeat": _REPEAT, "clamp": _CLAMP, "mirror": _MIRROR}


class BaseColors:
    """Records of a mesh; images and their levels lie in one array of 8 bits."""

    def __init__(self, records: Sequence[BaseColor], triangles: int) -> None:
        number = np.full(triangles, _NONE, np.uint32)
        sizes = np.zeros((len(records), _LEVELS, 3), np.uint32)  # first texel, height, width
        texels = [np.zeros(3, np.uint8)]
        first = 1
        for k, record in enumerate(records):
            number[record.first : record.first + record.count] = k
            levels = base_color_levels(record) if record.image is not None else []
            for j, level in enumerate(levels):
                sizes[k, j:] = first, *level.shape[:2]  # beyond the last level, that one
                texels.append(level.ravel())
                first += level.shape[0] * level.shape[1]
        self._number, self._sizes = mi.UInt32(number), mi.UInt32(sizes.ravel())
        joined = np.concatenate(texels)
        self._texels = mi.UInt8(joined) if hasattr(mi, "UInt8") else mi.Float(joined)
        self._factors = _packed([record.factor for record in records])
        self._transforms = _packed([record.transform for record in records])
        modes = [(*(_NUMBERS[w] for w in r.wrap), r.color_space == "srgb") for r in records]
        self._modes = mi.UInt32(np.array(modes, np.uint32).ravel())

    def at(
        self, triangle: mi.UInt32, uv: mi.Point2f, active: mi.Bool, level: mi.Float | None = None
    ) -> mi.Color3f:
        """Linear RGB of hits at texture coordinates uv. level: of the images; None: themselves."""
        number = dr.gather(mi.UInt32, self._number, triangle, active)
        active = active & (number != _NONE)
        factor = dr.gather(mi.Color3f, self._factors, number, active)
        u, v = (
            dr.dot(dr.gather(mi.Point3f, self._transforms, 2 * number + k, active),
                   mi.Point3f(uv.x, uv.y, 1))
            for k in (0, 1)
        )  # fmt: skip
        modes = dr.gather(mi.Point3u, self._modes, number, active)
        if level is None:
            color = self._in_level(number, mi.UInt32(0), u, v, modes, active)
        else:
            level = dr.clip(level, 0, _LEVELS - 1)
            lower = dr.floor(level)
            near, far = (
                self._in_level(number, mi.UInt32(k), u, v, modes, active)
                for k in (lower, dr.minimum(lower + 1, _LEVELS - 1))
            )
            color = near + (far - near) * (level - lower)
        return dr.select(active, color * factor, 1)

    def _in_level(
        self,
        number: mi.UInt32,
        level: mi.UInt32,
        u: mi.Float,
        v: mi.Float,
        modes: mi.Point3u,
        active: mi.Bool,
    ) -> mi.Color3f:
        """The bilinear lookup of encoded values, made linear; white without an image."""
        size = dr.gather(mi.Point3u, self._sizes, number * _LEVELS + level, active)
        first, height, width = size
        active = active & (width > 0)
        s, t = u * mi.Float(width) - 0.5, v * mi.Float(height) - 0.5
        i, j = dr.floor(s), dr.floor(t)
        f, g = s - i, t - j
        columns = [_inside(i + k, width, modes.x) for k in (0, 1)]
        rows = [_inside(j + k, height, modes.y) for k in (0, 1)]
        color = mi.Color3f(0)
        for row, of_row in zip(rows, (1 - g, g), strict=True):
            for column, of_column in zip(columns, (1 - f, f), strict=True):
                texel = self._texel(first + row * width + column, active)
                color += of_row * of_column * texel
        color = dr.select(modes.z != 0, _linear(color / 255), color / 255)
        return dr.select(width > 0, color, 1)

    def _texel(self, texel: mi.UInt32, active: mi.Bool) -> mi.Color3f:
        kind = type(self._texels)
        places = (3 * texel + k for k in range(3))
        return mi.Color3f(*(mi.Float(dr.gather(kind, self._texels, p, active)) for p in places))


def _linear(c: mi.Color3f) -> mi.Color3f:
    """Linear values of sRGB: IEC 61966-2-1."""
    return dr.select(c <= 0.04045, c / 12.92, dr.power((c + 0.055) / 1.055, 2.4))


def _packed(rows: Sequence[Sequence[float]]) -> mi.Float:
    return mi.Float(np.array(rows, np.float32).ravel())


def _inside(x: mi.Float, count: mi.UInt32, wrap: mi.UInt32) -> mi.UInt32:
    """The texel of the image that stands in column or row x."""
    n = mi.Float(dr.maximum(count, 1))
    period = dr.select(wrap == _MIRROR, 2 * n, n)
    m = x - period * dr.floor(x / period)
    m = dr.select(wrap == _CLAMP, x, dr.select(m < n, m, 2 * n - 1 - m))
    return mi.UInt32(dr.clip(m, 0, n - 1))
