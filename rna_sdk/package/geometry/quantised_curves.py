"""Strands in integers: each point by its steps from the one before, and restored curves."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.geometry.curves import Curves, check_strands
from rna_sdk.package.geometry.mesh import check_array
from rna_sdk.package.issues import Code, refuse

MAX_STEPS = 2**31
"""Most steps of a point from its strand's origin, along an axis."""

_STEPS_A_RADIUS = 51
_FLOAT32_STEPS = 2**22
"""Most steps up to the largest coordinate: float32 keeps points one step apart distinct."""

_LEAST_RADIUS_UNITS = 50
"""A radius of so many units and more is off by 1% at most."""


@dataclass(frozen=True, eq=False)
class QuantisedCurves:
    """Contents of a file of quantised curves.

    Attributes:
        scales: (2,) float32: metres a step, metres a unit of the radii; greater than 0.
        origins: (s, 3) float32, the first point of each strand.
        offsets: (s + 1,) uint32, as in Curves.
        steps: (p - s, 3) int16 or int32, of every other point from the one before it.
        radii: (p,) uint8 or uint16, units, 1 or more.
    """

    scales: NDArray[np.float32]
    origins: NDArray[np.float32]
    offsets: NDArray[np.uint32]
    steps: NDArray[np.int16] | NDArray[np.int32]
    radii: NDArray[np.uint8] | NDArray[np.uint16]

    def restored(self) -> Curves:
        """The strands that all readers use: float64 throughout, rounded to float32 once.

        Raises:
            PackageError: GEOMETRY_ARRAY, GEOMETRY_STRANDS, GEOMETRY_SEGMENT as `Curves` does;
                GEOMETRY_STEPS, where a step has no length or a strand too many.
        """
        strands, points = len(self.offsets) - 1, len(self.radii)
        check_array("origins", self.origins, (strands, 3), np.float32)
        check_array("steps", self.steps, (points - strands, 3), self.steps.dtype.type)
        check_strands(self.offsets, points)
        if not self.scales[0] > 0:
            refuse(Code.GEOMETRY_STEPS, "/geometry", f"a step of {self.scales[0]} m", "above 0")
        first = self.offsets[:-1].astype(np.int64)
        sums = self._sums(first)
        if np.abs(sums).max() > MAX_STEPS:
            found = f"{np.abs(sums).max()} steps from a strand's origin"
            refuse(Code.GEOMETRY_STEPS, "/geometry", found, f"at most {MAX_STEPS}")
        origins = np.repeat(self.origins.astype(np.float64), self.counts(), axis=0)
        length, unit = self.scales.astype(np.float64)
        with np.errstate(over="ignore", invalid="ignore"):  # to infinity, which readers refuse
            positions = (origins + length * sums).astype(np.float32)
            radii = (unit * self.radii).astype(np.float32)
        curves = Curves(positions, radii, self.offsets)
        object.__setattr__(curves, "quantised", self)
        return curves

    def counts(self) -> NDArray[np.int64]:
        """(s,) points of each strand."""
        return np.asarray(np.diff(self.offsets.astype(np.int64)), np.int64)

    def _sums(self, first: NDArray[np.int64]) -> NDArray[np.int64]:
        """(p, 3) steps of each point from its strand's origin."""
        moves = np.zeros((len(self.radii), 3), np.int64)
        follows = np.ones(len(self.radii), np.bool_)
        follows[first] = False
        moves[follows] = self.steps
        sums = np.cumsum(moves, axis=0)
        result: NDArray[np.int64] = sums - np.repeat(sums[first], self.counts(), axis=0)
        return result


def quantise_curves(curves: Curves) -> Curves:
    """The nearest curves on a grid from each strand's origin; quantised ones stay as they are.

    A step is a 51st of the smallest radius, or 2^-22 of the largest coordinate if that is more.
    Points that fall on the one before them are left out.
    """
    if curves.quantised is not None:
        return curves
    low, high = curves.box()
    finest = float(max(np.abs(low).max(), np.abs(high).max())) / _FLOAT32_STEPS
    length = np.float32(max(float(curves.radii.min()) / _STEPS_A_RADIUS, finest))
    old = curves.offsets.astype(np.int64)
    origins = curves.points[old[:-1]]
    of_point = np.repeat(np.arange(len(origins)), old[1:] - old[:-1])
    from_origin = curves.points.astype(np.float64) - origins[of_point]
    sums = np.rint(from_origin / np.float64(length)).astype(np.int64)
    _move_tips_off_origins(sums, from_origin, old)
    distinct, offsets = _distinct(sums, old)
    sums = sums[distinct]
    is_first = np.zeros(len(sums), np.bool_)
    is_first[offsets[:-1]] = True
    steps = (sums[1:] - sums[:-1])[~is_first[1:]]
    radii, unit = _quantised_radii(curves.radii[distinct])
    fits = np.abs(steps).max() <= np.iinfo(np.int16).max
    return QuantisedCurves(
        scales=np.array([length, unit], np.float32),
        origins=np.ascontiguousarray(origins),
        offsets=offsets.astype(np.uint32),
        steps=steps.astype(np.int16) if fits else steps.astype(np.int32),
        radii=radii,
    ).restored()


def _move_tips_off_origins(
    sums: NDArray[np.int64], from_origin: NDArray[np.float64], offsets: NDArray[np.int64]
) -> None:
    """A strand shorter than half a step gets one, in the direction of its tip."""
    tips = offsets[1:] - 1
    lone = np.flatnonzero(~np.logical_or.reduceat(sums.any(axis=1), offsets[:-1]))
    for tip in tips[lone]:
        axis = int(np.argmax(np.abs(from_origin[tip])))
        sums[tip, axis] = 1 if from_origin[tip, axis] >= 0 else -1


def _distinct(
    sums: NDArray[np.int64], offsets: NDArray[np.int64]
) -> tuple[NDArray[np.bool_], NDArray[np.int64]]:
    """(p,) whether a point differs from the one before it on its strand, and the new offsets."""
    distinct = np.ones(len(sums), np.bool_)
    distinct[1:] = (sums[1:] != sums[:-1]).any(axis=1)
    distinct[offsets[:-1]] = True
    counts = np.add.reduceat(distinct.astype(np.int64), offsets[:-1])
    return distinct, np.concatenate([[0], np.cumsum(counts)])


def _quantised_radii(
    radii: NDArray[np.float32],
) -> tuple[NDArray[np.uint8] | NDArray[np.uint16], float]:
    """The radii in units, and the unit: 8 bits where they are good for 1% of the smallest."""
    bits8 = radii.min() >= radii.max() * (_LEAST_RADIUS_UNITS / 255)
    largest = 255 if bits8 else 65535
    unit = np.float32(radii.max() / np.float64(largest))
    units = np.clip(np.rint(radii / np.float64(unit)), 1, largest)
    return units.astype(np.uint8) if bits8 else units.astype(np.uint16), float(unit)
