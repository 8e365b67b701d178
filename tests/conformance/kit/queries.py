"""Queries of the kit, (n, 16) float32, class by class.

Columns: position, normal or tangent, h, wo, wi, and the base colour, which is 0 here. A class is
what a reader may stumble over. Rows stay clear of the thresholds of 6.3 by 10%: where rounding
decides, there are two answers.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from rna_sdk.package.decoder.query_arrays import INPUT_ARRAYS, QUERY_ARRAYS, arrays_of, column_count
from tests.conformance.kit.blocks import unit

ALL = [array.name for array in QUERY_ARRAYS]
COLUMNS = column_count(ALL)
INPUTS = [array.name for array in INPUT_ARRAYS]
_PLACES = arrays_of(np.arange(COLUMNS)[None], ALL)


def columns_of(names: Iterable[str]) -> np.ndarray:
    """Places of these arrays' columns in a row of all."""
    return np.column_stack([_PLACES[name] for name in ALL if name in set(names)])[0]


def _span(name: str) -> slice:
    columns = columns_of([name])
    return slice(int(columns[0]), int(columns[-1]) + 1)


POSITION, AXIS, WO, WI = map(_span, ("position", "axis", "wo", "wi"))
H = _span("h").start
ORDINARY = "ordinary"


@dataclass(frozen=True)
class Maker:
    """What classes are made with: the random numbers, the kind and the box of the asset."""

    rng: np.random.Generator
    is_fiber: bool
    bounds: np.ndarray

    def ordinary(self, n: int) -> np.ndarray:
        """Positions in the box; wo and mostly wi on the normal's side, on fibers anywhere."""
        rows = np.zeros((n, COLUMNS))
        low, high = self.bounds
        rows[:, POSITION] = low + (high - low) * self.rng.random((n, 3))
        for columns in (AXIS, WO, WI):
            rows[:, columns] = self.directions(n)
        if self.is_fiber:
            rows[:, H] = self.rng.uniform(-1, 1, n)
        else:
            below = np.sum(rows[:, WO] * rows[:, AXIS], axis=1) < 0
            rows[below, WO] *= -1
            below = np.sum(rows[:, WI] * rows[:, AXIS], axis=1) < 0
            rows[below & (self.rng.random(n) < 0.8), WI] *= -1
        return rows.astype(np.float32)

    def directions(self, n: int) -> np.ndarray:
        return unit(self.rng.normal(size=(n, 3)))

    def near(self, vectors: np.ndarray, angles: np.ndarray) -> np.ndarray:
        """Unit vectors at these angles from unit `vectors`, to random sides."""
        side = unit(np.cross(vectors, self.directions(len(vectors))))
        return np.cos(angles)[:, None] * vectors + np.sin(angles)[:, None] * side

    def angles(self, n: int, smallest: float, largest: float = 0.1) -> np.ndarray:
        """From large to small by even ratios."""
        return np.geomspace(largest, smallest, n)


def ordinary(make: Maker) -> np.ndarray:
    return make.ordinary(160)


def grazing(make: Maker) -> np.ndarray:
    """wo, or wi, or both, almost across the normal; of fibers at the rim."""
    rows = make.ordinary(24)
    angles = np.pi / 2 + make.angles(24, 1e-6) * make.rng.choice([-1, 1], 24)
    across = make.near(rows[:, AXIS].astype(np.float64), angles)
    rows[:16, WO], rows[8:, WI] = across[:16], across[::-1][8:]
    if make.is_fiber:
        rows[:, H] = np.where(rows[:, H] < 0, -1, 1) * (1 - make.angles(24, 1e-7))
    return rows


def mirror(make: Maker) -> np.ndarray:
    """wi near the mirrored wo: the half vector near the normal; of fibers s_i near -s_o."""
    rows = make.ordinary(24)
    axis, wo = (rows[:, columns].astype(np.float64) for columns in (AXIS, WO))
    along = 2 * np.sum(axis * wo, axis=1, keepdims=True) * axis - wo
    mirrored = -along if make.is_fiber else along
    rows[:, WI] = make.near(mirrored, np.append(make.angles(23, 1e-6), 0.0))
    return rows


def nearly_opposite(make: Maker) -> np.ndarray:
    rows = make.ordinary(24)
    rows[:, WI] = make.near(-rows[:, WO].astype(np.float64), make.angles(24, 3e-4))
    return rows


def opposite(make: Maker) -> np.ndarray:
    """wi = -wo to the bit; the last four by powers of two, and so still exactly along."""
    rows = make.ordinary(12)
    rows[:, WI] = -rows[:, WO]
    rows[8:, WI] *= np.float32([[2.0], [0.5], [1024.0], [2.0**-20]])
    return rows


def around_thresholds(make: Maker) -> np.ndarray:
    """On both sides of the 1e-6 of opposite directions, and of d of fibers, to 6 digits.

    Directions along an axis of space hold small components that others round off.
    """
    sizes = np.float32([1e-9, 1e-8, 1e-7, 3e-7, 6e-7, 9e-7, 1.1e-6, 2e-6, 5e-6, 2e-5, 8e-5, 3e-4])
    rows = make.ordinary(2 * len(sizes))
    for k, size in enumerate(np.repeat(sizes, 2)):
        first, second, third = np.roll(np.eye(3, dtype=np.float32), k, axis=0)
        if make.is_fiber:
            rows[k, AXIS], rows[k, WO] = first, first + 0.02 * second
            rows[k, WI] = first + 50 * size * (-second if k % 2 else third)
        else:
            rows[k, WO], rows[k, WI] = first, size * (second if k % 2 else third) - first
    return rows


