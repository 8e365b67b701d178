"""Assets on the GPU, with the interface of `rna_sdk.runtime`."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.decoder_packing import PackedDecoder, pack_decoder
from rna_gpu.device import Device
from rna_gpu.evaluator import Evaluator, GpuRows
from rna_gpu.part_buffers import part_uniform, upload_planes, upload_weights
from rna_gpu.records.part import ROW
from rna_sdk.errors import QueryError
from rna_sdk.package import Package, Tier, decoder_from_bytes
from rna_sdk.package.decoder.decoder_form import EMISSION, TRANSPORT
from rna_sdk.package.decoder.query_arrays import NEARBY, QUERY_ARRAYS

Rows = NDArray[np.float32]
_LABELS = {"position": "positions", "axis": "normals or tangents"}


class GpuPart:
    """One part of a tier on the GPU: a `GpuSurface` or a `GpuFiber`.

    Attributes:
        name: name of the part; of the asset if it has only one.
        kind: "surface" or "fiber".
        tier_part: the part's record in the tier.
        evaluators: of the part's decoders, by the name of their form: "transport", or "visible" and
            "shadowed"; and "emission" if the part emits.
        multiply_adds: cost of a transport query.
    """

    def __init__(self, device: Device, package: Package, tier: Tier, part: int, name: str) -> None:
        """Raises GpuError: a decoder does not fit."""
        record, tier_part = package.manifest.parts[part], tier.parts[part]
        self.name, self.kind, self.tier_part, self.device = name, record.kind, tier_part, device
        stored = package.planes(tier.name, part)
        planes = upload_planes(device, stored, name)

        self.evaluators: dict[str, Evaluator] = {}
        self.multiply_adds = 0
        for one in tier_part.decoders:
            model = package.decoder(tier.name, part, one.form.name)
            decoder = _packed(model, one.inputs, tier_part.channels, f"{name}, tier {tier.name}")
            uniform = part_uniform(decoder, tier_part, record.bounds, stored, one.form)
            buffers = [
                device.upload(uniform, "UNIFORM", what=f"{name}: record"),
                upload_weights(device, decoder, name),
                *planes,
            ]
            evaluator = Evaluator(device, decoder, record.kind, one.form, buffers)
            self.evaluators[one.form.name] = evaluator
            self.multiply_adds += 0 if one.form is EMISSION else decoder.multiply_adds

    @property
    def emits(self) -> bool:
        """Whether the part emits light."""
        return EMISSION.name in self.evaluators

    @property
    def uses_base_color(self) -> bool:
        """Whether `evaluate` needs the base colour of its points."""
        return bool(self.tier_part.uses_base_color)

    @property
    def nearby_lengths(self) -> tuple[float, float, float] | None:
        """As `nearby_lengths` of `rna_sdk.runtime`'s parts."""
        record = self.tier_part.nearby
        return None if record is None else record.lengths

    @property
    def transport(self) -> list[Evaluator]:
        """The evaluators of visible and shadowed light: one for both, or one of each."""
        return [one for name, one in self.evaluators.items() if name != EMISSION.name]

    def new_rows(self, capacity: int) -> GpuRows:
        """Buffers for `capacity` transport queries, for `evaluate_on_gpu`. Raises GpuError."""
        return self.transport[0].new_rows(capacity)

    def evaluate_on_gpu(self, rows: GpuRows, most: int) -> None:
        """Evaluate the queries in `rows`, as written by the caller's shaders, into `rows.results`.

        most: upper bound of `rows.count`, at most `rows.capacity`.
        """
        for evaluator in self.transport:
            evaluator.dispatch(rows, most)

    def decode(self, form: str, arrays: Mapping[str, Rows]) -> Rows:
        """Results of a decoder, (n, colours, 3): like `decode` of `rna_sdk.runtime`'s parts.

        0 where the part has no such decoder.
        """
        rows = _rows(arrays, self.kind, self.uses_base_color)
        if NEARBY.name in arrays and self.nearby_lengths is not None:
            rows["nearby"] = _words(NEARBY.name, arrays[NEARBY.name], rows["nearby"].shape)
            rows["has_nearby"] = 1
        evaluators = self.transport if form == TRANSPORT.name else []
        if form in self.evaluators:
            evaluators = [self.evaluators[form]]
        if not evaluators:
            return np.zeros((len(rows), 1, 3), np.float32)
        return np.concatenate([evaluator.run(rows) for evaluator in evaluators], axis=1)

    def _evaluate(self, **arrays: Rows | None) -> tuple[Rows, Rows]:
        given = {name: array for name, array in arrays.items() if array is not None}
        transport = self.decode(TRANSPORT.name, given)
        return np.ascontiguousarray(transport[:, 0]), np.ascontiguousarray(transport[:, 1])

    def _emission(self, **arrays: Rows) -> Rows:
        return np.ascontiguousarray(self.decode(EMISSION.name, arrays)[:, 0])


