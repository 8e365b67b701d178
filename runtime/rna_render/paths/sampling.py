"""Random numbers: Owen-scrambled Sobol' points, and which of them each decision on a path takes.

Numbers are a pure function of seed, pixel, sample and dimension, so an image depends neither on
the number of threads nor on how it was cut into bands. Every prefix of 2^k samples of a pixel is
a (0, k, 2)-net in each dimension, so an image that was stopped early is well distributed too.
"""

from dataclasses import dataclass

import numpy as np

from rna_sdk.machine.compiled import compiled
from rna_trace.hashing import Bits, hash_bits

# So many lights at most have a sample each at one point.
LIGHTS_AT_A_VERTEX = 4

# So many rays go on from the point that the camera sees, if they can meet another thing. From a
# strand fewer do, and no light has more samples than these: most noise of its pixels is that of
# where in the pixel the camera ray falls.
BRANCHES, STRAND_BRANCHES = 3, 2
STRAND_SAMPLES = 2

# Dimensions of the sampler: the place in the pixel, then these at each point of a path, with one
# for each light that has a sample there.
PIXEL_DIMENSION = 0
LENS_DIMENSION = 1 << 20  # beyond those of any path
CHOICES, DIRECTION, ROULETTE, LIGHT = 1, 2, 3, 4
NEARBY = 1 << 21  # added to that of the light sample or ray whose nearby light it is for
DIMENSIONS_A_VERTEX = 3 + LIGHTS_AT_A_VERTEX


@dataclass(frozen=True)
class Sampler:
    """The random numbers of one sample of every pixel.

    seed: of the whole image. sample: number of this sample, from 0. count: samples that are
    rendered together, this one and those after it, where a renderer takes several at once.
    """

    seed: int
    sample: int
    count: int = 1

    def square(
        self, pixels: np.ndarray, dimension: int, parts: int = 1, number: np.ndarray | None = None
    ) -> np.ndarray:
        """Points in the unit square, `parts` for each row: (n * parts, 2) float64 in [0, 1).

        pixels: (n,) uint32. dimension: which decision of the sample they are for. The
        parts are spread as well as if they were samples of their own. number: (n,) int64, of the
        row among all that a pixel has in this dimension; None for the sample's own.
        """
        points = np.empty((len(pixels), parts, 2), np.float64)
        if number is None:
            number = np.full(len(pixels), self.sample, np.int64)
        _scrambled_sobol(pixels, number, dimension, self.seed, points)
        return points.reshape(-1, 2)


@compiled(fastmath=())
def _reverse_bits(x: Bits) -> np.uint32:
    x = np.uint32(((x >> np.uint32(1)) & 0x55555555) | ((x & 0x55555555) << np.uint32(1)))
    x = np.uint32(((x >> np.uint32(2)) & 0x33333333) | ((x & 0x33333333) << np.uint32(2)))
    x = np.uint32(((x >> np.uint32(4)) & 0x0F0F0F0F) | ((x & 0x0F0F0F0F) << np.uint32(4)))
    x = np.uint32(((x >> np.uint32(8)) & 0x00FF00FF) | ((x & 0x00FF00FF) << np.uint32(8)))
    return np.uint32((x >> np.uint32(16)) | (x << np.uint32(16)))


@compiled(fastmath=())
def _owen_scramble(x: Bits, seed: Bits) -> np.uint32:
    """Nested uniform scramble of the bits of x.

    B. Burley, Practical Hash-based Owen Scrambling (JCGT 9(4), 2020), listing 1, with the
    permutation of Laine and Karras.
    """
    x = np.uint32(_reverse_bits(x) + np.uint32(seed))
    x = np.uint32(x ^ np.uint32(x * np.uint32(0x6C50B47C)))
    x = np.uint32(x ^ np.uint32(x * np.uint32(0xB82F1E52)))
    x = np.uint32(x ^ np.uint32(x * np.uint32(0xC7AFE638)))
    x = np.uint32(x ^ np.uint32(x * np.uint32(0x8D22F6E6)))
    return _reverse_bits(x)


@compiled(fastmath=())
def _second_sobol_dimension(index: Bits) -> np.uint32:
    """Bits of the second Sobol' coordinate; the first is `_reverse_bits`.

    The coordinate is the reversed index times Pascal's triangle modulo 2, which has a product of
    five sparse factors: Ahmed, An Implementation Algorithm of 2D Sobol Sequence Fast, Elegant,
    and Compact (EGSR 2024).
    """
    x = _reverse_bits(index)
    x = np.uint32(x ^ (x << np.uint32(16)))
    x = np.uint32(x ^ ((x & np.uint32(0x00FF00FF)) << np.uint32(8)))
    x = np.uint32(x ^ ((x & np.uint32(0x0F0F0F0F)) << np.uint32(4)))
    x = np.uint32(x ^ ((x & np.uint32(0x33333333)) << np.uint32(2)))
    return np.uint32(x ^ ((x & np.uint32(0x55555555)) << np.uint32(1)))


