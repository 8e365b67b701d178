"""Textures of triangles in Dr.Jit: transmittance and normal maps, spec/RNA.md, 4.4, 4.5."""

from collections.abc import Sequence

import drjit as dr
import mitsuba as mi
import numpy as np

from rna_mitsuba.vectors import length
from rna_sdk.package import NormalMap, Transmittance

_NONE = 0xFFFFFFFF
_NO_CUTOFF, _NO_IOR = -1.0, 0.0


class _Textures:
    """Records of triangles with a texture each; all texels lie in one array."""

    def __init__(self, records: Sequence[NormalMap | Transmittance], triangles: int) -> None:
        number = np.full(triangles, _NONE, np.uint32)
        for k, record in enumerate(records):
            number[record.first : record.first + record.count] = k
        self._number = mi.UInt32(number)
        shapes = np.array([record.texture.shape for record in records], np.uint32)
        starts = np.cumsum([0, *shapes.prod(axis=1)])[:-1].astype(np.uint32)
        self._sizes = mi.UInt32(np.column_stack([starts, shapes]).ravel())
        texels = np.concatenate([record.texture.ravel() for record in records])
        self._texels = mi.UInt8(texels) if hasattr(mi, "UInt8") else mi.Float(texels)

    def _record(
        self, triangle: mi.UInt32, active: mi.Bool
    ) -> tuple[mi.UInt32, mi.Point4u, mi.Bool]:
        """Number, (start, height, width, channels), and whether there is a record."""
        number = dr.gather(mi.UInt32, self._number, triangle, active)
        active = active & (number != _NONE)
        return number, dr.gather(mi.Point4u, self._sizes, number, active), active

    def _looked_up(
        self, size: mi.Point4u, uv: mi.Point2f, channel: mi.UInt32, active: mi.Bool
    ) -> mi.Float:
        """The bilinear lookup of 4.4, repeated: from 0 to 255."""
        start, height, width, channels = size
        s, t = uv.x * mi.Float(width) - 0.5, uv.y * mi.Float(height) - 0.5
        i, j = dr.floor(s), dr.floor(t)
        f, g = s - i, t - j
        left, right = _repeated(i, width), _repeated(i + 1, width)
        upper, lower = _repeated(j, height), _repeated(j + 1, height)

        def texel(row: mi.UInt32, column: mi.UInt32) -> mi.Float:
            place = start + (row * width + column) * channels + channel
            return mi.Float(dr.gather(type(self._texels), self._texels, place, active))

        above = (1 - f) * texel(upper, left) + f * texel(upper, right)
        below = (1 - f) * texel(lower, left) + f * texel(lower, right)
        return (1 - g) * above + g * below


def _repeated(x: mi.Float, count: mi.UInt32) -> mi.UInt32:
    """A whole number modulo count."""
    size = mi.Float(count)
    rest = x - size * dr.floor(x / size)
    return dr.minimum(mi.UInt32(dr.maximum(rest, 0)), dr.maximum(count, 1) - 1)


class TransmittanceTextures(_Textures):
    """Holes and thin glass."""

    def __init__(self, records: Sequence[Transmittance], triangles: int) -> None:
        super().__init__(records, triangles)
        rows = [
            (_NO_CUTOFF if r.cutoff is None else r.cutoff, *(r.ior or (_NO_IOR, _NO_IOR)))
            for r in records
        ]
        self._numbers = mi.Float(np.array(rows, np.float32).ravel())

    def at(
        self,
        triangle: mi.UInt32,
        uv: mi.Point2f,
        cosine: mi.Float,
        is_front: mi.Bool,
        active: mi.Bool,
    ) -> mi.Color3f:
        """tau; cosine: |n . d| of the ray, is_front: which side of the triangle it meets."""
        number, size, active = self._record(triangle, active)
        numbers = dr.gather(mi.Point3f, self._numbers, number, active)
        cutoff, ior = numbers.x, dr.select(is_front, numbers.y, numbers.z)
        passed = dr.select(ior == _NO_IOR, 1, 1 - _fresnel(ior, cosine))
        channels = []
        for channel in range(3):
            at = dr.minimum(mi.UInt32(channel), dr.maximum(size[3], 1) - 1)
            value = self._looked_up(size, uv, at, active) / 255
            hole = dr.select(value > cutoff, mi.Float(1), 0)
            channels.append(dr.select(cutoff == _NO_CUTOFF, value, hole) * passed)
        return dr.select(active, mi.Color3f(*channels), 0)


def _fresnel(eta: mi.Float, c: mi.Float) -> mi.Float:
    """Reflectance of unpolarised light at relative index eta, for the cosine c."""
    g2 = eta * eta - 1 + c * c
    g = dr.sqrt(dr.maximum(g2, 1e-20))
    p = (c * (g + c) - 1) / (c * (g - c) + 1)
    value = dr.square((g - c) / (g + c)) * (1 + p * p) / 2
    return dr.select(g2 <= 0, 1, dr.clip(value, 0, 1))


class NormalTextures(_Textures):
    """Relief."""

    def mapped(
        self,
        triangle: mi.UInt32,
        n: mi.Vector3f,
        p: list[mi.Point3f],
        uv_k: list[mi.Point2f],
        uv: mi.Point2f,
        active: mi.Bool,
    ) -> mi.Vector3f:
        """The mapped normal. p, uv_k: of the corners; n, uv: of the hit."""
        _, size, active = self._record(triangle, active)
        e1, e2 = p[1] - p[0], p[2] - p[0]
        d1, d2 = uv_k[1] - uv_k[0], uv_k[2] - uv_k[0]
        area = d1.x * d2.y - d2.x * d1.y
        along_u = mi.Vector3f(d2.y * e1 - d1.y * e2) * dr.sign(area)
        along_v = mi.Vector3f(d1.x * e2 - d2.x * e1) * dr.sign(area)
        t = along_u - dr.dot(along_u, n) * n
        size_t = length(t)
        usable = active & (area != 0) & (size_t > 1e-6 * length(along_u))
        t = t / dr.select(usable, size_t, 1)
        b = dr.cross(n, t)
        b = dr.select(dr.dot(b, along_v) > 0, -b, b)
        x, y = ((self._looked_up(size, uv, mi.UInt32(k), active) - 127) / 127 for k in range(2))
        z2 = 1 - x * x - y * y
        z = dr.select(z2 > 0, dr.sqrt(dr.select(z2 > 0, z2, 1)), 0)
        m = x * t + y * b + z * n
        size_m = length(m)
        usable &= size_m > 1e-6
        return dr.select(usable, m / dr.select(usable, size_m, 1), n)
