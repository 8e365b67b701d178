"""A loaded asset: what all kinds have in common, and an asset of several parts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, ClassVar, NoReturn, cast

import numpy as np
from numpy.typing import NDArray

from rna_sdk.arrays import scalars, vectors
from rna_sdk.errors import QueryError
from rna_sdk.package import (
    Curves,
    Domain,
    EnvironmentPart,
    Mesh,
    NormalMap,
    Package,
    Tier,
    Transmittance,
    decoder_from_bytes,
)
from rna_sdk.package.decoder.decoder_form import COLUMNS, TRANSPORT, form_named
from rna_sdk.package.decoder.query_arrays import QUERY_ARRAYS, Rows
from rna_sdk.package.manifest.manifest_fields import Kind
from rna_sdk.runtime.engine.batch import Batch
from rna_sdk.runtime.engine.costs import cached_cost, median_seconds
from rna_sdk.runtime.part_lobes import PartLobes

if TYPE_CHECKING:
    from rna_sdk.runtime.fiber_asset import FiberAsset
    from rna_sdk.runtime.surface_asset import SurfaceAsset

_MEASURED_ROWS = 32_768


class Asset:
    """One tier of a package, ready to evaluate; created by `load`.

    Either a `SurfaceAsset` or a `FiberAsset`, which have `evaluate`, or a `CompositeAsset` of
    several of them. Evaluation is thread-safe.

    Attributes:
        name: display name of the asset, or of the part if it is one of several.
        tier: the tier's record in the manifest (`tier.name`, `tier.validation`, ...).
        domain: directions covered by training; see `in_region`.
        threads: number of threads per evaluation.
        bounds: (2, 3) float32, read-only: lower and upper corner of the bounding box of all parts'
            features, object space, metres.
        emits: whether any part emits light.
    """

    def __init__(
        self,
        name: str,
        tier: Tier,
        domain: Domain,
        threads: int,
        bounds: NDArray[np.float32],
        emits: bool,
        tiers: tuple[str, ...],
        file_bytes: int,
    ) -> None:
        """tiers: names of all tiers of the package. file_bytes: its size."""
        self.name = name
        self.tier = tier
        self.domain = domain
        self.threads = threads
        self.bounds = bounds
        self.bounds.flags.writeable = False
        self.emits = emits
        self._tiers, self._file_bytes = tiers, file_bytes

    def __repr__(self) -> str:
        parts = ", ".join(f"{part.name} ({part.kind})" for part in self.parts)
        return (
            f"<{type(self).__name__} {self.name!r}: {parts}; tier {self.tier.name} of "
            f"{', '.join(self._tiers)}; {self._file_bytes:,} bytes>"
        )

    def __reduce__(self) -> NoReturn:
        raise QueryError(
            f"{type(self).__name__} {self.name!r} cannot be pickled or copied: it maps its file; "
            "pass the path, and call load(path) in each process"
        )

    @property
    def parts(self) -> tuple[SurfaceAsset | FiberAsset, ...]:
        """The parts in the manifest's order; an asset of one part is its own only part."""
        raise NotImplementedError

    def measured_ns_per_query(self) -> float:
        """Nanoseconds per query on this processor, with `threads` threads; the mean over parts.

        The first call measures random queries within the bounds (about 0.1 s per part). The result
        is cached in the user's cache folder, per processor, package and version. `tier.cost` in
        the manifest is the cost on the machine that exported the package.
        """
        costs = [part.measured_part_ns() for part in self.parts]
        return sum(costs) / len(costs)


class CompositeAsset(Asset):
    """An asset of several parts, which are evaluated separately and light each other.

    Examples:
        >>> toy, hair = load("toy.rna"), load("curls.rna")
        >>> both = CompositeAsset("toy and curls", [toy, hair])
        >>> [part.kind for part in both.parts]
        ['surface', 'fiber']
    """

    def __init__(self, name: str, parts: Sequence[SurfaceAsset | FiberAsset]) -> None:
        """parts: two or more, of one tier of one package."""
        first = parts[0]
        low = np.min([part.bounds[0] for part in parts], axis=0)
        high = np.max([part.bounds[1] for part in parts], axis=0)
        emits = any(part.emits for part in parts)
        bounds = np.stack([low, high])
        tier_part = first._tiers, first._file_bytes
        super().__init__(name, first.tier, first.domain, first.threads, bounds, emits, *tier_part)
        self._parts = tuple(parts)

    @property
    def parts(self) -> tuple[SurfaceAsset | FiberAsset, ...]:
        return self._parts


