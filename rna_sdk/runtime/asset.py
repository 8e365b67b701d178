"""A loaded asset: the common members of all kinds, and an asset of several parts."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, ClassVar, NoReturn, Self, TypeVar, cast

import numpy as np
from numpy.typing import NDArray

from rna_sdk.arrays import scalars, vectors
from rna_sdk.errors import QueryError
from rna_sdk.package import (
    BaseColor,
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
from rna_sdk.package.decoder.decoder_form import COLUMNS, SHADOWED, TRANSPORT, VISIBLE, form_named
from rna_sdk.package.decoder.query_arrays import NEARBY, QUERY_ARRAYS, Rows
from rna_sdk.package.manifest.extensions import USUAL_SAMPLING, Mixture
from rna_sdk.package.manifest.manifest_fields import Kind
from rna_sdk.package.textures.exchanged_images import check_images, with_images
from rna_sdk.runtime.engine.batch import Batch
from rna_sdk.runtime.engine.costs import cached_cost, median_seconds
from rna_sdk.runtime.part_lobes import PartLobes

if TYPE_CHECKING:
    from rna_sdk.runtime.fiber_asset import FiberAsset
    from rna_sdk.runtime.surface_asset import SurfaceAsset

_MEASURED_ROWS = 32_768
Evaluator = TypeVar("Evaluator")


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

    def with_base_color(
        self,
        images: Mapping[str, NDArray[np.uint8]] | None = None,
        tint: tuple[float, float, float] = (1.0, 1.0, 1.0),
    ) -> Self:
        """A copy of this asset with other base colours, which its `base_color_at` looks up.

        images: replacements by label (`label` of a record in `base_colors` of a part), (H, W, 3)
        uint8 in the record's colour space; row 0 is v = 0. tint: linear RGB factor of all base
        colours. Indirect light between surfaces of the asset keeps the colours of the capture.

        Raises:
            QueryError: no record has such a label, or an image is not an array of this form.
        """
        raise NotImplementedError

    def _twin(self) -> Self:
        """Another object with the same members: `copy` is refused, since the asset maps a file."""
        other = object.__new__(type(self))
        other.__dict__.update(self.__dict__)
        return other

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
        super().__init__(
            name,
            first.tier,
            first.domain,
            first.threads,
            bounds,
            emits,
            first._tiers,
            first._file_bytes,
        )
        self._parts = tuple(parts)

    @property
    def parts(self) -> tuple[SurfaceAsset | FiberAsset, ...]:
        return self._parts

    def with_base_color(
        self,
        images: Mapping[str, NDArray[np.uint8]] | None = None,
        tint: tuple[float, float, float] = (1.0, 1.0, 1.0),
    ) -> Self:
        """See `Asset`."""
        images = check_images(images, [c for part in self._parts for c in part.base_colors])
        other, parts = self._twin(), []
        for part in self._parts:
            labels = {record.label for record in part.base_colors}
            of_part = {label: image for label, image in images.items() if label in labels}
            parts.append(part.with_base_color(of_part, tint))
        other._parts = tuple(parts)
        return other


class AssetPart(Asset):
    """Common base of `SurfaceAsset` and `FiberAsset`.

    Attributes:
        kind: "surface" or "fiber".
        tier_part: the part's record in the tier.
        transmittance_records: holes and thin glass of a surface; see `transmittance`.
        normal_maps: normal maps of a surface; see `mapped_normals`.
        base_colors: base colour of a surface whose tier uses it; see `base_color_at`.
        environment_form: the manifest's record of the part's lobes, `lobes` of them; see `mirror`.
            None if the package has none for the part, or the geometry is a proxy's.
        sampling: lobes for rays that leave the part, by triangles; the usual ones if the package
            has none, or the geometry is a proxy's.
    """

    _labels: ClassVar[Mapping[str, str]]
    """Names of arrays in errors, as the arguments of `evaluate`."""

    def __init__(
        self,
        package: Package,
        tier: Tier,
        threads: int,
        part: int,
        name: str,
        pixels: float = math.inf,
        variant: str | None = None,
    ) -> None:
        """package: open. tier: one of its tiers. threads: at least 1. part: index of the part.

        pixels: as for `Package.geometry`. variant: as for `Package.base_color`.
        """
        # onnxruntime and numba load with the first asset, not with this module.
        from rna_sdk.runtime.engine.decoder_sessions import Decoder
        from rna_sdk.runtime.engine.tiles import QueryFiller, TileEvaluator

        record, tier_part = package.manifest.parts[part], tier.parts[part]
        box, emits = record.bounds, tier_part.emission is not None
        super().__init__(
            name=name,
            tier=tier,
            domain=package.manifest.domain,
            threads=threads,
            bounds=box.corners(),
            emits=emits,
            tiers=tuple(other.name for other in package.manifest.tiers),
            file_bytes=package.file_bytes,
        )
        self.kind: Kind = record.kind
        self.tier_part = tier_part
        self.transmittance_records: tuple[Transmittance, ...] = tuple(package.transmittance(part))
        self.normal_maps: tuple[NormalMap, ...] = tuple(package.normal_maps(part))
        filler = QueryFiller(package.planes(tier.name, part), box, tier_part, self.kind)
        self.base_colors: tuple[BaseColor, ...] = (
            tuple(package.base_color(part, variant)) if tier_part.uses_base_color else ()
        )
        evaluators = {
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
        self._evaluators = _by_answer(evaluators)
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
        self.sampling: tuple[Mixture, ...] = (
            (USUAL_SAMPLING[self.kind],) if proxied else package.sampling(part)
        )

    @property
    def parts(self) -> tuple[SurfaceAsset | FiberAsset, ...]:
        return (cast("SurfaceAsset | FiberAsset", self),)

    @property
    def nearby_lengths(self) -> tuple[float, float, float] | None:
        """Lengths of the nearby light that `evaluate` counts, metres; None of a part without."""
        record = self.tier_part.nearby
        return None if record is None else record.lengths

    def measured_part_ns(self) -> float:
        """`measured_ns_per_query` of this part."""
        return cached_cost(self._measure_ns_per_query, *self._digests, self.threads)

    def with_base_color(
        self,
        images: Mapping[str, NDArray[np.uint8]] | None = None,
        tint: tuple[float, float, float] = (1.0, 1.0, 1.0),
    ) -> Self:
        """See `Asset`."""
        other = self._twin()
        images = check_images(images, self.base_colors)
        other.base_colors = with_images(self.base_colors, images, tint)
        other.__dict__.pop("_base_color_maps", None)  # what is cached is of the old ones
        return other

    def _measure_ns_per_query(self) -> float:
        rng = np.random.default_rng(0)
        low, high = self.bounds
        arrays = {"position": rng.uniform(low, high, (_MEASURED_ROWS, 3)).astype(np.float32)}
        arrays["axis"], arrays["wo"], arrays["wi"] = rng.normal(size=(3, _MEASURED_ROWS, 3)).astype(
            np.float32
        )
        arrays["h"] = rng.uniform(-1, 1, _MEASURED_ROWS).astype(np.float32)
        arrays["base_color"] = rng.uniform(size=(_MEASURED_ROWS, 3)).astype(np.float32)
        seconds = median_seconds(lambda: self.decode(TRANSPORT.name, arrays))
        return 1e9 * seconds / _MEASURED_ROWS

    def decode(
        self, form: str, arrays: Mapping[str, object], out: object = None
    ) -> tuple[Rows, ...]:
        """The results of a decoder, each (n, 3) float32; 0 if the part has no such decoder.

        form: "transport" returns (visible, shadowed), "emission" (radiance,). arrays: the inputs of
        the form by name: position, axis (normal or tangent), h (fibers only), wo, wi,
        base_color where the tier part uses it, and nearby as for `evaluate`. out: arrays for the
        results, as for `evaluate`.

        Raises:
            QueryError: an array is missing, or is no float32 array of its shape; they differ in n;
                `out` is not writable, not contiguous, or shares memory with another array.
        """
        decoder_form = form_named(form)
        checked = self._checked(arrays, decoder_form.arrays)
        count = len(checked["wo"])
        number = decoder_form.result_count(decoder_form.record(self.tier_part))
        evaluators = self._evaluators.get(form, ())
        if out is None:
            make = np.empty if evaluators else np.zeros
            result = tuple(make((number, count, COLUMNS), np.float32))
        else:
            result = _results(out, number, count, checked)
        nearby = self._nearby_light(checked) if decoder_form.has_factors else None
        for k, evaluator in enumerate(evaluators):
            own = slice(None) if len(evaluators) == 1 else slice(k, k + 1)
            of_results = None if nearby is None else nearby[own]
            evaluator.run(Batch.of(checked, result[own], of_results))
        return result

    def _nearby_light(self, checked: Mapping[str, Rows]) -> tuple[Rows, ...] | None:
        """Nearby light for visible and for shadowed results; None of a part without."""
        record = self.tier_part.nearby
        if record is None:
            return None
        if NEARBY.name in checked:
            return checked[NEARBY.name], checked[NEARBY.name]
        shape = len(checked["wo"]), 1
        visible, shadowed = (
            np.tile(np.array(mean, np.float32), shape) for mean in (record.visible, record.shadowed)
        )
        return visible, shadowed

    def _transport(self, arrays: Mapping[str, object], visibility: object) -> Rows:
        """T, (n, 3) float32: of decoders apart, each row by those that count."""
        checked = self._checked(arrays, TRANSPORT.arrays)
        count = len(checked["wo"])
        shares = _shares(visibility, count)
        evaluators = self._evaluators[TRANSPORT.name]
        if len(evaluators) == 1:
            visible, shadowed = self.decode(TRANSPORT.name, checked)
            if isinstance(visibility, np.ndarray) and visibility.dtype == np.bool_:
                return np.where(visibility[:, None], visible, shadowed)
            return shares[0] * visible + shares[1] * shadowed
        result = np.zeros((count, COLUMNS), np.float32)
        for k, share in enumerate(shares):
            row = np.flatnonzero(share.any(axis=1))
            answer = np.empty((len(row), COLUMNS), np.float32)
            rows = {name: values.take(row, axis=0) for name, values in checked.items()}
            nearby = self._nearby_light(rows)
            own = None if nearby is None else nearby[k : k + 1]
            evaluators[k].run(Batch.of(rows, (answer,), own))
            result[row] += share.take(row, axis=0) * answer
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
        """Stored coefficients of the visibility at ray hits, an argument of `lobes`.

        primitives: (n,) indices of triangles, or of segments in the order of `Curves.segments()`.
        u, v: (n,) float32, barycentric coordinates of the second and third corner; of a segment u,
        from 0 at its first point to 1 at its second.

        Returns (n, 16) float32; (n, 0) if the lobes take no visibility.

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
            if array.is_factor and not self.tier_part.uses_base_color:
                continue
            if array.name in names and array.kind in ("", self.kind):
                check = scalars if array.columns == 1 else vectors
                label = self._labels.get(array.name, array.name)
                checked[array.name] = check(label, arrays.get(array.name), count)
                count = len(checked[array.name])
        nearby = arrays.get(NEARBY.name)
        if nearby is not None and self.tier_part.nearby is not None:
            checked[NEARBY.name] = vectors(NEARBY.name, nearby, count)
        return checked


