"""A decoder as vec4f, in the layout of `wgsl/README.md`."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.records.part import GROUP, LAYER, MAX_EXACT_INPUTS, MAX_LAYERS, NONE
from rna_sdk.errors import QueryError
from rna_sdk.package import INPUT_BLOCKS, ProfileDecoder, ProfileLayer

Vec4s = NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class PackedDecoder:
    """A decoder for the GPU.

    Attributes:
        weights: (n, 4) float32, what binding 1 holds.
        slots: first group of each block in the order of INPUT_BLOCKS, NONE for the others.
        query_groups: groups of columns of the queries.
        limits: by their names in RnaPart.
        layers, matrix: of dtype LAYER; matrix: all 0 without one.
        groups: RNA_GROUPS, the room for the widest layer.
        multiply_adds: of a query, padding not counted.
    """

    weights: Vec4s
    slots: tuple[int, ...]
    query_groups: int
    gain: int
    limits: dict[str, float]
    layers: tuple[NDArray[Any], ...]
    matrix: NDArray[Any]
    groups: int
    multiply_adds: int


def pack_decoder(
    decoder: ProfileDecoder, inputs: tuple[str, ...], channels: int, name: str, more: int = 0
) -> PackedDecoder:
    """The decoder for these input blocks, `channels` wide features; name: for messages.

    more: columns behind those of the blocks, a multiple of GROUP, as decoders of lobes have.

    Raises:
        QueryError: the decoder is larger than the shader takes.
    """
    _check(decoder, name)
    columns, slots, query_groups = _spread(inputs, channels, more)
    pieces = _Pieces()
    gain = NONE
    if decoder.gain is not None and decoder.offset is not None:
        gain = pieces.add(_placed(decoder.gain, columns, query_groups))
        pieces.add(_placed(decoder.offset, columns, query_groups))
    layers = [_pack_layer(decoder.layers[0], pieces, columns, query_groups)]
    layers += [_pack_layer(layer, pieces) for layer in decoder.layers[1:]]
    matrix, work = np.zeros((), LAYER.dtype), sum(layer.weight.size for layer in decoder.layers)
    if decoder.matrix is not None:
        nothing = np.zeros(decoder.matrix.shape[1], np.float32)
        matrix = _pack_layer(ProfileLayer(decoder.matrix, nothing, 0.0, None, False), pieces)
        work += decoder.matrix.size
    widest = max(int(layer[side]) for layer in (*layers, matrix) for side in ("inputs", "outputs"))
    return PackedDecoder(
        weights=np.concatenate(pieces.arrays),
        slots=slots,
        query_groups=query_groups,
        gain=gain,
        limits={
            "query_low": decoder.low,
            "query_high": decoder.high,
            "top": decoder.top,
            "unit": decoder.unit,
        },
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
    inputs: tuple[str, ...], channels: int, more: int
) -> tuple[NDArray[np.intp], tuple[int, ...], int]:
    """Padded index of each query column, first group of each block, and number of groups."""
    places: list[NDArray[np.intp]] = []
    slots, group = dict.fromkeys(INPUT_BLOCKS, NONE), 0
    for name in inputs:
        width = INPUT_BLOCKS[name] or channels
        slots[name] = group
        places.append(GROUP * group + np.arange(width))
        group += -(-width // GROUP)
    places.append(GROUP * group + np.arange(more))
    group += more // GROUP
    return np.concatenate(places), tuple(slots.values()), group


class _Pieces:
    """Arrays of vec4f, one behind the other."""

    def __init__(self) -> None:
        self.arrays: list[Vec4s] = []
        self._length = 0

    def add(self, values: NDArray[np.float32]) -> int:
        """Stores the values, a multiple of 4; returns their position."""
        place = self._length
        self.arrays.append(values.reshape(-1, GROUP).astype(np.float32))
        self._length += len(self.arrays[-1])
        return place


def _placed(values: NDArray[np.float32], columns: NDArray[np.intp], groups: int) -> Vec4s:
    spread = np.zeros((groups * GROUP, *values.shape[1:]), np.float32)
    spread[columns] = values
    return spread


def _pack_layer(
    layer: ProfileLayer, pieces: _Pieces, columns: NDArray[np.intp] | None = None, inputs: int = 0
) -> NDArray[Any]:
    """A layer's record of dtype LAYER.

    columns, inputs: of the first layer, where its rows go and the groups that they fill.
    """
    rows, width = layer.weight.shape
    inputs, outputs = inputs or -(-rows // GROUP), -(-width // GROUP)
    padding = outputs * GROUP - width
    weight = np.pad(layer.weight.astype(np.float32), ((0, 0), (0, padding)))
    weight = _placed(weight, np.arange(rows) if columns is None else columns, inputs)
    blocks = weight.reshape(inputs, GROUP, outputs, GROUP).transpose(2, 0, 1, 3)
    unit = np.zeros(0, np.float32) if layer.unit is None else layer.unit
    record = np.zeros((), LAYER.dtype)
    record["inputs"], record["outputs"] = inputs, outputs
    record["weights"] = pieces.add(blocks)
    record["bias"] = pieces.add(np.pad(layer.bias.astype(np.float32), (0, padding)))
    record["units"] = pieces.add(np.pad(unit, (0, padding))) if len(unit) else 0
    record["relu"], record["int8_step"] = layer.relu, layer.step
    return record
