"""Assets on the GPU, with the interface of `rna_sdk.runtime`."""

from __future__ import annotations

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
from rna_sdk.package.decoder.query_arrays import QUERY_ARRAYS

Rows = NDArray[np.float32]
_LABELS = {"position": "positions", "axis": "normals or tangents"}


class GpuPart:
    """One part of a tier on the GPU: a `GpuSurface` or a `GpuFiber`.

    Attributes:
        name: name of the part; of the asset if it has only one.
        kind: "surface" or "fiber".
        tier_part: the part's record in the tier.
        transport: evaluator of (visible, shadowed).
        emitter: evaluator of emitted radiance; None if the part does not emit.
        multiply_adds: cost of a transport query.
    """

    def __init__(self, device: Device, package: Package, tier: Tier, part: int, name: str) -> None:
        """Raises GpuError: a decoder does not fit."""
        record, tier_part = package.manifest.parts[part], tier.parts[part]
        self.name, self.kind, self.tier_part, self.device = name, record.kind, tier_part, device
        stored = package.planes(tier.name, part)
        planes = upload_planes(device, stored, name)

        self._evaluators: dict[str, Evaluator] = {}
        for one in tier_part.decoders:
            model = package.decoder(tier.name, part, one.form.name)
            decoder = _packed(model, one.inputs, tier_part.channels, f"{name}, tier {tier.name}")
            uniform = part_uniform(decoder, tier_part, record.bounds, stored)
            buffers = [
                device.upload(uniform, "UNIFORM", what=f"{name}: record"),
                upload_weights(device, decoder, name),
                *planes,
            ]
            colours = len(one.form.results)
            evaluator = Evaluator(device, decoder, record.kind, colours, buffers)
            self._evaluators[one.form.name] = evaluator
            if one.form.name == "transport":
                self.transport, self.multiply_adds = evaluator, decoder.multiply_adds
        self.emitter = self._evaluators.get("emission")

    @property
    def emits(self) -> bool:
        """Whether the part emits light."""
        return self.emitter is not None

    def new_rows(self, capacity: int) -> GpuRows:
        """Buffers for `capacity` transport queries, for `evaluate_on_gpu`. Raises GpuError."""
        return self.transport.new_rows(capacity)

    def evaluate_on_gpu(self, rows: GpuRows, most: int) -> None:
        """Evaluate the queries in `rows`, as written by the caller's shaders, into `rows.results`.

        most: upper bound of `rows.count`, at most `rows.capacity`.
        """
        self.transport.dispatch(rows, most)

    def decode(self, form: str, arrays: Mapping[str, Rows]) -> Rows:
        """Results of a decoder, (n, colours, 3): like `decode` of `rna_sdk.runtime`'s parts.

        0 where the part has no such decoder.
        """
        evaluator = self._evaluators.get(form)
        rows = _rows(arrays, self.kind)
        return np.zeros((len(rows), 1, 3), np.float32) if evaluator is None else evaluator.run(rows)

    def _evaluate(self, **arrays: Rows) -> tuple[Rows, Rows]:
        transport = self.decode("transport", arrays)
        return np.ascontiguousarray(transport[:, 0]), np.ascontiguousarray(transport[:, 1])

    def _emission(self, **arrays: Rows) -> Rows:
        return np.ascontiguousarray(self.decode("emission", arrays)[:, 0])


class GpuSurface(GpuPart):
    """A part whose geometry is a mesh."""

    def evaluate(self, positions: Rows, normals: Rows, wo: Rows, wi: Rows) -> tuple[Rows, Rows]:
        """Like `rna_sdk.runtime.SurfaceAsset.evaluate`, within the tolerance of the spec (8.2)."""
        return self._evaluate(position=positions, axis=normals, wo=wo, wi=wi)

    def emission(self, positions: Rows, normals: Rows, wo: Rows) -> Rows:
        """Like `rna_sdk.runtime.SurfaceAsset.emission`."""
        return self._emission(position=positions, axis=normals, wo=wo)


class GpuFiber(GpuPart):
    """A part whose geometry is curves."""

    def evaluate(
        self, positions: Rows, tangents: Rows, h: Rows, wo: Rows, wi: Rows
    ) -> tuple[Rows, Rows]:
        """Like `rna_sdk.runtime.FiberAsset.evaluate`, within the tolerance of the spec (8.2)."""
        return self._evaluate(position=positions, axis=tangents, h=h, wo=wo, wi=wi)

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


def _rows(arrays: Mapping[str, Rows], kind: str) -> NDArray[Any]:
    """(n,) of dtype ROW.dtype; wi is wo where no block reads it.

    Raises QueryError: an argument is no float32 array of n rows.
    """
    count = len(arrays["position"])
    rows = np.zeros(count, ROW.dtype)
    for array in QUERY_ARRAYS:
        if array.kind in ("", kind):
            values = arrays.get(array.name, arrays["wo"])
            shape = (count,) if array.columns == 1 else (count, array.columns)
            _check(_LABELS.get(array.name, array.name), values, shape)
            rows[array.name] = np.ascontiguousarray(values).view(np.uint32)
    return rows


def _check(name: str, value: object, shape: tuple[int, ...]) -> None:
    if not isinstance(value, np.ndarray) or value.dtype != np.float32 or value.shape != shape:
        found = f"{value.shape} {value.dtype}" if isinstance(value, np.ndarray) else repr(value)
        raise QueryError(f"{name}: expected a {shape} float32 array, found {found}")
