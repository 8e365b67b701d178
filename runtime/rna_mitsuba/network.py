"""Decoders (spec/RNA.md, 6.2) in Dr.Jit, by drjit.nn's matrix-vector products."""

import drjit as dr
import drjit.nn as nn
import mitsuba as mi
import numpy as np

from rna_sdk.package import ProfileDecoder, ProfileLayer


class Network:
    """A decoder as code of the kernel that calls it; weights are float32 in device memory.

    Layers in int8 are sums of whole numbers, which float32 holds exactly below 2^24.
    """

    def __init__(self, decoder: ProfileDecoder) -> None:
        self._decoder = decoder
        matrices = [layer.weight.T for layer in decoder.layers]
        vectors = [layer.bias for layer in decoder.layers]
        if decoder.matrix is not None:
            matrices, vectors = [*matrices, decoder.matrix.T], [*vectors, decoder.matrix[0] * 0]
        arrays = [a for pair in zip(matrices, vectors, strict=True) for a in pair]
        tensors = [mi.TensorXf(np.ascontiguousarray(a, np.float32)) for a in arrays]
        packed = nn.pack(*tensors, layout="training")  # forward and backward derivatives
        self._layers = list(zip(packed[::2], packed[1::2], strict=True))

    def __call__(self, columns: list[mi.Float]) -> list[mi.Float]:
        """The outputs for the columns of `queries`."""
        decoder = self._decoder
        values = [dr.clip(x, decoder.low, decoder.high) for x in columns]
        if decoder.gain is not None and decoder.offset is not None:
            pairs = zip(decoder.gain.tolist(), decoder.offset.tolist(), strict=True)
            values = [x * g + b for x, (g, b) in zip(values, pairs, strict=True)]
        for layer, place in zip(decoder.layers, self._layers, strict=False):
            values = _run_layer(layer, place, values)
        values = [dr.exp(dr.clip(x, 0, decoder.top)) - 1 for x in values]
        if decoder.matrix is None:
            return [x * decoder.unit for x in values]
        return list(nn.matvec(self._layers[-1][0], nn.CoopVec(*values)))


def _run_layer(
    layer: ProfileLayer, place: tuple[nn.MatrixView, nn.MatrixView], values: list[mi.Float]
) -> list[mi.Float]:
    weight, bias = place
    if layer.unit is not None:
        values = [dr.clip(dr.round(x / layer.step), 0, 255) for x in values]
    result = list(nn.matvec(weight, nn.CoopVec(*values), bias))
    if layer.unit is not None:
        result = [x * unit for x, unit in zip(result, layer.unit.tolist(), strict=True)]
    return [dr.maximum(x, 0) for x in result] if layer.relu else result