@compiled(fastmath=())
def square_key(seed: int, dimension: int, pixel: Bits) -> np.uint32:
    """Key of a dimension of a pixel for `square_point`."""
    image_key = hash_bits(hash_bits(seed) + np.uint32(dimension))
    return hash_bits(image_key ^ hash_bits(np.uint32(pixel) + np.uint32(1)))


@compiled(fastmath=())
def square_point(key: np.uint32, number: int) -> tuple[float, float]:
    """The `number`-th point of the unit square in the sequence of a key."""
    index = _owen_scramble(np.uint32(number), key)
    return _first_coordinate(key, index), _second_coordinate(key, index)


@compiled(fastmath=())
def _first_coordinate(key: Bits, index: Bits) -> float:
    """First coordinate of the point with a scrambled index."""
    return _owen_scramble(_reverse_bits(index), hash_bits(key + np.uint32(1))) * 2.0**-32


@compiled(fastmath=())
def _second_coordinate(key: Bits, index: Bits) -> float:
    bits = _owen_scramble(_second_sobol_dimension(index), hash_bits(key + np.uint32(2)))
    return bits * 2.0**-32


@compiled(fastmath=())
def _scrambled_sobol(
    pixels: np.ndarray, number: np.ndarray, dimension: int, seed: int, points: np.ndarray
) -> None:
    """`square_point` for each row and part, step by step, so that the compiler takes several rows
    at once."""
    n, parts, _ = points.shape
    key, index = np.empty(n, np.uint32), np.empty(n, np.uint32)
    for i in range(n):
        key[i] = square_key(seed, dimension, pixels[i])
    for part in range(parts):
        for i in range(n):
            index[i] = _owen_scramble(np.uint32(number[i] * parts + part), key[i])
        for i in range(n):
            points[i, part, 0] = _first_coordinate(key[i], index[i])
        for i in range(n):
            points[i, part, 1] = _second_coordinate(key[i], index[i])


@dataclass(frozen=True, slots=True)
class PathNumbers:
    """The random numbers of some paths at one of their points.

    pixels: (n,) uint32, of the paths. depth: number of the point, from 1. number: (n,) int64, of
    the path among all of its pixel that have come to this point; None for the sample's own.
    """

    sampler: Sampler
    pixels: np.ndarray
    depth: int
    number: np.ndarray | None = None

    def take(self, row: np.ndarray) -> "PathNumbers":
        """The numbers of some of the paths."""
        number = None if self.number is None else self.number[row]
        return PathNumbers(self.sampler, self.pixels[row], self.depth, number)

    def of_branches(
        self, branches: np.ndarray, nearby: bool = False
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray | None]:
        """Numbers of the rays that go on, `branches` of each path, (n,) int64: k in all.

        Returns u, (k, 3) float64 in [0, 1), for their directions; (k,) int64, the number of the
        path along each; and (k, 2), for their nearby light if that is asked for. Raises ValueError
        if the paths have no numbers.
        """
        if self.number is None:
            raise ValueError("paths without numbers have no branches")
        start = np.cumsum(branches) - branches
        u, number = np.empty((branches.sum(), 3)), np.empty(branches.sum(), np.int64)
        of_nearby = np.empty((len(u), 2)) if nearby else None
        for count in np.flatnonzero(np.bincount(branches)).tolist():
            row, each = np.flatnonzero(branches == count), np.arange(count)
            some = self.take(row)
            at = (start[row, None] + each).reshape(-1)
            u[at, :2] = some.square(DIRECTION, count)
            u[at, 2] = some.square(CHOICES, count)[:, 1]
            number[at] = (self.number[row, None] * count + each).reshape(-1)
            if of_nearby is not None:
                of_nearby[at] = some.square(NEARBY + DIRECTION, count)
        return u, number, of_nearby

    def square(self, dimension: int, parts: int = 1) -> np.ndarray:
        """(n * parts, 2) float64 in [0, 1), for one of the dimensions above, as Sampler.square."""
        number = (self.depth - 1) * DIMENSIONS_A_VERTEX + dimension
        return self.sampler.square(self.pixels, number, parts, self.number)
