"""Compiled code of `equirectangular`: cells of an image, directions and radiance.

Directions are sampled and looked up in blocks, one access at a time for a whole block: the tables
do not fit a core's cache, and so a core waits for many numbers at once.
"""

import numpy as np
from numba import carray  # type: ignore[attr-defined]

from rna_render.lights.directions import LUMINANCE
from rna_render.lights.intervals import guide_entry, interval_near, place_within
from rna_sdk.machine.compiled import compiled
from rna_trace.angles import sine_and_cosine, turns_of
from rna_trace.memory import pointer_f32, pointer_f64, pointer_i32, signed
from rna_trace.vectors import Vector

# What `sample_image_batch` and `look_up_image_batch` read. Addresses of arrays, and the image's
# size; and numbers: the turn about +y, the sum of all cells' weights, the mean that they leave out.
TEXELS, HEIGHTS, ROWS, ROW_GUIDE, COLUMNS, COLUMN_GUIDE, HEIGHT, WIDTH = range(8)
IMAGE_NUMBERS = "turn_cosine", "turn_sine", "total", "mean"
TURN_COSINE, TURN_SINE, TOTAL, MEAN = range(4)

# Entries of a guide for each interval. The more there are, the fewer steps are left to guess.
ROW_FINENESS, COLUMN_FINENESS = 8, 4

# Directions that are handled together.
BLOCK = 64

# Rows of a block's numbers: colours of a cell's four corners, then these. In the end they begin
# with the direction, the radiance and the density.
U1, U2, ROW, COLUMN, CELL_HEIGHT, CAP_Y, SINE = range(12, 19)
BLOCK_ROWS = 19


Cell = tuple[Vector, Vector, Vector, Vector]
"""Colours of the texels at its corners."""


@compiled(fastmath=())
def _luminance(r: float, g: float, b: float) -> float:
    return float(LUMINANCE[0] * r + LUMINANCE[1] * g + LUMINANCE[2] * b)


@compiled(fastmath=())
def _cell(texels: np.ndarray, row: int, column: int) -> Cell:
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
def _texel(texels: np.ndarray, row: int, column: int) -> Vector:
    r, g, b = texels[row, column, 0], texels[row, column, 1], texels[row, column, 2]
    return np.float64(r), np.float64(g), np.float64(b)


@compiled(fastmath=())
def _luminances(cell: Cell) -> tuple[float, float, float, float]:
    a, b, c, d = cell
    return (
        _luminance(a[0], a[1], a[2]),
        _luminance(b[0], b[1], b[2]),
        _luminance(c[0], c[1], c[2]),
        _luminance(d[0], d[1], d[2]),
    )


@compiled(rows="numbers heights columns", step=16, fastmath=())
def sums_of_cells(
    texels: np.ndarray,
    numbers: np.ndarray,
    heights: np.ndarray,
    mean: float,
    columns: np.ndarray,
) -> None:
    """Running sums, along each row, of the cells' weights: luminance times the row's height.

    numbers: of the rows of cells whose heights and sums the others are.
    """
    w = texels.shape[1]
    for k in range(len(numbers)):
        row, total = numbers[k], 0.0
        columns[k, 0] = 0.0
        for column in range(w):
            a, b, c, d = _luminances(_cell(texels, row, column))
            total += max((a + b + c + d) / 4.0 - mean, 0.0) * heights[k]
            columns[k, column + 1] = total


@compiled(fastmath=())
def _sample_linear(a: float, b: float, u: float) -> float:
    """A place in [0, 1) with density in proportion to a line from a to b, neither negative."""
    root = np.sqrt(a * a + u * (b * b - a * a))
    return u * (a + b) / (a + root) if a + root > 0.0 else u


@compiled(fastmath=())
def _cap_angle(one_minus_cosine: float) -> float:
    return float(2.0 * np.arcsin(np.sqrt(one_minus_cosine / 2.0)))


