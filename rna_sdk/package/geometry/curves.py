"""The geometry of a fiber asset, as arrays."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.geometry.mesh import check_array
from rna_sdk.package.issues import Code, refuse

if TYPE_CHECKING:
    from rna_sdk.package.geometry.quantised_curves import QuantisedCurves


@dataclass(frozen=True, eq=False)
class Curves:
    """Strands in object space, metres, right-handed with +Y up: chains of round, straight cones.

    Attributes:
        points: (p, 3) float32, strand after strand, each from root to tip; consecutive points of
            a strand differ.
        radii: (p,) float32, positive.
        offsets: (s + 1,) uint32, ascending from 0 to p: strand k has the points
            offsets[k]:offsets[k + 1], at least two.
        quantised: the integers that the arrays were restored from and that are stored in the
            file; None if the arrays themselves are stored. `dataclasses.replace` resets it.

    Raises:
        PackageError: GEOMETRY_ARRAY, if a shape or dtype differs; GEOMETRY_STRANDS, if the
            offsets are invalid; GEOMETRY_SEGMENT, if a segment has length zero.

    Examples:
        >>> strand = np.float32([[0, 0, 0], [0, 0.1, 0], [0, 0.2, 0.01]])
        >>> curves = Curves(strand, np.full(3, 1e-4, np.float32), np.uint32([0, 3]))
        >>> curves.segments().tolist()
        [0, 1]
    """

    points: NDArray[np.float32]
    radii: NDArray[np.float32]
    offsets: NDArray[np.uint32]
    quantised: QuantisedCurves | None = field(default=None, init=False, repr=False)

    def __post_init__(self) -> None:
        p, s = len(self.points), len(self.offsets) - 1
        check_array("points", self.points, (p, 3), np.float32)
        check_array("radii", self.radii, (p,), np.float32)
        check_array("offsets", self.offsets, (s + 1,), np.uint32)
        check_strands(self.offsets, p)
        same = (self.points[1:] == self.points[:-1]).all(axis=1) & self._goes_on()[:-1]
        if same.any():
            at = int(np.argmax(same))
            found = f"points {at} and {at + 1} at {self.points[at].tolist()}"
            refuse(Code.GEOMETRY_SEGMENT, "/geometry", found, "a segment of some length")

    def segments(self) -> NDArray[np.uint32]:
        """Index of the first point of each segment, (m,) uint32; the second point follows it."""
        return np.flatnonzero(self._goes_on()).astype(np.uint32)

    def _goes_on(self) -> NDArray[np.bool_]:
        """(p,) whether the point's strand goes on behind it."""
        result = np.ones(len(self.points), np.bool_)
        result[self.offsets[1:].astype(np.int64) - 1] = False
        return result

    def box(self) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """The lower and the upper corner of the box around it, radii included, each (3,)."""
        radii = self.radii[:, None]
        with np.errstate(over="ignore"):  # to infinity, which is outside of any bounds
            return (self.points - radii).min(axis=0), (self.points + radii).max(axis=0)


def check_strands(offsets: NDArray[np.uint32], points: int) -> None:
    """Raises PackageError (GEOMETRY_STRANDS) where they do not part the points into strands."""
    if len(offsets) < 2 or offsets[0] != 0 or offsets[-1] != points:
        found = f"offsets {offsets[:1].tolist()} to {offsets[-1:].tolist()}"
        refuse(Code.GEOMETRY_STRANDS, "/geometry", found, f"one strand and more, 0 to {points}")
    counts = np.diff(offsets.astype(np.int64))
    if counts.min() < 2:
        found = f"{counts.min()} points in strand {np.argmin(counts)}"
        refuse(Code.GEOMETRY_STRANDS, "/geometry", found, "2 and more in each")
