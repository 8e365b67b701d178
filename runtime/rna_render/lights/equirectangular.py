"""An equirectangular image as a function of directions, and directions in proportion to it.

Image coordinates (s, t) in [0, 1]^2 from the top left corner: t = theta / pi from +y, and
s = 1/2 + atan2(x, -z) / (2 pi), so the middle is -z and the right half lies towards +x. Radiance
is bilinear between the middles of texels, around the seam too; beyond the middles of the first
and the last row it is constant along t.

Between four neighbouring middles lies a cell; w of them make a row, and the rows number h + 1,
the first and the last of half the height. A sample chooses a row and then a cell of it by the
cell's mean luminance times the row's solid angle, and in the cell a point (s, t) in proportion to
the bilinear luminance. So the density follows the very function that is looked up. In the rows at
the poles, where that is constant along t, points are uniform in cos(theta) instead: else the
density per steradian would grow without bound.
"""

from __future__ import annotations

from copy import copy

import numpy as np
from numba import njit, prange

from rna_render.lights.directions import LUMINANCE
from rna_render.lights.mesh import find_interval


class EquirectangularImage:
    """Radiance over the sphere.

    texels: (h, w, 3) float32, radiance, finite and not negative; row 0 at +y. angle: radians that
    the image is turned about +y, counter-clockwise seen from above. It keeps texels as they are,
    and 8 bytes a texel for the choice of directions.

    total: integral of the luminance over the sphere, W / m^2, with the mean of each cell.
    """

    def __init__(self, texels: np.ndarray, angle: float = 0.0) -> None:
        h, w, _ = texels.shape
        self._texels = np.ascontiguousarray(texels, np.float32)
        self._turn = np.array([np.cos(angle), np.sin(angle)])
        edges = np.clip((np.arange(h + 2) - 0.5) / h, 0.0, 1.0)
        # Solid angle of a row's cells over 2 pi / w.
        self._heights = np.cos(np.pi * edges[:-1]) - np.cos(np.pi * edges[1:])
        self._columns = np.empty((h + 1, w + 1))
        _accumulate(self._texels, self._heights, self._columns)
        self._rows = np.concatenate([[0.0], np.cumsum(self._columns[:, -1])])
        self.total = float(self._rows[-1]) * 2.0 * np.pi / w

    def turned(self, angle: float) -> EquirectangularImage:
        """The same image, sharing its memory, at another angle."""
        result = copy(self)
        result._turn = np.array([np.cos(angle), np.sin(angle)])
        return result

    def sample(self, u: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Directions: unit (n, 3) float32, radiance from there (n, 3) and pdf (n,), float32.

        u: (n, 2) in [0, 1). In a black image the pdf is 0.
        """
        d_world = np.empty((len(u), 3), np.float32)
        tables = self._heights, self._rows, self._columns
        _sample_image(self._texels, self._turn, *tables, u, d_world)
        return d_world, *self.lookup(d_world)

    def lookup(self, d_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Radiance from directions, (n, 3) float32, and the density with which `sample` finds them.

        d_world: (n, 3) float32. Returns (n, 3) and (n,), float32.
        """
        radiance = np.empty((len(d_world), 3), np.float32)
        pdf = np.empty(len(d_world), np.float32)
        total = self._rows[-1]
        _lookup_image(self._texels, self._turn, self._heights, total, d_world, radiance, pdf)
        return radiance, pdf


@njit(cache=True)
def _luminance(texels, row, column):
    texel = texels[row, column]
    return LUMINANCE[0] * texel[0] + LUMINANCE[1] * texel[1] + LUMINANCE[2] * texel[2]


@njit(cache=True)
def _corners(row, column, h, w):
    """Rows and columns of the four texels about a cell."""
    return max(row - 1, 0), min(row, h - 1), column, (column + 1) % w


@njit(cache=True, parallel=True, nogil=True)
def _accumulate(texels, heights, columns):
    """Running sums, along each row, of the cells' mean luminance times the row's height."""
    h, w, _ = texels.shape
    for k in prange(h + 1):
        row, total = np.int64(k), 0.0  # k is unsigned: k - 1 would be a float
        columns[row, 0] = 0.0
        for column in range(w):
            r0, r1, c0, c1 = _corners(row, column, h, w)
            sum4 = _luminance(texels, r0, c0) + _luminance(texels, r0, c1)
            sum4 += _luminance(texels, r1, c0) + _luminance(texels, r1, c1)
            total += sum4 / 4.0 * heights[row]
            columns[row, column + 1] = total


@njit(cache=True)
def _sample_linear(a, b, u):
    """A place in [0, 1) with density in proportion to a line from a to b, neither negative."""
    root = np.sqrt(a * a + u * (b * b - a * a))
    return u * (a + b) / (a + root) if a + root > 0.0 else u


@njit(cache=True)
def _sample_place(texels, heights, rows, columns, u1, u2):
    """Image coordinates (s, t) for a point of the unit square."""
    h, w, _ = texels.shape
    row, u2 = find_interval(rows, u2)
    column, u1 = find_interval(columns[row], u1)
    r0, r1, c0, c1 = _corners(row, column, h, w)
    l00, l01 = _luminance(texels, r0, c0), _luminance(texels, r0, c1)
    l10, l11 = _luminance(texels, r1, c0), _luminance(texels, r1, c1)
    y = _sample_linear(l00 + l01, l10 + l11, u2)
    x = _sample_linear(l00 + y * (l10 - l00), l01 + y * (l11 - l01), u1)
    s, t = (column + 0.5 + x) / w, (row - 0.5 + y) / h
    if row == 0:
        t = _cap_angle(u2 * heights[0]) / np.pi
    elif row == h:
        t = 1.0 - _cap_angle(u2 * heights[h]) / np.pi
    return s, t


@njit(cache=True)
def _cap_angle(one_minus_cosine):
    return 2.0 * np.arcsin(np.sqrt(one_minus_cosine / 2.0))


@njit(cache=True, parallel=True, nogil=True)
def _sample_image(texels, turn, heights, rows, columns, u, d_world):
    for i in prange(len(u)):
        s, t = _sample_place(texels, heights, rows, columns, u[i, 0], u[i, 1])
        phi, theta = 2.0 * np.pi * (s - 0.5), np.pi * t
        sine = np.sin(theta)
        x, z = sine * np.sin(phi), -sine * np.cos(phi)
        d_world[i, 0] = turn[0] * x + turn[1] * z
        d_world[i, 1] = np.cos(theta)
        d_world[i, 2] = turn[0] * z - turn[1] * x


@njit(cache=True, parallel=True, nogil=True)
def _lookup_image(texels, turn, heights, total, d_world, radiance, pdf):
    h, w, _ = texels.shape
    for i in prange(len(d_world)):
        dx, dy, dz = d_world[i, 0], d_world[i, 1], d_world[i, 2]
        x, z = turn[0] * dx - turn[1] * dz, turn[1] * dx + turn[0] * dz
        sine = np.sqrt(x * x + z * z)
        s = (0.5 + np.arctan2(x, -z) / (2.0 * np.pi)) * w - 0.5
        t = np.arctan2(sine, np.float64(dy)) / np.pi * h + 0.5
        # A direction that is not a number finds some cell, and radiance that is not a number.
        row = min(max(int(np.floor(t)), 0), h)
        column = int(np.floor(s)) % w
        b, a = t - row, s - np.floor(s)
        r0, r1, c0, c1 = _corners(row, column, h, w)
        luminance = 0.0
        for channel in range(3):
            top = texels[r0, c0, channel] * (1.0 - a) + texels[r0, c1, channel] * a
            bottom = texels[r1, c0, channel] * (1.0 - a) + texels[r1, c1, channel] * a
            value = top * (1.0 - b) + bottom * b
            radiance[i, channel] = value
            luminance += LUMINANCE[channel] * value
        # Probability of the cell, luminance by mean luminance there, and the cell's part of the
        # sphere: uniform in cos(theta), or 2 pi^2 sin(theta) ds dt.
        pdf[i] = luminance * w / (2.0 * np.pi * total) if total > 0.0 else 0.0
        if 0 < row < h:
            pdf[i] *= heights[row] * h / (np.pi * sine)