class AssetPart(Asset):
    """Common base of `SurfaceAsset` and `FiberAsset`.

    Attributes:
        kind: "surface" or "fiber".
        tier_part: the part's record in the tier.
        transmittance_records: holes and thin glass of a surface; see `transmittance`.
        normal_maps: normal maps of a surface; see `mapped_normals`.
        environment_form: the manifest's record of the part's lobes, `lobes` of them; see `mirror`.
            None if the package has none for the part, or the geometry is that of a proxy.
    """

    _labels: ClassVar[Mapping[str, str]]
    """Names of arrays in errors: those of the arguments of `evaluate`."""

    def __init__(
        self, package: Package, tier: Tier, threads: int, part: int, name: str, pixels: float
    ) -> None:
        """package: open. tier: one of its tiers. threads: at least 1. part: index of the part.

        pixels: as for `Package.geometry`.
        """
        # onnxruntime and numba load with the first asset, not with this module.
        from rna_sdk.runtime.engine.decoder_sessions import Decoder
        from rna_sdk.runtime.engine.tiles import QueryFiller, TileEvaluator

        record, tier_part = package.manifest.parts[part], tier.parts[part]
        box, emits = record.bounds, tier_part.emission is not None
        file_bytes = tuple(other.name for other in package.manifest.tiers), package.file_bytes
        domain, bounds = package.manifest.domain, box.corners()
        super().__init__(name, tier, domain, threads, bounds, emits, *file_bytes)
        self.kind: Kind = record.kind
        self.tier_part = tier_part
        self.transmittance_records: tuple[Transmittance, ...] = tuple(package.transmittance(part))
        self.normal_maps: tuple[NormalMap, ...] = tuple(package.normal_maps(part))
        filler = QueryFiller(package.planes(tier.name, part), box, tier_part, self.kind)
        self._evaluators = {
            one.form.name: TileEvaluator(
                filler.laying_out(one.inputs),
                Decoder(
                    decoder_from_bytes(package.decoder(tier.name, part, one.form.name), one.entry),
                    filler.largest_query,
                ),
                threads,
            )
            for one in tier_part.decoders
        }
        entries = package.manifest.entries
        self._digests = entries[tier_part.planes].sha256, entries[tier_part.decoder].sha256
        self._geometry: Mesh | Curves = package.geometry(part, pixels)
        for array in vars(self._geometry).values():
            if isinstance(array, np.ndarray):  # who wrote to it would move the rest of `deformed`
                array.flags.writeable = False
        proxied = any(pixels <= height for height in package.proxy_heights(part))
        lobes = None if proxied else package.environment(part)
        self._lobes = None if lobes is None else PartLobes(lobes, record, threads)
        self.environment_form: EnvironmentPart | None = lobes.record if lobes else None

    @property
    def parts(self) -> tuple[SurfaceAsset | FiberAsset, ...]:
        return (cast("SurfaceAsset | FiberAsset", self),)

    def measured_part_ns(self) -> float:
        """`measured_ns_per_query` of this part."""
        return cached_cost(self._measure_ns_per_query, *self._digests, self.threads)

    def _measure_ns_per_query(self) -> float:
        rng = np.random.default_rng(0)
        low, high = self.bounds
        arrays = {"position": rng.uniform(low, high, (_MEASURED_ROWS, 3)).astype(np.float32)}
        arrays["axis"], arrays["wo"], arrays["wi"] = rng.normal(size=(3, _MEASURED_ROWS, 3)).astype(
            np.float32
        )
        arrays["h"] = rng.uniform(-1, 1, _MEASURED_ROWS).astype(np.float32)
        batch = Batch.of(arrays, tuple(np.empty((2, _MEASURED_ROWS, 3), np.float32)))
        evaluator = self._evaluators[TRANSPORT.name]
        return 1e9 * median_seconds(lambda: evaluator.run(batch)) / _MEASURED_ROWS

    def decode(
        self, form: str, arrays: Mapping[str, object], out: object = None
    ) -> tuple[Rows, ...]:
        """The results of a decoder, each (n, 3) float32; 0 if the part has no such decoder.

        form: name of its form: "transport" gives (visible, shadowed), "emission" (radiance,).
        arrays: by name, those that the form is asked with: position, axis (a normal or tangent), h
        (of fibers alone), wo, and wi. out: arrays for the results, as for `evaluate`.

        Raises:
            QueryError: an array is missing, or is no float32 array of its shape; they differ in n;
                `out` is not writable or not contiguous.
        """
        decoder_form = form_named(form)
        checked = self._checked(arrays, decoder_form.arrays)
        count = len(checked["wo"])
        number = decoder_form.result_count(decoder_form.record(self.tier_part))
        evaluator = self._evaluators.get(form)
        if out is None:
            make = np.zeros if evaluator is None else np.empty
            result = tuple(make((number, count, COLUMNS), np.float32))
        else:
            result = _results(out, number, count)
        if evaluator is not None:
            evaluator.run(Batch.of(checked, result))
        return result

    def mirror(self, axes: Rows, wo: Rows) -> Rows:
        """Directions for which lobes are evaluated: the mirror directions of wo.

        axes: normals or tangents; wo: towards the viewer; (n, 3) float32, any length, one space. At
        a normal n it is 2 (n . wo) n - wo, at a tangent t wo - 2 (wo . t) t. A host traces one
        ray along it for the argument `free` of `lobes`.

        Returns (n, 3) float32, unit; 0 where an argument has no direction.

        Raises:
            QueryError: an argument is not an (n, 3) float32 array, or they differ in n.

        Examples:
            >>> asset = load("toy.rna")
            >>> asset.mirror(np.float32([[0, 1, 0]]), np.float32([[0.6, 0.8, 0]])).round(3).tolist()
            [[-0.6000000238418579, 0.800000011920929, 0.0]]
        """
        return self._mirrored(self._checked({"axis": axes, "wo": wo}, ("axis", "wo")))

    def _mirrored(self, checked: Mapping[str, Rows]) -> Rows:
        from rna_sdk.runtime.kernels.lobe_kernels import mirror_rows

        result = np.empty_like(checked["wo"])
        mirror_rows(checked["axis"], checked["wo"], self.kind == "fiber", result)
        return result

    def visibility_at(self, primitives: NDArray[np.integer], u: Rows, v: Rows) -> Rows:
        """The package's coefficients of the visibility at ray hits, for `lobes`.

        primitives: (n,) indices of triangles, or of segments in the order of `Curves.segments()`.
        u, v: (n,) float32, barycentric coordinates of the second and third corner; of a segment u,
        from 0 at its first point to 1 at its second.

        Returns (n, 16) float32; (n, 0) where the lobes want none.

        Raises:
            QueryError: arrays differ in length, or a primitive is not there.
        """
        if self._lobes is None:
            return np.empty((len(primitives), 0), np.float32)
        return self._lobes.visibility_at(self._geometry, primitives, u, v)

    def _lobe_arguments(
        self, arrays: Mapping[str, Rows], free: Rows, visibility: Rows
    ) -> tuple[Rows, Rows]:
        if self._lobes is None:
            raise QueryError(f"{self.name}: no lobes here; environment_form tells in advance")
        checked = self._checked(arrays, tuple(arrays))
        queries = {**checked, "wi": self._mirrored(checked)}
        return self._lobes.evaluate(queries, free, visibility)

    def _checked(self, arrays: Mapping[str, object], names: tuple[str, ...]) -> dict[str, Rows]:
        """The arrays that a form with these names takes for a part of this kind."""
        checked: dict[str, Rows] = {}
        count = None
        for array in QUERY_ARRAYS:
            if array.name in names and array.kind in ("", self.kind):
                check = scalars if array.columns == 1 else vectors
                label = self._labels.get(array.name, array.name)
                checked[array.name] = check(label, arrays.get(array.name), count)
                count = len(checked[array.name])
        return checked


def _results(value: object, number: int, count: int) -> tuple[NDArray[np.float32], ...]:
    """`value`, checked to be a tuple of `number` writable arrays, each (count, COLUMNS).

    Raises:
        QueryError: it is not.
    """
    if not isinstance(value, tuple) or len(value) != number:
        raise QueryError(f"out: expected a tuple of {number} arrays, found {type(value).__name__}")
    for k, array in enumerate(value):
        vectors(name := f"out[{k}]", array, count, COLUMNS)
        if not (array.flags.c_contiguous and array.flags.writeable and array.flags.aligned):
            raise QueryError(f"{name}: expected a C-contiguous array that can be written")
    for k, array in enumerate(value):
        if any(np.may_share_memory(array, other) for other in value[:k]):
            raise QueryError("out: expected arrays of their own memory, found one memory twice")
    return value
