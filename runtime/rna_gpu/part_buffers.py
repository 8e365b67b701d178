"""What group 0 of the shaders binds: a tier part's uniform, weights and planes."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.decoder_packing import UNIFORM_WEIGHTS, LayerRecord, PackedDecoder
from rna_gpu.device import Device
from rna_sdk.package import Bounds, Int8Planes, Planes, TierPart

_PRECISIONS = {"float32": 0, "float16": 1, "int8": 2}
_GROUP, _GROUPS = 4, 16

_LAYER = np.dtype(
    [(n, "<u4") for n in ("inputs", "outputs", "weights", "bias", "units", "relu")]
    + [("int8_step", "<f4"), ("reserved", "<u4")]
)
PART = np.dtype(
    [
        ("low", "<f4", 3),
        ("resolution", "<u4"),
        ("high", "<f4", 3),
        ("channel_groups", "<u4"),
        ("query_groups", "<u4"),
        ("layer_count", "<u4"),
        ("plane_precision", "<u4"),
        ("gain", "<u4"),
        ("limits", "<f4", 4),
        ("matrix", _LAYER),
        ("slots", "<u4", 12),
        ("scales", "<f4", (3, _GROUPS, _GROUP)),
        ("layers", _LAYER, 32),
    ]
)
"""RnaPart of `wgsl/part.wgsl`."""


def part_uniform(
    decoder: PackedDecoder, part: TierPart, bounds: Bounds, planes: Planes
) -> NDArray[Any]:
    """RnaPart, () of dtype PART."""
    record = np.zeros((), PART)
    record["low"], record["high"] = bounds.corners()
    record["resolution"] = part.resolution
    record["channel_groups"] = -(-part.channels // _GROUP)
    record["plane_precision"] = _PRECISIONS[part.plane_precision]
    record["query_groups"] = decoder.query_groups
    record["layer_count"] = len(decoder.layers)
    record["gain"] = decoder.gain
    record["limits"] = decoder.limits
    record["matrix"] = _layer(decoder.matrix)
    record["slots"] = decoder.slots
    if isinstance(planes, Int8Planes):
        record["scales"].reshape(3, -1)[:, : part.channels] = planes.scales
    record["layers"][: len(decoder.layers)] = [_layer(layer) for layer in decoder.layers]
    return record


def _layer(record: LayerRecord) -> tuple[float, ...]:
    sizes = record.inputs, record.outputs, record.weights, record.bias, record.units, record.relu
    return *sizes, record.int8_step, 0


def upload_planes(device: Device, planes: Planes, name: str) -> list[Any]:
    """Three storage buffers: XY, YZ, ZX, with channels filled up to a multiple of 4.

    Raises:
        GpuError: a plane does not fit.
    """
    texels = planes.texels if isinstance(planes, Int8Planes) else planes
    padding = -texels.shape[-1] % _GROUP
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
