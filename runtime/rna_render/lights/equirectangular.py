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

A light that shares its directions with rays leaves to them what is no brighter than the mean: each
cell's weight is then max(L - mean, 0), with L its mean luminance. Karlik, Sik, Vevoda, Skrivan and
Krivanek, MIS Compensation (TOG 38(6), 2019).
"""

from __future__ import annotations

from copy import copy
from functools import cached_property

import numpy as np
from numba import carray, prange

from rna_render.angles import sine_and_cosine, turns_of
from rna_render.lights.directions import LUMINANCE
from rna_render.lights.intervals import fill_guide, guide_entry, interval_near, place_within
from rna_render.memory import pointer_f32, pointer_f64, pointer_i32
from rna_sdk.compiled import compiled

# What `sample_image` and `look_up_image` read. Addresses of arrays, and the image's size; and
# numbers: the turn about +y, the sum of all cells' weights, the mean that they leave out.
TEXELS, HEIGHTS, ROWS, ROW_GUIDE, COLUMNS, COLUMN_GUIDE, HEIGHT, WIDTH = range(8)
TURN_COSINE, TURN_SINE, TOTAL, MEAN = range(4)

# Compensation that would leave so little of an image is none: what is left would be rounding.
LEAST_LEFT = 1e-3


class EquirectangularImage:
    """Radiance over the sphere.

    texels: (h, w, 3) float32, radiance, finite and not negative; row 0 at +y. angle: radians that
    the image is turned about +y, counter-clockwise seen from above. It keeps texels as they are,
    and 12 bytes a texel for the choice of directions.

    Attributes:
        total: integral of the luminance over the sphere, W / m^2, with the mean of each cell.
        words: (8,) uint64, numbers: (4,) float64, as above; valid as long as the image.
    """

    def __init__(self, texels: np.ndarray, angle: float = 0.0) -> None:
        h, w, _ = texels.shape
        self._texels = np.ascontiguousarray(texels, np.float32)
        edges = np.clip((np.arange(h + 2) - 0.5) / h, 0.0, 1.0)
        # Solid angle of a row's cells over 2 pi / w.
        self._heights = np.cos(np.pi * edges[:-1]) - np.cos(np.pi * edges[1:])
        self._choose(0.0)
        self.total = float(self.numbers[TOTAL]) * 2.0 * np.pi / w
        self._turn(angle)

    def _choose(self, mean: float) -> None:
        """Fill the tables that directions are chosen with."""
        h, w, _ = self._texels.shape
        columns, column_guide = np.empty((h + 1, w + 1)), np.empty((h + 1, w), np.int32)
        _accumulate(self._texels, self._heights, mean, columns)
        fill_guide(columns, column_guide)
        rows, row_guide = np.concatenate([[0.0], np.cumsum(columns[:, -1])]), np.empty(h + 1, "i4")
        fill_guide(rows[None], row_guide[None])
        self._held = self._texels, self._heights, rows, row_guide, columns, column_guide
        addresses = [array.ctypes.data for array in self._held]
        self.words = np.array([*addresses, h, w], np.uint64)
        self.numbers = np.array([1.0, 0.0, rows[-1], mean])

    def _turn(self, angle: float) -> None:
        self.numbers = self.numbers.copy()
        self.numbers[TURN_COSINE], self.numbers[TURN_SINE] = np.cos(angle), np.sin(angle)

    @property
    def tables(self) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """What directions are chosen with, for other devices: texels (h, w, 3) float32, heights of
        rows (h + 1,), running sums of rows (h + 2,) and of each row's cells (h + 1, w + 1)."""
        texels, heights, rows, _, columns, _ = self._held
        return texels, heights, rows, columns

    def turned(self, angle: float) -> EquirectangularImage:
        """The same image, sharing its memory, at another angle."""
        result = copy(self)
        result.__dict__.pop("compensated", None)
        result._turn(angle)
        return result

    @cached_property
    def compensated(self) -> EquirectangularImage:
        """The same image; `sample` leaves out what is no brighter than the mean.

        An image that would have next to nothing left stays as it is.
        """
        result = copy(self)
        mean = self.total / (4.0 * np.pi)
        result._choose(mean)
        if result.numbers[TOTAL] <= LEAST_LEFT * self.numbers[TOTAL]:
            return self
        result.numbers[:TOTAL] = self.numbers[:TOTAL]
        return result

    def sample(self, u: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Directions: unit (n, 3) float32, radiance from there (n, 3) and pdf (n,), float32.

        u: (n, 2) in [0, 1). In a black image the pdf is 0.
        """
        out = _empty_vectors(len(u)), _empty_vectors(len(u)), np.empty(len(u), np.float32)
        _sample_batch(self.numbers, self.words, u, *out)
        return out

    def lookup(self, d_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Radiance from directions, (n, 3) float32, and the density with which `sample` finds them.

        d_world: (n, 3) float32. Returns (n, 3) and (n,), float32.
        """
        out = _empty_vectors(len(d_world)), np.empty(len(d_world), np.float32)
        _look_up_batch(self.numbers, self.words, d_world, *out)
        return out


def _empty_vectors(n: int) -> np.ndarray:
    return np.empty((n, 3), np.float32)


@compiled(fastmath=())
def _luminance(r, g, b):
    return LUMINANCE[0] * r + LUMINANCE[1] * g + LUMINANCE[2] * b


@compiled(fastmath=())
def _cell(texels, row, column):
    """The four texels about a cell."""
    h, w, _ = texels.shape
    upper, lower = max(row - 1, 0), min(row, h - 1)
    right = column + 1 if column < w - 1 else 0
    return (
        _texel(texels, upper, column),
        _texel(texels, upper, right),
        _texel(texels, lower, column),
        _texel(texels, lower, right),
    )


@compiled(fastmath=())
def _texel(texels, row, column):
    r, g, b = texels[row, column, 0], texels[row, column, 1], texels[row, column, 2]
    return np.float64(r), np.float64(g), np.float64(b)


@compiled(fastmath=())
def _luminances(cell):
    a, b, c, d = cell
    return (
        _luminance(a[0], a[1], a[2]),
        _luminance(b[0], b[1], b[2]),
        _luminance(c[0], c[1], c[2]),
        _luminance(d[0], d[1], d[2]),
    )


@compiled(parallel=True, fastmath=())
def _accumulate(texels, heights, mean, columns):
    """Running sums, along each row, of the cells' weights: luminance times the row's height."""
    h, w, _ = texels.shape
    for k in prange(h + 1):
        row, total = np.int64(k), 0.0  # k is unsigned: k - 1 would be a float
        columns[row, 0] = 0.0
        for column in range(w):
            a, b, c, d = _luminances(_cell(texels, row, column))
            total += max((a + b + c + d) / 4.0 - mean, 0.0) * heights[row]
            columns[row, column + 1] = total


@compiled(fastmath=())
def _sample_linear(a, b, u):
    """A place in [0, 1) with density in proportion to a line from a to b, neither negative."""
    root = np.sqrt(a * a + u * (b * b - a * a))
    return u * (a + b) / (a + root) if a + root > 0.0 else u


@compiled(fastmath=())
def _sample_cell(luminances, heights, row, u1, u2):
    """A place in a cell, x and y in [0, 1]."""
    h = len(heights) - 1
    l00, l01, l10, l11 = luminances
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
def _radiance_in_cell(cell, x, y):
    """Bilinear between the corners."""
    a, b, c, d = cell
    wa, wb, wc, wd = (1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y
    return (
        wa * a[0] + wb * b[0] + wc * c[0] + wd * d[0],
        wa * a[1] + wb * b[1] + wc * c[1] + wd * d[1],
        wa * a[2] + wb * b[2] + wc * c[2] + wd * d[2],
    )


@compiled(fastmath=())
def _density(numbers, h, w, height, row, sine, here, mean_here):
    """Density of the direction to a place in a cell, by the luminance there and the cell's mean.

    sine: of its angle to +y. The density is the probability of the cell, times luminance by mean
    luminance there, by the cell's part of the sphere: uniform in cos(theta), or
    2 pi^2 sin(theta) ds dt.
    """
    if not numbers[TOTAL] > 0.0:
        return 0.0
    pdf = here * w / (2.0 * np.pi * numbers[TOTAL])
    if numbers[MEAN] > 0.0:
        pdf *= max(mean_here - numbers[MEAN], 0.0) / mean_here if mean_here > 0.0 else 0.0
    return pdf * height * h / (np.pi * sine) if 0 < row < h else pdf


@compiled(fastmath=())
def _image(words):
    h, w = np.int64(words[HEIGHT]), np.int64(words[WIDTH])
    texels = carray(pointer_f32(words[TEXELS]), (h, w, 3))
    return texels, carray(pointer_f64(words[HEIGHTS]), (h + 1,))


@compiled(fastmath=())
def _choose_cell(words, u1, u2):
    """Row and column of a cell, and a place in the unit square that is left."""
    h, w = np.int64(words[HEIGHT]), np.int64(words[WIDTH])
    rows = carray(pointer_f64(words[ROWS]), (h + 2,))
    row_guide = carray(pointer_i32(words[ROW_GUIDE]), (h + 1,))
    value = u2 * rows[h + 1]
    row = interval_near(rows, row_guide[guide_entry(u2, h + 1)], value)
    y = place_within(rows, row, value)
    columns = carray(pointer_f64(words[COLUMNS]), (h + 1, w + 1))[row]
    column_guide = carray(pointer_i32(words[COLUMN_GUIDE]), (h + 1, w))
    value = u1 * columns[w]
    column = interval_near(columns, column_guide[row, guide_entry(u1, w)], value)
    return row, column, place_within(columns, column, value), y


@compiled(fastmath=())
def sample_image(numbers, words, u1, u2):
    """A direction, the radiance from there, and its density: x, y, z, red, green, blue, pdf."""
    texels, heights = _image(words)
    h, w, _ = texels.shape
    row, column, u1, u2 = _choose_cell(words, u1, u2)
    cell = _cell(texels, row, column)
    luminances = _luminances(cell)
    x, y = _sample_cell(luminances, heights, row, u1, u2)
    sine, cosine = sine_and_cosine((row - 0.5 + y) / (2.0 * h))
    sin_phi, cos_phi = sine_and_cosine((column + 0.5 + x) / w - 0.5)
    away, along = sine * sin_phi, -sine * cos_phi
    r, g, b = _radiance_in_cell(cell, x, y)
    means = (luminances[0] + luminances[1] + luminances[2] + luminances[3]) / 4.0
    here = _luminance(r, g, b)
    pdf = _density(numbers, h, w, heights[row], row, sine, here, means)
    turn_cos, turn_sin = numbers[TURN_COSINE], numbers[TURN_SINE]
    dx, dz = turn_cos * away + turn_sin * along, turn_cos * along - turn_sin * away
    return dx, cosine, dz, r, g, b, pdf


@compiled(fastmath=())
def look_up_image(numbers, words, dx, dy, dz):
    """Radiance from a direction, and the density with which `sample_image` finds it."""
    texels, heights = _image(words)
    h, w, _ = texels.shape
    turn_cos, turn_sin = numbers[TURN_COSINE], numbers[TURN_SINE]
    x, z = turn_cos * dx - turn_sin * dz, turn_sin * dx + turn_cos * dz
    sine = np.sqrt(x * x + z * z)
    s = (0.5 + turns_of(x, -z)) * w - 0.5
    t = turns_of(sine, dy) * 2.0 * h + 0.5
    # A direction that is not a number finds some cell, and radiance that is not a number.
    row = min(max(int(np.floor(t)), 0), h)
    column = int(np.floor(s))
    column = column if 0 <= column < w else w - 1
    cell = _cell(texels, row, column)
    a, b, c, d = _luminances(cell)
    red, green, blue = _radiance_in_cell(cell, s - np.floor(s), t - row)
    here, mean = _luminance(red, green, blue), (a + b + c + d) / 4.0
    return red, green, blue, _density(numbers, h, w, heights[row], row, sine, here, mean)


@compiled(parallel=True, fastmath=())
def _sample_batch(numbers, words, u, d_world, radiance, pdf):
    for i in prange(len(u)):
        x, y, z, r, g, b, pdf[i] = sample_image(numbers, words, u[i, 0], u[i, 1])
        d_world[i, 0], d_world[i, 1], d_world[i, 2] = x, y, z
        radiance[i, 0], radiance[i, 1], radiance[i, 2] = r, g, b


@compiled(parallel=True, fastmath=())
def _look_up_batch(numbers, words, d_world, radiance, pdf):
    for i in prange(len(pdf)):
        d = np.float64(d_world[i, 0]), np.float64(d_world[i, 1]), np.float64(d_world[i, 2])
        r, g, b, pdf[i] = look_up_image(numbers, words, d[0], d[1], d[2])
        radiance[i, 0], radiance[i, 1], radiance[i, 2] = r, g, b
