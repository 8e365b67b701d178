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

A light that shares its directions with rays leaves to them what is dim: each cell's weight is then
max(L - mean / 2, 0), with L its mean luminance and `mean` the image's. Karlik, Sik, Vevoda,
Skrivan and Krivanek, MIS Compensation (TOG 38(6), 2019), take the whole mean off; docs/decisions/
renderer.md has why half.
"""

from copy import copy
from dataclasses import dataclass

import numpy as np

from rna_render.lights.image_kernels import (
    COLUMN_FINENESS,
    IMAGE_NUMBERS,
    ROW_FINENESS,
    TOTAL,
    TURN_COSINE,
    TURN_SINE,
    look_up_image_batch,
    sample_image_batch,
    sums_of_cells,
)
from rna_render.lights.intervals import guide_of

# Part of the mean luminance that samples leave out.
LEFT_TO_RAYS = 0.5


@dataclass(frozen=True)
class _Choice:
    """Tables by which directions are chosen, and their form for kernels.

    held: the arrays that addresses in `words` point into. words, numbers: see the image.
    """

    held: tuple[np.ndarray, ...]
    words: np.ndarray
    numbers: np.ndarray


class EquirectangularImage:
    """Radiance over the sphere.

    texels: (h, w, 3) float32, radiance, finite and not negative; row 0 at +y. angle: radians that
    the image is turned about +y, counter-clockwise seen from above. It keeps texels as they are,
    and 32 bytes a texel for the choice of directions, with and without MIS compensation.

    Attributes:
        total: integral of the luminance over the sphere, W / m^2, with the mean of each cell.
        words: (8,) uint64, numbers: (4,) float64, as `image_kernels` has
            them; valid as long as the image.
    """

    def __init__(self, texels: np.ndarray, angle: float = 0.0) -> None:
        h, w, _ = texels.shape
        self._texels = np.ascontiguousarray(texels, np.float32)
        edges = np.clip((np.arange(h + 2) - 0.5) / h, 0.0, 1.0)
        # Solid angle of a row's cells over 2 pi / w.
        self._heights = np.cos(np.pi * edges[:-1]) - np.cos(np.pi * edges[1:])
        plain = self._choice(0.0)
        self.total = float(plain.numbers[TOTAL]) * 2.0 * np.pi / w
        # Kernels read both by address, in all threads: made once, before them.
        self._compensated = self._choice(LEFT_TO_RAYS * self.total / (4.0 * np.pi))
        self._use(plain)
        self._turn(angle)

    def _choice(self, mean: float) -> _Choice:
        """Sampler of directions, in proportion to the radiance above `mean`."""
        h, w, _ = self._texels.shape
        columns = np.empty((h + 1, w + 1))
        sums_of_cells(self._texels, np.arange(h + 1), self._heights, mean, columns)
        rows = np.concatenate([[0.0], np.cumsum(columns[:, -1])])
        guides = guide_of(rows[None], ROW_FINENESS), guide_of(columns, COLUMN_FINENESS)
        held = self._texels, self._heights, rows, guides[0], columns, guides[1]
        words = np.array([*(array.ctypes.data for array in held), h, w], np.uint64)
        return _Choice(held, words, np.array([1.0, 0.0, rows[-1], mean]))

    def _use(self, choice: _Choice) -> None:
        self._held, self.words, self.numbers = choice.held, choice.words, choice.numbers

    def _turn(self, angle: float) -> None:
        self.numbers = self.numbers.copy()
        self.numbers[TURN_COSINE], self.numbers[TURN_SINE] = np.cos(angle), np.sin(angle)

    @property
    def texels(self) -> np.ndarray:
        """Radiance at angle 0: (h, w, 3) float32."""
        return self._texels

    @property
    def members(self) -> dict[str, float]:
        """Members of the row of a light of this image beside its colour."""
        rows, columns, _ = self._texels.shape
        members = dict(zip(IMAGE_NUMBERS, self.numbers.tolist(), strict=True))
        return members | {"rows": rows, "columns": columns}

    @property
    def tables(self) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Sampling tables, for other devices: texels (h, w, 3) float32, heights of
        rows (h + 1,), running sums of rows (h + 2,) and of each row's cells (h + 1, w + 1)."""
        texels, heights, rows, _, columns, _ = self._held
        return texels, heights, rows, columns

    def turned(self, angle: float) -> "EquirectangularImage":
        """This image, sharing its memory, at another angle."""
        result = copy(self)
        result._turn(angle)
        return result

    def compensated(self) -> "EquirectangularImage":
        """This image, sharing its memory, with MIS compensation.

        `sample` skips texels darker than LEFT_TO_RAYS of the mean.
        """
        result = copy(self)
        result._use(self._compensated)
        result.numbers = np.concatenate([self.numbers[:TOTAL], result.numbers[TOTAL:]])
        return result

    def sample(self, u: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Directions: unit (n, 3) float32, radiance from there (n, 3) and pdf (n,), float32.

        u: (n, 2) in [0, 1). In a black image the pdf is 0.
        """
        wi, radiance = _empty_vectors(len(u)), _empty_vectors(len(u))
        pdf = np.empty(len(u), np.float32)
        sample_image_batch(np.ones(3), self.numbers, self.words, u, wi, radiance, pdf)
        return wi, radiance, pdf

    def lookup(self, d_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Radiance from directions, (n, 3) float32, and the density with which `sample` finds them.

        d_world: (n, 3) float32. Returns (n, 3) and (n,), float32.
        """
        radiance, pdf = _empty_vectors(len(d_world)), np.empty(len(d_world), np.float32)
        look_up_image_batch(np.ones(3), self.numbers, self.words, d_world, radiance, pdf)
        return radiance, pdf


def _empty_vectors(n: int) -> np.ndarray:
    return np.empty((n, 3), np.float32)
