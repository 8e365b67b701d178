"""Which random numbers each decision on a path takes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rna_render.paths.sampling import Sampler

# So many lights at most have a sample each at one point.
LIGHTS_AT_A_VERTEX = 4

# Dimensions of the sampler: the place in the pixel, then these at each point of a path, with one
# for each light that has a sample there.
PIXEL_DIMENSION = 0
CHOICES, DIRECTION, ROULETTE, LIGHT = 1, 2, 3, 4
DIMENSIONS_A_VERTEX = 3 + LIGHTS_AT_A_VERTEX


@dataclass(frozen=True, slots=True)
class PathNumbers:
    """The random numbers of some paths at one of their points.

    pixels: (n,) uint32, of the paths. depth: number of the point, from 1. number: (n,) int64, of
    the path among all of its pixel that have come to this point; None for that of the sample.
    """

    sampler: Sampler
    pixels: np.ndarray
    depth: int
    number: np.ndarray | None = None

    def take(self, row: np.ndarray) -> PathNumbers:
        """The numbers of some of the paths."""
        number = None if self.number is None else self.number[row]
        return PathNumbers(self.sampler, self.pixels[row], self.depth, number)

    def square(self, dimension: int, parts: int = 1) -> np.ndarray:
        """(n * parts, 2) float64 in [0, 1), for one of the dimensions above, as Sampler.square."""
        number = (self.depth - 1) * DIMENSIONS_A_VERTEX + dimension
        return self.sampler.square(self.pixels, number, parts, self.number)
