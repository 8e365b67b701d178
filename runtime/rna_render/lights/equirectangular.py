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
from numba import prange

from rna_render.lights.directions import LUMINANCE
from rna_render.lights.intervals import fill_guide, guide_entry, interval_near, place_within
from rna_sdk.compiled import compiled

# Samples in one unit of parallel work, which goes through them once for each table: while one
# sample waits for memory, the next ones already ask for theirs.
CHUNK = 256


class EquirectangularImage:
    """Radiance over the sphere.

    texels: (h, w, 3) float32, radiance, finite and not negative; row 0 at +y. angle: radians that
    the image is turned about +y, counter-clockwise seen from above. It keeps texels as they are,
    and 12 bytes a texel for the choice of directions.

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
        self._column_guide = np.empty((h + 1, w), np.int32)
        fill_guide(self._columns, self._column_guide)
        self._row_guide = np.empty((1, h + 1), np.int32)
        fill_guide(self._rows[None], self._row_guide)
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
        out = _empty_vectors(len(u)), _empty_vectors(len(u)), np.empty(len(u), np.float32)
        rows, columns = (self._rows, self._row_guide[0]), (self._columns, self._column_guide)
        _sample_image(self._texels, self._turn, self._heights, *rows, *columns, u, *out)
        return out

    def lookup(self, d_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Radiance from directions, (n, 3) float32, and the density with which `sample` finds them.

        d_world: (n, 3) float32. Returns (n, 3) and (n,), float32.
        """
        out = _empty_vectors(len(d_world)), np.empty(len(d_world), np.float32)
        _lookup_image(self._texels, self._turn, self._heights, self._rows[-1], d_world, *out)
        return out


def _empty_vectors(n: int) -> np.ndarray:
    return np.empty((n, 3), np.float32)


@compiled(fastmath=())
def _luminance(texel):
    return LUMINANCE[0] * texel[0] + LUMINANCE[1] * texel[1] + LUMINANCE[2] * texel[2]


@compiled(fastmath=())
def _corners(row, column, h, w):
    """Rows and columns of the four texels about a cell."""
    return max(row - 1, 0), min(row, h - 1), column, column + 1 if column < w - 1 else 0


@compiled(parallel=True, fastmath=())
def _accumulate(texels, heights, columns):
    """Running sums, along each row, of the cells' mean luminance times the row's height."""
    h, w, _ = texels.shape
    for k in prange(h + 1):
        row, total = np.int64(k), 0.0  # k is unsigned: k - 1 would be a float
        columns[row, 0] = 0.0
        for column in range(w):
            r0, r1, c0, c1 = _corners(row, column, h, w)
            sum4 = _luminance(texels[r0, c0]) + _luminance(texels[r0, c1])
            sum4 += _luminance(texels[r1, c0]) + _luminance(texels[r1, c1])
            total += sum4 / 4.0 * heights[row]
            columns[row, column + 1] = total


@compiled(fastmath=())
def _choose_cells(rows, row_guide, columns, column_guide, u, row, column, places):
    """Row and column of a cell for each u, and a place in the unit square that it leaves."""
    count, w = len(row_guide), column_guide.shape[1]
    for i in range(len(u)):
        value = u[i, 1] * rows[count]
        row[i] = interval_near(rows, row_guide[guide_entry(u[i, 1], count)], value)
        places[i, 1] = place_within(rows, row[i], value)
    for i in range(len(u)):
        column[i] = column_guide[row[i], guide_entry(u[i, 0], w)]
    for i in range(len(u)):
        cumulative = columns[row[i]]
        value = u[i, 0] * cumulative[w]
        column[i] = interval_near(cumulative, column[i], value)
        places[i, 0] = place_within(cumulative, column[i], value)


@compiled(fastmath=())
def _sample_linear(a, b, u):
    """A place in [0, 1) with density in proportion to a line from a to b, neither negative."""
    root = np.sqrt(a * a + u * (b * b - a * a))
    return u * (a + b) / (a + root) if a + root > 0.0 else u


@compiled(fastmath=())
def _gather(texels, row, column, corners):
    """Write the four texels about a cell, (4, 3)."""
    r0, r1, c0, c1 = _corners(row, column, texels.shape[0], texels.shape[1])
    for channel in range(3):
        corners[0, channel], corners[1, channel] = texels[r0, c0, channel], texels[r0, c1, channel]
        corners[2, channel], corners[3, channel] = texels[r1, c0, channel], texels[r1, c1, channel]