def _by_answer(evaluators: dict[str, Evaluator]) -> dict[str, tuple[Evaluator, ...]]:
    """The evaluator of each of FORMS: one for all results, or one for each."""
    apart = [evaluators[form.name] for form in (VISIBLE, SHADOWED) if form.name in evaluators]
    answers = {TRANSPORT.name: tuple(apart)} if apart else {}
    others = {name: (one,) for name, one in evaluators.items() if one not in apart}
    return {**answers, **others}


def _shares(visibility: object, count: int) -> tuple[Rows, Rows]:
    """Shares of visible and of shadowed light, (n, 1) or (n, 3) float32 each.

    visibility: (n,) of bools, or (n,) or (n, 3) of numbers, which are taken into [0, 1]; both
    shares are 0 in a row with one that is not finite.

    Raises:
        QueryError: it is no such array.
    """
    if isinstance(visibility, np.ndarray) and visibility.ndim == 2:
        v = vectors("visibility", visibility, count)
    else:
        if isinstance(visibility, np.ndarray) and visibility.dtype == np.bool_:
            visibility = visibility.astype(np.float32)
        v = scalars("visibility", visibility, count)[:, None]
    known = np.isfinite(v).all(axis=1, keepdims=True)
    seen = np.clip(np.where(known, v, np.float32(0.0)), np.float32(0.0), np.float32(1.0))
    return seen, known.astype(np.float32) - seen


def _results(
    value: object, number: int, count: int, arrays: Mapping[str, Rows]
) -> tuple[NDArray[np.float32], ...]:
    """`value`, checked to be a tuple of `number` writable arrays, each (count, COLUMNS).

    They are none of the query's `arrays`, which a second decoder reads when the first has written.

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
        if any(np.may_share_memory(array, other) for other in arrays.values()):
            raise QueryError("out: expected arrays of their own memory, found memory of the query")
    return value
