"""A surface that is loaded and can be asked for its transport and emission."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from rna_sdk.arrays import vectors
from rna_sdk.package import Package, Tier
from rna_sdk.runtime.asset import AssetPart
from rna_sdk.runtime.batch import Rows


class SurfaceAsset(AssetPart):
    """An asset, or one of its parts, whose geometry is a mesh.

    Attributes:
        mesh: the geometry, object space, metres.
    """

    kind: Literal["surface"]

    def __init__(
        self,
        package: Package,
        tier: Tier,
        threads: int,
        part: int,
        name: str,
        pixels: float = math.inf,
    ) -> None:
        """package: open; tier: one of its manifest's; part: the number of one with a mesh.

        pixels: as for `Package.geometry`.
        """
        super().__init__(package, tier, threads, part, name)
        self.mesh = package.mesh(part, pixels)

    def evaluate(
        self,
        positions: Rows,
        normals: Rows,
        wo: Rows,
        wi: Rows,
        out: tuple[Rows, Rows] | None = None,
    ) -> tuple[Rows, Rows]:
        """Transport at surface points: radiance towards wo under irradiance 1 from wi.

        positions: metres. normals: of the surface. wo, wi: where light goes to and comes from,
        both away from the surface. All (n, 3) float32, object space; n may be 0. Vectors of
        another length than 1 are brought to it; positions outside the bounds are moved to
        their nearest point on them. out: two C-contiguous (n, 3) float32 arrays to write the
        result into and return, which saves large batches the cost of fresh memory.

        Returns (visible, shadowed), each (n, 3) float32 linear RGB, finite and never negative:
        for the case that the asset itself does not, or does, block the ray from the position
        along wi. Both contain the cosine. A row with NaN or an infinity, or with a normal, wo
        or wi of length zero, gets 0. A row's result is the same to the bit in whatever batch
        it comes and for any number of threads.

        Raises:
            QueryError: an argument is not an (n, 3) float32 array, or they differ in n; `out`
                cannot be written as it is.

        Examples:
            >>> asset = load("toy.rna")
            >>> x, n = asset.mesh.positions[:100], asset.mesh.normals[:100]
            >>> visible, shadowed = asset.evaluate(x, n, n, n)  # seen, lit from above
            >>> visible.shape
            (100, 3)
        """
        positions = vectors("positions", positions)
        normals = vectors("normals", normals, len(positions))
        return self._evaluate(positions, normals, _NO_OFFSETS, wo, wi, out)

    def emission(self, positions: Rows, normals: Rows, wo: Rows) -> Rows:
        """Radiance that surface points send towards wo with no light on the asset, W/(m^2 sr).

        The arguments as those of `evaluate`. Returns (n, 3) float32 linear RGB, finite and never
        negative: 0 where the part does not emit, and in rows for which transport is 0.

        Raises:
            QueryError: an argument is not an (n, 3) float32 array, or they differ in n.

        Examples:
            >>> asset = load("toy.rna")
            >>> x, n = asset.mesh.positions[:100], asset.mesh.normals[:100]
            >>> bool(asset.emission(x, n, n).any())  # the toy does not glow
            False
        """
        positions = vectors("positions", positions)
        normals = vectors("normals", normals, len(positions))
        return self._emission(positions, normals, _NO_OFFSETS, wo)


_NO_OFFSETS = np.empty(0, np.float32)