class GpuSurface(GpuPart):
    """A part whose geometry is a mesh."""

    def evaluate(
        self,
        positions: Rows,
        normals: Rows,
        wo: Rows,
        wi: Rows,
        base_color: Rows | None = None,
        nearby: Rows | None = None,
    ) -> tuple[Rows, Rows]:
        """Like `rna_sdk.runtime.SurfaceAsset.evaluate`, within the tolerance of the spec (8.2)."""
        return self._evaluate(
            position=positions,
            axis=normals,
            wo=wo,
            wi=wi,
            base_color=base_color,
            nearby=nearby,
        )

    def emission(self, positions: Rows, normals: Rows, wo: Rows) -> Rows:
        """Like `rna_sdk.runtime.SurfaceAsset.emission`."""
        return self._emission(position=positions, axis=normals, wo=wo)


class GpuFiber(GpuPart):
    """A part whose geometry is curves."""

    def evaluate(
        self,
        positions: Rows,
        tangents: Rows,
        h: Rows,
        wo: Rows,
        wi: Rows,
        nearby: Rows | None = None,
    ) -> tuple[Rows, Rows]:
        """Like `rna_sdk.runtime.FiberAsset.evaluate`, within the tolerance of the spec (8.2)."""
        return self._evaluate(position=positions, axis=tangents, h=h, wo=wo, wi=wi, nearby=nearby)

    def emission(self, positions: Rows, tangents: Rows, h: Rows, wo: Rows) -> Rows:
        """Like `rna_sdk.runtime.FiberAsset.emission`."""
        return self._emission(position=positions, axis=tangents, h=h, wo=wo)


class GpuAsset:
    """One tier of a package of several parts on the GPU; made by `load`.

    Attributes:
        name: name of the asset.
        tier: the tier's record.
        parts: the parts, in the manifest's order.
        device: the GPU that holds them.
    """

    def __init__(
        self, name: str, tier: Tier, parts: tuple[GpuSurface | GpuFiber, ...], device: Device
    ) -> None:
        self.name, self.tier, self.parts, self.device = name, tier, parts, device


def _packed(model: memoryview, inputs: tuple[str, ...], channels: int, name: str) -> PackedDecoder:
    return pack_decoder(decoder_from_bytes(model, name), inputs, channels, name)


def _rows(arrays: Mapping[str, Rows], kind: str, uses_base_color: bool) -> NDArray[Any]:
    """(n,) of dtype ROW.dtype; wi is wo where no block reads it.

    Raises QueryError: an argument is missing, or no float32 array of n rows.
    """
    count = len(arrays["position"])
    rows = np.zeros(count, ROW.dtype)
    for array in QUERY_ARRAYS:
        if array.kind not in ("", kind) or (array.is_factor and not uses_base_color):
            continue
        values = arrays.get(array.name, None if array.is_factor else arrays["wo"])
        shape = (count,) if array.columns == 1 else (count, array.columns)
        words = _words(_LABELS.get(array.name, array.name), values, shape)
        if array.is_factor:
            rows["red"], rows["green"], rows["blue"] = words.T
        else:
            rows[array.name] = words
    return rows


def _words(name: str, value: object, shape: tuple[int, ...]) -> NDArray[np.uint32]:
    """The bits of an argument. Raises QueryError: it is no float32 array of this shape."""
    if not isinstance(value, np.ndarray) or value.dtype != np.float32 or value.shape != shape:
        found = f"{value.shape} {value.dtype}" if isinstance(value, np.ndarray) else repr(value)
        raise QueryError(f"{name}: expected a {shape} float32 array, found {found}")
    return np.ascontiguousarray(value).view(np.uint32)
