"""An asset that is loaded and can be asked for its transport."""

from __future__ import annotations

from os import PathLike

import numpy as np

from rna_sdk.package import Package, Tier
from rna_sdk.package.manifest import Kind
from rna_sdk.runtime.arguments import results, scalars, thread_count, vectors
from rna_sdk.runtime.batch import Batch, Rows
from rna_sdk.runtime.costs import kept_cost, median_seconds
from rna_sdk.runtime.tiers import choose_tier

_MEASURED_ROWS = 32_768


def load(
    path: str | PathLike[str],
    tier: str | None = None,
    threads: int | None = None,
    *,
    min_psnr: float | None = None,
    max_error: float | None = None,
    pixels: float | None = None,
) -> SurfaceAsset | FiberAsset:
    """Open the package at `path` for evaluation. Its planes stay in the file, mapped to memory.

    Which of the two it gives, the package's kind says.

    tier: name of a tier; None takes the package's first.
    threads: threads of an evaluation; None takes one for each core this process may use.
    min_psnr: instead of a name: takes the tier with the fewest multiply-adds a query, those of
        an int8 decoder counted half, among those whose recorded validation PSNR is at least
        this many dB.
    max_error: likewise, whose recorded mean FLIP is at most this.
    pixels: with max_error, how high the asset is in the image: the sphere about its bounds. A
        small asset is content with a cheaper tier. None: as high as the validation images.

    Raises:
        PackageError: the file cannot be read or breaks the format.
        QueryError: there is no such tier, none is good enough, or an argument is no such value.
    """
    count = thread_count(threads)
    with Package.open(path) as package:
        kind = SurfaceAsset if package.manifest.kind == "surface" else FiberAsset
        return kind(package, choose_tier(package, tier, min_psnr, max_error, pixels), count)


class Asset:
    """One tier of a package, ready to evaluate; make one with `load`.

    It is a `SurfaceAsset` or a `FiberAsset`. Threads may evaluate at the same time.

    Attributes:
        kind: "surface" or "fiber".
        tier: the tier's record in the manifest (`tier.name`, `tier.validation`, ...).
        domain: the directions it was trained for; see `in_region`.
        threads: threads of an evaluation.
        bounds: (2, 3) float32, read-only: lower and upper corner of the box that the features
            span, object space, metres.
    """

    def __init__(self, package: Package, tier: Tier, threads: int) -> None:
        """package: open; tier: one of its manifest's; threads: at least 1."""
        # onnxruntime and numba load with the first asset, not with this module.
        from rna_sdk.runtime.decoder import Decoder
        from rna_sdk.runtime.tiles import QueryFiller, TileEvaluator

        box = package.manifest.bounds
        self.kind: Kind = package.manifest.kind
        self.tier = tier
        self.domain = package.manifest.domain
        self.threads = threads
        self.bounds = box.corners()
        self.bounds.flags.writeable = False
        filler = QueryFiller(package.planes(tier.name), box, tier, self.kind)
        decoder = Decoder(package.decoder(tier.name), filler.largest_query)
        self._evaluator = TileEvaluator(filler, decoder, threads)
        entries = package.manifest.entries
        self._digests = entries[tier.planes].sha256, entries[tier.decoder].sha256

    @property
    def parts(self) -> tuple[Asset, ...]:
        """Its parts: itself alone."""
        return (self,)

    def measured_ns_per_query(self) -> float:
        """Nanoseconds that a query takes on this processor, with `threads` threads.

        Measured at the first call (some 0.1 s), on queries all over the bounds; then kept in the
        user's cache for as long as processor, package and versions stay the same. The manifest's
        `tier.cost` is what another machine took.
        """
        return kept_cost(self._measure_ns_per_query, *self._digests, self.threads)

    def _measure_ns_per_query(self) -> float:
        rng = np.random.default_rng(0)
        low, high = self.bounds
        positions = rng.uniform(low, high, (_MEASURED_ROWS, 3)).astype(np.float32)
        axes, wo, wi = rng.normal(size=(3, _MEASURED_ROWS, 3)).astype(np.float32)
        h = rng.uniform(-1, 1, _MEASURED_ROWS).astype(np.float32)
        results = np.empty((2, _MEASURED_ROWS, 3), np.float32)
        batch = Batch(positions, axes, h, wo, wi, *results)
        return 1e9 * median_seconds(lambda: self._evaluator.run(batch)) / _MEASURED_ROWS

    def _evaluate(
        self, positions: Rows, axes: Rows, h: Rows, wo: object, wi: object, out: object
    ) -> tuple[Rows, Rows]:
        """The first three as in `Batch`; the others checked here."""
        count = len(positions)
        wo = vectors("wo", wo, count)
        wi = vectors("wi", wi, count)
        if out is None:
            visible, shadowed = np.empty((2, count, 3), np.float32)
        else:
            visible, shadowed = results(out, count)
        self._evaluator.run(Batch(positions, axes, h, wo, wi, visible, shadowed))
        return visible, shadowed


class SurfaceAsset(Asset):
    """An asset whose geometry is a mesh.

    Attributes:
        mesh: the geometry, object space, metres.
    """

    def __init__(self, package: Package, tier: Tier, threads: int) -> None:
        """package: open, of a surface; tier: one of its manifest's; threads: at least 1."""
        super().__init__(package, tier, threads)
        self.mesh = package.mesh()

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
        """
        positions = vectors("positions", positions)
        normals = vectors("normals", normals, len(positions))
        return self._evaluate(positions, normals, _NO_OFFSETS, wo, wi, out)


class FiberAsset(Asset):
    """An asset whose geometry is curves: hair, fur, fibers of cloth.

    Attributes:
        curves: the geometry, object space, metres.
    """

    def __init__(self, package: Package, tier: Tier, threads: int) -> None:
        """package: open, of fibers; tier: one of its manifest's; threads: at least 1."""
        super().__init__(package, tier, threads)
        self.curves = package.curves()

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
        """
        positions = vectors("positions", positions)
        tangents = vectors("tangents", tangents, len(positions))
        h = scalars("h", h, len(positions))
        return self._evaluate(positions, tangents, h, wo, wi, out)


_NO_OFFSETS = np.empty(0, np.float32)