@compiled(fastmath=())
def _sample_cell(corners, heights, row, u1, u2):
    """A place in a cell, x and y in [0, 1]."""
    h = len(heights) - 1
    l00, l01 = _luminance(corners[0]), _luminance(corners[1])
    l10, l11 = _luminance(corners[2]), _luminance(corners[3])
    if row == 0:
        y = _cap_angle(u2 * heights[0]) / np.pi * h + 0.5
    elif row == h:
        y = 0.5 - _cap_angle(u2 * heights[h]) / np.pi * h
    else:
        y = _sample_linear(l00 + l01, l10 + l11, u2)
    return _sample_linear(l00 + y * (l10 - l00), l01 + y * (l11 - l01), u1), y


@compiled(fastmath=())
def _cap_angle(one_minus_cosine):
    return 2.0 * np.arcsin(np.sqrt(one_minus_cosine / 2.0))


@compiled(fastmath=())
def _look_up(corners, heights, w, total, row, x, y, sine, radiance):
    """Write the radiance at a place in a cell; returns the density of its direction.

    sine: of its angle to +y. The density is the probability of the cell, times luminance by mean
    luminance there, by the cell's part of the sphere: uniform in cos(theta), or
    2 pi^2 sin(theta) ds dt.
    """
    h = len(heights) - 1
    luminance = 0.0
    for channel in range(3):
        top = corners[0, channel] * (1.0 - x) + corners[1, channel] * x
        bottom = corners[2, channel] * (1.0 - x) + corners[3, channel] * x
        value = top * (1.0 - y) + bottom * y
        radiance[channel] = value
        luminance += LUMINANCE[channel] * value
    pdf = luminance * w / (2.0 * np.pi * total) if total > 0.0 else 0.0
    return pdf * heights[row] * h / (np.pi * sine) if 0 < row < h else pdf


@compiled(parallel=True, fastmath=())
def _sample_image(
    texels, turn, heights, rows, row_guide, columns, column_guide, u, d_world, radiance, pdf
):
    h, w, _ = texels.shape
    n = len(u)
    for chunk in prange((n + CHUNK - 1) // CHUNK):
        first = chunk * CHUNK
        count = min(CHUNK, n - first)
        row, column = np.empty(count, np.int64), np.empty(count, np.int64)
        places, corners = np.empty((count, 2)), np.empty((count, 4, 3), np.float32)
        tables = rows, row_guide, columns, column_guide
        _choose_cells(*tables, u[first : first + count], row, column, places)
        for k in range(count):
            _gather(texels, row[k], column[k], corners[k])
        for k in range(count):
            i = first + k
            x, y = _sample_cell(corners[k], heights, row[k], places[k, 0], places[k, 1])
            phi = 2.0 * np.pi * ((column[k] + 0.5 + x) / w - 0.5)
            theta = np.pi * (row[k] - 0.5 + y) / h
            sine = np.sin(theta)
            away, along = sine * np.sin(phi), -sine * np.cos(phi)
            d_world[i, 0] = turn[0] * away + turn[1] * along
            d_world[i, 1] = np.cos(theta)
            d_world[i, 2] = turn[0] * along - turn[1] * away
            place = row[k], x, y, sine
            pdf[i] = _look_up(corners[k], heights, w, rows[h + 1], *place, radiance[i])


@compiled(parallel=True, fastmath=())
def _lookup_image(texels, turn, heights, total, d_world, radiance, pdf):
    h, w, _ = texels.shape
    n = len(pdf)
    for chunk in prange((n + CHUNK - 1) // CHUNK):
        corners = np.empty((4, 3), np.float32)
        for i in range(chunk * CHUNK, min(n, (chunk + 1) * CHUNK)):
            dx, dy, dz = d_world[i, 0], d_world[i, 1], d_world[i, 2]
            x, z = turn[0] * dx - turn[1] * dz, turn[1] * dx + turn[0] * dz
            sine = np.sqrt(x * x + z * z)
            s = (0.5 + np.arctan2(x, -z) / (2.0 * np.pi)) * w - 0.5
            t = np.arctan2(sine, np.float64(dy)) / np.pi * h + 0.5
            # A direction that is not a number finds some cell, and radiance that is not a number.
            row = min(max(int(np.floor(t)), 0), h)
            column = int(np.floor(s))
            column = column if 0 <= column < w else w - 1
            _gather(texels, row, column, corners)
            place = row, s - np.floor(s), t - row, sine
            pdf[i] = _look_up(corners, heights, w, total, *place, radiance[i])
