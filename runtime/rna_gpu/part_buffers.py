"""The bindings of the shaders' group 0: a tier part's uniform, weights and planes."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.decoder_packing import PackedDecoder
from rna_gpu.device import Device
from rna_gpu.records.part import GROUP, LAYER, NONE, PART, PRECISIONS, UNIFORM_WEIGHTS
from rna_sdk.package import Bounds, Int8Planes, Planes, TierPart
from rna_sdk.package.decoder.decoder_form import DecoderForm


def part_uniform(
    decoder: PackedDecoder, part: TierPart, bounds: Bounds, planes: Planes, form: DecoderForm
) -> NDArray[Any]:
    """RnaPart, () of dtype PART.dtype. form: of the decoder."""
    record = np.zeros((), PART.dtype)
    if form.has_factors:
        _fill_factors(record, part, form)
    record["low"], record["high"] = bounds.corners()
    record["resolution"] = part.resolution
    record["channel_groups"] = -(-part.channels // GROUP)
    record["plane_precision"] = PRECISIONS[part.plane_precision]
    record["query_groups"] = decoder.query_groups
    record["layer_count"] = len(decoder.layers)
    record["gain"] = decoder.gain
    for name, limit in decoder.limits.items():
        record[name] = limit
    record["matrix"] = decoder.matrix
    slots = record["slots"].reshape(-1)
    slots[:] = NONE
    slots[: len(decoder.slots)] = decoder.slots
    if isinstance(planes, Int8Planes):
        record["scales"].reshape(3, -1)[:, : part.channels] = planes.scales
    record["layers"][: len(decoder.layers)] = LAYER.stacked(decoder.layers)
    return record


def _fill_factors(record: NDArray[Any], part: TierPart, form: DecoderForm) -> None:
    """Which columns of the results base colour and nearby light multiply."""
    if part.uses_base_color:
        record["factors"] = form.width(None)
    if part.nearby is not None:
        record["nearby_columns"] = form.width(None, bool(part.uses_base_color))
        means = {"visible": part.nearby.visible, "shadowed": part.nearby.shadowed}
        for row, name in zip(record["means"], form.results, strict=False):
            row[:3] = means[name]


def upload_planes(device: Device, planes: Planes, name: str) -> list[Any]:
    """Three storage buffers: XY, YZ, ZX, with channels filled up to a multiple of 4.

    Raises:
        GpuError: a plane does not fit.
    """
    texels = planes.texels if isinstance(planes, Int8Planes) else planes
    padding = -texels.shape[-1] % GROUP
    buffers = []
    for plane, axes in zip(texels, ("XY", "YZ", "ZX"), strict=True):
        whole = np.pad(plane, ((0, 0), (0, 0), (0, padding))) if padding else plane
        buffers.append(device.upload(whole, "STORAGE", what=f"{name}: plane {axes}"))
    return buffers


def upload_weights(device: Device, decoder: PackedDecoder, name: str) -> Any:
    """A uniform buffer of 64 KiB, or a storage buffer where they do not fit."""
    if weights_file(decoder) == "weights_storage.wgsl":
        return device.upload(decoder.weights, "STORAGE", what=f"{name}: weights")
    padding = UNIFORM_WEIGHTS - len(decoder.weights)
    weights = np.pad(decoder.weights, ((0, padding), (0, 0)))
    return device.upload(weights, "UNIFORM", what=f"{name}: weights")


def weights_file(decoder: PackedDecoder) -> str:
    """The WGSL file that reads the weights."""
    fits = len(decoder.weights) <= UNIFORM_WEIGHTS
    return "weights_uniform.wgsl" if fits else "weights_storage.wgsl"