def same(make: Maker) -> np.ndarray:
    """wi = wo, at the end both the normal or tangent too."""
    rows = make.ordinary(8)
    rows[:, WI] = rows[:, WO]
    rows[4:, AXIS] = rows[4:, WO]
    return rows


def along(make: Maker) -> np.ndarray:
    """wo, wi, or both near the normal or the tangent, down to 1e-4; then exactly, and against."""
    rows = make.ordinary(36)
    axis = rows[:, AXIS].astype(np.float64)
    rows[:20, WO] = make.near(axis, make.angles(36, 1e-4))[:20]
    rows[10:28, WI] = make.near(axis, make.angles(36, 1e-4)[::-1])[10:28]
    rows[28:32, WO] = rows[28:32, AXIS]
    rows[30:34, WI] = -rows[30:34, AXIS]
    rows[34:, WI] = rows[34:, AXIS]
    return rows


def outside(make: Maker) -> np.ndarray:
    """Positions at the corners of the box, a little outside, and very far."""
    rows = make.ordinary(24)
    low, high = make.bounds
    corner = np.where(make.rng.random((24, 3)) < 0.5, low, high)
    centre, away = (low + high) / 2, np.repeat([1.0, 1.01, 1.5, 1e3, 1e12, 1e30], 4)
    rows[:, POSITION] = centre + (corner - centre) * away[:, None]
    rows[20:, POSITION.start] = centre[0]
    return rows


def lengths(make: Maker) -> np.ndarray:
    """Directions of every length; squares of the last leave the range of float32."""
    rows = make.ordinary(24)
    length = np.repeat([0.5, 3.0, 1e-3, 1e6, 1e-25, 1e25, 3e-38, 1e38], 3)
    for k, columns in enumerate((AXIS, WO, WI)):
        rows[k::3, columns] *= length[k::3, None].astype(np.float32)
    return rows


def denormal(make: Maker) -> np.ndarray:
    """Directions and positions with components below 2^-126."""
    rows = make.ordinary(8)
    for k, columns in enumerate((AXIS, WO, WI)):
        rows[k, columns] *= np.float32(1e-41)
    rows[3, WI] = [0, 1e-45, 0]
    rows[4, WO] = [1e-40, -1e-40, 0]
    rows[5, POSITION] = 1e-42
    rows[6, WI] = [1e-42, 1.0, -1e-42]
    rows[7, H] = 1e-44 if make.is_fiber else 0
    return rows


def zero_length(make: Maker) -> np.ndarray:
    rows = make.ordinary(8)
    for k, columns in enumerate((AXIS, WO, WI)):
        rows[k, columns] = 0.0
        rows[3 + k, columns] = -0.0
    rows[6, AXIS.start :] = 0.0
    rows[7] = 0.0
    return rows


def not_finite(value: float) -> Callable[[Maker], np.ndarray]:
    """Rows with this value in one component: in each of those that count, one row."""

    def made(make: Maker) -> np.ndarray:
        columns = [c for c in range(column_count(INPUTS)) if make.is_fiber or c != H]
        rows = make.ordinary(len(columns))
        for row, column in enumerate(columns):
            rows[row, column] = value
        return rows

    return made


def offsets_beyond(make: Maker) -> np.ndarray:
    rows = make.ordinary(12)
    rows[:, H] = [1, -1, 1.5, -1.5, 10, -10, 1e30, -1e30, 1 - 2**-24, -(1 - 2**-24), 0, -0.0]
    return rows


CLASSES: dict[str, Callable[[Maker], np.ndarray]] = {
    ORDINARY: ordinary,
    "grazing": grazing,
    "mirror": mirror,
    "nearly opposite": nearly_opposite,
    "opposite": opposite,
    "around the thresholds": around_thresholds,
    "same": same,
    "along the axis": along,
    "outside the bounds": outside,
    "other lengths": lengths,
    "denormal": denormal,
    "zero length": zero_length,
    "NaN": not_finite(np.nan),
    "infinite": not_finite(np.inf),
    "negative infinite": not_finite(-np.inf),
    "h beyond the rim": offsets_beyond,
}


def make_queries(
    seed: int, is_fiber: bool, bounds: np.ndarray
) -> tuple[np.ndarray, list[tuple[str, int, int]]]:
    """(n, 16) float32, and for each class its name, its first row and how many it has."""
    make = Maker(np.random.default_rng(seed), is_fiber, bounds)
    rows, ranges, first = [], [], 0
    for name, maker in CLASSES.items():
        if maker is offsets_beyond and not is_fiber:
            continue
        rows.append(maker(make).astype(np.float32))
        ranges.append((name, first, len(rows[-1])))
        first += len(rows[-1])
    return np.concatenate(rows), ranges


def valid_rows(arrays: dict[str, np.ndarray]) -> np.ndarray:
    """(n,) bool: False for those that get 0 (section 8)."""
    directions = [arrays[a.name] for a in QUERY_ARRAYS if a.is_direction and a.name in arrays]
    finite = [np.isfinite(rows).reshape(len(rows), -1).all(axis=1) for rows in arrays.values()]
    return np.all([*finite, *(rows.any(axis=1) for rows in directions)], axis=0)
