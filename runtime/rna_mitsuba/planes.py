"""The triplane of a part in Dr.Jit: spec/RNA.md, 5."""

import drjit as dr
import mitsuba as mi
import numpy as np

from rna_sdk.package import Bounds, Planes, float_planes

_GROUP = 4  # channels that are gathered at once


class Triplane:
    """Features at positions of object space. Texels are float32 in device memory."""

    def __init__(self, planes: Planes, bounds: Bounds) -> None:
        texels = float_planes(planes)
        self._resolution, self._channels = texels.shape[1], texels.shape[3]
        self._groups = -(-self._channels // _GROUP)
        added = self._groups * _GROUP - self._channels
        padded = np.pad(texels, ((0, 0), (0, 0), (0, 0), (0, added)))
        self._texels = mi.Float(padded.ravel())
        self._low, self._high = ([float(x) for x in corner] for corner in bounds.corners())

    def place(self, x: mi.Point3f) -> mi.Vector3f:
        """x in the box of the bounds, each coordinate from 0 to 1."""
        low, high = mi.Vector3f(self._low), mi.Vector3f(self._high)
        return dr.clip((mi.Vector3f(x) - low) / (high - low), 0, 1)

    def features(self, p: mi.Vector3f, active: mi.Bool) -> list[mi.Float]:
        """The sum of bilinear samples of the planes XY, YZ and ZX at p, channel by channel."""
        total = [mi.Vector4f(0) for _ in range(self._groups)]
        for plane in range(3):
            sample = self._sample(plane, p[plane], p[(plane + 1) % 3], active)
            total = [a + b for a, b in zip(total, sample, strict=True)]
        return [total[k // _GROUP][k % _GROUP] for k in range(self._channels)]

    def _sample(self, plane: int, u: mi.Float, v: mi.Float, active: mi.Bool) -> list[mi.Vector4f]:
        size = self._resolution
        s, t = (dr.clip(x * size - 0.5, 0, size - 1) for x in (u, v))
        i, j = mi.UInt32(dr.floor(s)), mi.UInt32(dr.floor(t))
        a, b = s - mi.Float(i), t - mi.Float(j)
        i1, j1 = dr.minimum(i + 1, size - 1), dr.minimum(j + 1, size - 1)
        result = []
        for group in range(self._groups):
            p00, p01, p10, p11 = (
                self._texel(plane, row, column, group, active)
                for row, column in ((j, i), (j, i1), (j1, i), (j1, i1))
            )
            lower, upper = p00 * (1 - a) + p01 * a, p10 * (1 - a) + p11 * a
            result.append(lower * (1 - b) + upper * b)
        return result

    def _texel(
        self, plane: int, row: mi.UInt32, column: mi.UInt32, group: int, active: mi.Bool
    ) -> mi.Vector4f:
        texel = (plane * self._resolution + row) * self._resolution + column
        return dr.gather(mi.Vector4f, self._texels, texel * self._groups + group, active)