@compiled(fastmath=())
def _radiance_in_cell(cell: Cell, x: float, y: float) -> Vector:
    """Bilinear between the corners."""
    a, b, c, d = cell
    wa, wb, wc, wd = (1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y
    return (
        wa * a[0] + wb * b[0] + wc * c[0] + wd * d[0],
        wa * a[1] + wb * b[1] + wc * c[1] + wd * d[1],
        wa * a[2] + wb * b[2] + wc * c[2] + wd * d[2],
    )


@compiled(fastmath=())
def _density(
    numbers: np.ndarray,
    h: int,
    w: int,
    cell: tuple[float, bool, float],
    here: float,
    mean_here: float,
) -> float:
    """Density of the direction to a place in a cell, by the luminance there and the cell's mean.

    cell: its height, whether it is not at a pole, and the sine of the place's angle to +y. The
    density is the probability of the cell, times luminance by mean luminance there, by the cell's
    part of the sphere: uniform in cos(theta), or 2 pi^2 sin(theta) ds dt.
    """
    height, inner, sine = cell
    pdf = here * w / (2.0 * np.pi * numbers[TOTAL])
    left = max(mean_here - numbers[MEAN], 0.0) / mean_here if mean_here > 0.0 else 0.0
    pdf *= left if numbers[MEAN] > 0.0 else 1.0
    pdf = pdf * height * h / (np.pi * sine) if inner else pdf
    return pdf if numbers[TOTAL] > 0.0 else 0.0


@compiled(fastmath=())
def _image(words: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    h, w = signed(words[HEIGHT]), signed(words[WIDTH])
    texels = carray(pointer_f32(words[TEXELS]), (h, w, 3))
    return texels, carray(pointer_f64(words[HEIGHTS]), (h + 1,))


@compiled(fastmath=())
def _choose_rows(words: np.ndarray, u: np.ndarray, row: np.ndarray, place: np.ndarray) -> None:
    """Choose rows of cells; column 1 of place gets the remapped second random numbers."""
    h = signed(words[HEIGHT])
    rows = carray(pointer_f64(words[ROWS]), (h + 2,))
    guide = carray(pointer_i32(words[ROW_GUIDE]), (ROW_FINENESS * (h + 1),))
    for i in range(len(u)):
        value = u[i, 1] * rows[h + 1]
        row[i] = interval_near(rows, guide[guide_entry(u[i, 1], len(guide))], value)
        place[i, 1] = place_within(rows, row[i], value)


@compiled(fastmath=())
def _choose_columns(
    words: np.ndarray, u: np.ndarray, row: np.ndarray, column: np.ndarray, place: np.ndarray
) -> None:
    """Choose cells in their rows; column 0 of place gets the remapped first random numbers."""
    h, w = signed(words[HEIGHT]), signed(words[WIDTH])
    columns = carray(pointer_f64(words[COLUMNS]), (h + 1, w + 1))
    guide = carray(pointer_i32(words[COLUMN_GUIDE]), (h + 1, COLUMN_FINENESS * w))
    for i in range(len(u)):
        column[i] = guide[row[i], guide_entry(u[i, 0], COLUMN_FINENESS * w)]
    for i in range(len(u)):  # nothing but loads that depend on no comparison
        place[i, 0] = columns[row[i], column[i]]
    for i in range(len(u)):
        sums = columns[row[i]]
        value = u[i, 0] * sums[w]
        column[i] = interval_near(sums, column[i], value)
        place[i, 0] = place_within(sums, column[i], value)


@compiled(fastmath=())
def _block_cell(block: np.ndarray, i: int) -> Cell:
    return (
        (block[0, i], block[1, i], block[2, i]),
        (block[3, i], block[4, i], block[5, i]),
        (block[6, i], block[7, i], block[8, i]),
        (block[9, i], block[10, i], block[11, i]),
    )


@compiled(fastmath=())
def _take_corners(
    texels: np.ndarray, heights: np.ndarray, row: np.ndarray, column: np.ndarray, block: np.ndarray
) -> None:
    """Colours of the cells' corners, and their rows, columns and heights."""
    h, w, _ = texels.shape
    for i in range(len(row)):
        upper, lower = max(row[i] - 1, 0), min(row[i], h - 1)
        left = column[i]
        right = left + 1 if left < w - 1 else 0
        for k in range(3):
            block[k, i], block[3 + k, i] = texels[upper, left, k], texels[upper, right, k]
            block[6 + k, i], block[9 + k, i] = texels[lower, left, k], texels[lower, right, k]
        block[ROW, i], block[COLUMN, i], block[CELL_HEIGHT, i] = row[i], left, heights[row[i]]


@compiled(fastmath=())
def _take_cells(
    texels: np.ndarray,
    heights: np.ndarray,
    row: np.ndarray,
    column: np.ndarray,
    place: np.ndarray,
    block: np.ndarray,
) -> None:
    """Numbers of the cells, column by column, and places in the rows at the poles."""
    h = len(texels)
    _take_corners(texels, heights, row, column, block)
    for i in range(len(row)):
        block[U1, i], block[U2, i] = place[i, 0], place[i, 1]
        if row[i] == 0:
            block[CAP_Y, i] = _cap_angle(place[i, 1] * heights[0]) / np.pi * h + 0.5
        elif row[i] == h:
            block[CAP_Y, i] = 0.5 - _cap_angle(place[i, 1] * heights[h]) / np.pi * h


@compiled(fastmath=())
def _directions_in_cells(
    numbers: np.ndarray, h: int, w: int, count: int, block: np.ndarray
) -> None:
    """Directions, radiance and densities of a block, in place of its first rows.

    Without branches or calls, so that the compiler takes several directions at once.
    """
    turn_cos, turn_sin = numbers[TURN_COSINE], numbers[TURN_SINE]
    for i in range(count):
        cell = _block_cell(block, i)
        l00, l01, l10, l11 = _luminances(cell)
        row, column = block[ROW, i], block[COLUMN, i]
        inner = 0.0 < row < h
        y = _sample_linear(l00 + l01, l10 + l11, block[U2, i])
        y = y if inner else block[CAP_Y, i]
        x = _sample_linear(l00 + y * (l10 - l00), l01 + y * (l11 - l01), block[U1, i])
        sine, cosine = sine_and_cosine((row - 0.5 + y) / (2.0 * h))
        sin_phi, cos_phi = sine_and_cosine((column + 0.5 + x) / w - 0.5)
        away, along = sine * sin_phi, -sine * cos_phi
        r, g, b = _radiance_in_cell(cell, x, y)
        mean = (l00 + l01 + l10 + l11) / 4.0
        at = block[CELL_HEIGHT, i], inner, sine
        block[6, i] = _density(numbers, h, w, at, _luminance(r, g, b), mean)
        block[0, i], block[1, i] = turn_cos * away + turn_sin * along, cosine
        block[2, i] = turn_cos * along - turn_sin * away
        block[3, i], block[4, i], block[5, i] = r, g, b


@compiled(fastmath=())
def sample_image_batch(
    scale: np.ndarray,
    numbers: np.ndarray,
    words: np.ndarray,
    u: np.ndarray,
    d_world: np.ndarray,
    radiance: np.ndarray,
    pdf: np.ndarray,
) -> None:
    """Directions for u, (n, 2), the radiance from there times `scale`, and their densities."""
    texels, heights = _image(words)
    h, w, _ = texels.shape
    row, column = np.empty(BLOCK, np.int64), np.empty(BLOCK, np.int64)
    place, block = np.empty((BLOCK, 2)), np.zeros((BLOCK_ROWS, BLOCK))
    for start in range(0, len(u), BLOCK):
        part = u[start : start + BLOCK]
        count = len(part)
        _choose_rows(words, part, row, place)
        _choose_columns(words, part, row, column, place)
        _take_cells(texels, heights, row[:count], column, place, block)
        _directions_in_cells(numbers, h, w, count, block)
        for i in range(count):
            for axis in range(3):
                d_world[start + i, axis] = block[axis, i]
        _store_radiance(scale, block, start, radiance[: start + count], pdf)


@compiled(fastmath=())
def _store_radiance(
    scale: np.ndarray, block: np.ndarray, start: int, radiance: np.ndarray, pdf: np.ndarray
) -> None:
    """Copy a block's radiance, times `scale`, and its densities to all rows from `start` on."""
    for i in range(start, len(radiance)):
        for axis in range(3):
            radiance[i, axis] = scale[axis] * block[3 + axis, i - start]
        pdf[i] = block[6, i - start]


@compiled(fastmath=())
def look_up_image_batch(
    scale: np.ndarray,
    numbers: np.ndarray,
    words: np.ndarray,
    d_world: np.ndarray,
    radiance: np.ndarray,
    pdf: np.ndarray,
) -> None:
    """Radiance from directions, (n, 3), times `scale`, and how densely `sample_image_batch` finds
    them."""
    texels, heights = _image(words)
    h, w, _ = texels.shape
    row, column = np.empty(BLOCK, np.int64), np.empty(BLOCK, np.int64)
    block = np.zeros((BLOCK_ROWS, BLOCK))
    for start in range(0, len(pdf), BLOCK):
        part = d_world[start : start + BLOCK]
        count = len(part)
        _find_cells(numbers, h, w, part, row, column, block)
        _take_corners(texels, heights, row[:count], column, block)
        _radiance_in_cells(numbers, h, w, count, block)
        _store_radiance(scale, block, start, radiance[: start + count], pdf)


@compiled(fastmath=())
def _find_cells(
    numbers: np.ndarray,
    h: int,
    w: int,
    d_world: np.ndarray,
    row: np.ndarray,
    column: np.ndarray,
    block: np.ndarray,
) -> None:
    """Cells that directions are in, their places there and their sines to +y.

    In three loops, so that the compiler takes several directions at once in the middle one.
    """
    turn_cos, turn_sin = numbers[TURN_COSINE], numbers[TURN_SINE]
    for i in range(len(d_world)):
        block[0, i], block[1, i], block[2, i] = d_world[i, 0], d_world[i, 1], d_world[i, 2]
    for i in range(len(d_world)):
        dx, dy, dz = block[0, i], block[1, i], block[2, i]
        x, z = turn_cos * dx - turn_sin * dz, turn_sin * dx + turn_cos * dz
        sine = np.sqrt(x * x + z * z)
        block[U1, i] = (0.5 + turns_of(x, -z)) * w - 0.5
        block[U2, i] = turns_of(sine, dy) * 2.0 * h + 0.5
        block[SINE, i] = sine
    for i in range(len(d_world)):
        s, t = block[U1, i], block[U2, i]
        # A direction that is not a number finds some cell, and radiance that is not a number.
        row[i] = min(max(int(np.floor(t)), 0), h)
        left = int(np.floor(s))
        column[i] = left if 0 <= left < w else w - 1
        block[U1, i], block[U2, i] = s - np.floor(s), t - row[i]


@compiled(fastmath=())
def _radiance_in_cells(numbers: np.ndarray, h: int, w: int, count: int, block: np.ndarray) -> None:
    """Radiance and densities of a block, in the rows where `_directions_in_cells` has them."""
    for i in range(count):
        cell = _block_cell(block, i)
        l00, l01, l10, l11 = _luminances(cell)
        r, g, b = _radiance_in_cell(cell, block[U1, i], block[U2, i])
        mean = (l00 + l01 + l10 + l11) / 4.0
        at = block[CELL_HEIGHT, i], 0.0 < block[ROW, i] < h, block[SINE, i]
        block[6, i] = _density(numbers, h, w, at, _luminance(r, g, b), mean)
        block[3, i], block[4, i], block[5, i] = r, g, b
