"""A decoder as vec4f, in the layout of `wgsl/README.md`."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rna_sdk.errors import QueryError
from rna_sdk.package import INPUT_BLOCKS, ProfileDecoder, ProfileLayer

NONE = 0xFFFFFFFF
MAX_LAYERS = 32  # of RnaPart
MAX_EXACT_INPUTS = 512  # 512 * 255 * 128 < 2^24: float32 holds sums of int8 layers exactly
UNIFORM_WEIGHTS = 4096  # vec4f in 64 KiB
_GROUP = 4
Vec4s = NDArray[np.float32]


@dataclass(frozen=True)
class LayerRecord:
    """RnaLayer: sizes in groups of 4 columns, places in vec4f."""

    inputs: int = 0
    outputs: int = 0
    weights: int = 0
    bias: int = 0
    units: int = 0
    relu: int = 0
    int8_step: float = 0.0


@dataclass(frozen=True, eq=False)
class PackedDecoder:
    """A decoder for the GPU.

    Attributes:
        weights: (n, 4) float32, what binding 1 holds.
        slots: first group of each block in the order of INPUT_BLOCKS, NONE for the others.
        query_groups: groups of columns of the queries.
        groups: RNA_GROUPS, the room for the widest layer.
        multiply_adds: of a query, padding not counted.
    """

    weights: Vec4s
    slots: tuple[int, ...]
    query_groups: int
    gain: int
    limits: tuple[float, float, float, float]
    layers: tuple[LayerRecord, ...]
    matrix: LayerRecord
    groups: int
    multiply_adds: int


def pack_decoder(
    decoder: ProfileDecoder, inputs: tuple[str, ...], channels: int, name: str
) -> PackedDecoder:
    """The decoder for these input blocks, `channels` wide features; name: for messages.

    Raises:
        QueryError: the decoder is larger than the shader takes.
    """
    _check(decoder, name)
    columns, slots, query_groups = _spread(inputs, channels)
    pieces = _Pieces()
    gain = NONE
    if decoder.gain is not None and decoder.offset is not None:
        gain = pieces.add(_placed(decoder.gain, columns, query_groups))
        pieces.add(_placed(decoder.offset, columns, query_groups))
    layers = [_pack_layer(decoder.layers[0], pieces, columns, query_groups)]
    layers += [_pack_layer(layer, pieces) for layer in decoder.layers[1:]]
    matrix, work = LayerRecord(), sum(layer.weight.size for layer in decoder.layers)
    if decoder.matrix is not None:
        nothing = np.zeros(decoder.matrix.shape[1], np.float32)
        matrix = _pack_layer(ProfileLayer(decoder.matrix, nothing, 0.0, None, False), pieces)
        work += decoder.matrix.size
    widest = max(max(layer.inputs, layer.outputs) for layer in (*layers, matrix))
    return PackedDecoder(
        weights=np.concatenate(pieces.arrays),
        slots=slots,
        query_groups=query_groups,
        gain=gain,
        limits=(decoder.low, decoder.high, decoder.top, decoder.unit),
        layers=tuple(layers),
        matrix=matrix,
        groups=max(4, 1 << (widest - 1).bit_length()),
        multiply_adds=work,
    )


def _check(decoder: ProfileDecoder, name: str) -> None:
    if len(decoder.layers) > MAX_LAYERS:
        found = f"found {len(decoder.layers)} layers, expected at most {MAX_LAYERS} on a GPU"
        raise QueryError(f"{name}: {found}")
    wide = max(0 if layer.unit is None else len(layer.weight) for layer in decoder.layers)
    if wide > MAX_EXACT_INPUTS:
        found = f"found an int8 layer of {wide} inputs, expected at most {MAX_EXACT_INPUTS}"
        raise QueryError(f"{name}: {found} on a GPU")


def _spread(
    inputs: tuple[str, ...], channels: int
) -> tuple[NDArray[np.intp], tuple[int, ...], int]:
    """Padded index of each query column, first group of each block, and number of groups."""
    places: list[NDArray[np.intp]] = []
    slots, group = dict.fromkeys(INPUT_BLOCKS, NONE), 0
    for name in inputs:
        width = INPUT_BLOCKS[name] or channels
        slots[name] = group
        places.append(_GROUP * group + np.arange(width))
        group += -(-width // _GROUP)
    return np.concatenate(places), tuple(slots.values()), group


class _Pieces:
    """Arrays of vec4f, one behind the other."""

    def __init__(self) -> None:
        self.arrays: list[Vec4s] = []
        self._length = 0

    def add(self, values: NDArray[np.float32]) -> int:
        """Stores the values, a multiple of 4; returns their position."""
        place = self._length
        self.arrays.append(values.reshape(-1, _GROUP).astype(np.float32))
        self._length += len(self.arrays[-1])
        return place


def _placed(values: NDArray[np.float32], columns: NDArray[np.intp], groups: int) -> Vec4s:
    spread = np.zeros((groups * _GROUP, *values.shape[1:]), np.float32)
    spread[columns] = values
    return spread


def _pack_layer(
    layer: ProfileLayer,
    pieces: _Pieces,
    columns: NDArray[np.intp] | None = None,
    inputs: int = 0,
) -> LayerRecord:
    """columns, inputs: of the first layer, where its rows go and the groups that they fill."""
    rows, width = layer.weight.shape
    inputs, outputs = inputs or -(-rows // _GROUP), -(-width // _GROUP)
    padding = outputs * _GROUP - width
    weight = np.pad(layer.weight.astype(np.float32), ((0, 0), (0, padding)))
    weight = _placed(weight, np.arange(rows) if columns is None else columns, inputs)
    blocks = weight.reshape(inputs, _GROUP, outputs, _GROUP).transpose(2, 0, 1, 3)
    unit = np.zeros(0, np.float32) if layer.unit is None else layer.unit
    return LayerRecord(
        inputs,
        outputs,
        pieces.add(blocks),
        pieces.add(np.pad(layer.bias.astype(np.float32), (0, padding))),
        pieces.add(np.pad(unit, (0, padding))) if len(unit) else 0,
        int(layer.relu),
        layer.step,
    )
