"""Fibers that are loaded and can be asked for their transport and emission."""

from __future__ import annotations

import math
from typing import Literal

from rna_sdk.arrays import scalars, vectors
from rna_sdk.package import Package, Tier
from rna_sdk.runtime.asset import AssetPart
from rna_sdk.runtime.batch import Rows


class FiberAsset(AssetPart):
    """An asset, or one of its parts, whose geometry is curves: hair, fur, fibers of cloth.

    Attributes:
        curves: the geometry, object space, metres.
    """

    kind: Literal["fiber"]

    def __init__(
        self,
        package: Package,
        tier: Tier,
        threads: int,
        part: int,
        name: str,
        pixels: float = math.inf,
    ) -> None:
        """package: open; tier: one of its manifest's; part: the number of one with curves.

        pixels: as for `Package.geometry`.
        """
        super().__init__(package, tier, threads, part, name)
        self.curves = package.curves(part, pixels)

    def evaluate(
        self,
        positions: Rows,
        tangents: Rows,
        h: Rows,
        wo: Rows,
        wi: Rows,
        out: tuple[Rows, Rows] | None = None,
    ) -> tuple[Rows, Rows]:
        """Transport at points of fibers: radiance towards wo under irradiance 1 from wi.

        positions: metres. tangents: along the fiber, from root to tip. h: (n,) float32, where
        across the width of the fiber the ray towards wo leaves it, from -1 to 1 as
        `offset_across` has it; values beyond are clamped. wo, wi: where light goes to and comes
        from, both away from the fiber. All but h (n, 3) float32, object space; n may be 0.
        Vectors of another length than 1 are brought to it; positions outside the bounds are
        moved to their nearest point on them. out: two C-contiguous (n, 3) float32 arrays to
        write the result into and return, which saves large batches the cost of fresh memory.

        Returns (visible, shadowed), each (n, 3) float32 linear RGB, finite and never negative:
        for the case that the asset itself does not, or does, block the ray from the position
        along wi. Both contain the cosine. A row with NaN or an infinity, or with a tangent, wo
        or wi of length zero, gets 0. A row's result is the same to the bit in whatever batch
        it comes and for any number of threads.

        Raises:
            QueryError: an argument is not a float32 array of its shape, or they differ in n;
                `out` cannot be written as it is.

        Examples:
            >>> hair = load("curls.rna")
            >>> root = hair.curves.segments()[:100]
            >>> x, tip = hair.curves.points[root], hair.curves.points[root + 1]
            >>> wo = wi = np.tile(np.float32([0, 1, 0]), (100, 1))
            >>> h = np.zeros(100, np.float32)  # in the middle of the fiber, as seen along wo
            >>> visible, shadowed = hair.evaluate(x, tip - x, h, wo, wi)
            >>> visible.shape
            (100, 3)
        """
        positions = vectors("positions", positions)
        tangents = vectors("tangents", tangents, len(positions))
        h = scalars("h", h, len(positions))
        return self._evaluate(positions, tangents, h, wo, wi, out)

    def emission(self, positions: Rows, tangents: Rows, h: Rows, wo: Rows) -> Rows:
        """Radiance that points of fibers send towards wo with no light on the asset, W/(m^2 sr).

        The arguments as those of `evaluate`. Returns (n, 3) float32 linear RGB, finite and never
        negative: 0 where the part does not emit, and in rows for which transport is 0.

        Raises:
            QueryError: an argument is not a float32 array of its shape, or they differ in n.

        Examples:
            >>> hair = load("curls.rna")
            >>> root = hair.curves.segments()[:100]
            >>> x, tip = hair.curves.points[root], hair.curves.points[root + 1]
            >>> wo, h = np.tile(np.float32([0, 1, 0]), (100, 1)), np.zeros(100, np.float32)
            >>> bool(hair.emission(x, tip - x, h, wo).any())
            False
        """
        positions = vectors("positions", positions)
        tangents = vectors("tangents", tangents, len(positions))
        h = scalars("h", h, len(positions))
        return self._emission(positions, tangents, h, wo)
