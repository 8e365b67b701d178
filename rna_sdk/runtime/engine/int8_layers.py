"""Find the fully connected layers of an int8 decoder inside its ONNX bytes.

A layer in the format's form is a Gemm of three DequantizeLinear, and mostly a QuantizeLinear
behind it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.decoder.onnx_model import Model

_Array = NDArray[Any]


@dataclass(frozen=True)
class Int8Layer:
    """output = input @ weight + bias; a value is (number - zero point) * scale.

    Attributes:
        places: indices of its nodes in the graph: its last one first, and of its
            DequantizeLinear those that nothing else reads.
        input: names of the uint8 value, its scale and its zero point.
        output: the same; or the name of a float32 value alone.
        weight: (inputs, outputs) int8, with zero point 0.
        weight_scale: (outputs,) float32.
        bias: (outputs,) int32, in steps of input scale times weight scale.
    """

    places: tuple[int, ...]
    input: tuple[str, ...]
    output: tuple[str, ...]
    weight: NDArray[np.int8]
    weight_scale: NDArray[np.float32]
    bias: NDArray[np.int32]


def find_int8_layers(model: Model) -> list[Int8Layer]:
    """The layers of the model that read uint8, in its order."""
    finder = _Finder(model)
    layers = (finder.layer(place) for place in range(len(model.nodes)))
    return [layer for layer in layers if layer is not None]


@dataclass(frozen=True)
class _Quantized:
    """Inputs of a DequantizeLinear: names, and values of constants."""

    place: int
    names: tuple[str, ...]
    values: list[_Array | None]
    axis: int


class _Finder:
    def __init__(self, model: Model) -> None:
        self._model = model
        self._makers = {name: k for k, node in enumerate(model.nodes) for name in node.outputs}

    def layer(self, place: int) -> Int8Layer | None:
        """The layer whose Gemm is the node at `place`; None for anything else."""
        gemm = self._model.nodes[place]
        if gemm.operator != "Gemm" or gemm.attributes or len(gemm.inputs) != 3:
            return None
        source, weights, biases = map(self._dequantized, gemm.inputs)
        if source is None or weights is None or biases is None or len(source.names) != 3:
            return None
        constants = _constants(source, weights, biases)
        if constants is None:
            return None
        places, output = [place], gemm.outputs
        behind = self._quantizer(gemm.outputs[0])
        if behind is not None:
            quantizer = self._model.nodes[behind]
            places.insert(0, behind)
            output = *quantizer.outputs, *quantizer.inputs[1:]
        for name, operand in zip(gemm.inputs, (source, weights, biases), strict=True):
            if self._model.readers[name] == 1:
                places.append(operand.place)
        return Int8Layer(tuple(places), source.names, output, *constants)

    def _dequantized(self, name: str) -> _Quantized | None:
        place = self._makers.get(name)
        if place is None or self._model.nodes[place].operator != "DequantizeLinear":
            return None
        node = self._model.nodes[place]
        if not set(node.attributes) <= {"axis"}:
            return None
        values = self._model.arrays(node.inputs)
        return _Quantized(place, node.inputs, values, node.integers.get("axis", 1))

    def _quantizer(self, name: str) -> int | None:
        """Place of the one node that reads the value, if it makes uint8 of it, on one scale."""
        if self._model.readers[name] != 1:
            return None
        place = next((k for k, n in enumerate(self._model.nodes) if name in n.inputs), None)
        if place is None:  # the graph gives it out
            return None
        node = self._model.nodes[place]
        parts = self._model.arrays(node.inputs[1:])
        if node.operator != "QuantizeLinear" or node.attributes or len(parts) != 2:
            return None
        scale, zero = parts
        if scale is None or zero is None or scale.ndim or zero.dtype != np.uint8:
            return None
        return place


def _constants(
    source: _Quantized, weights: _Quantized, biases: _Quantized
) -> tuple[_Array, _Array, _Array] | None:
    """Weight, weight scale and bias, where a convolution in integers can take them as they are."""
    _, input_scale, input_zero = source.values
    weight, weight_scale, *weight_zero = weights.values
    bias, bias_scale, *bias_zero = biases.values
    if input_scale is None or input_zero is None or weight is None or weight_scale is None:
        return None
    if bias is None or bias_scale is None or input_scale.ndim or input_zero.dtype != np.uint8:
        return None
    if any(zero is None or zero.any() for zero in (*weight_zero, *bias_zero)):
        return None
    outputs = weight.shape[-1]
    fits = weight.dtype == np.int8 and weight.ndim == 2 and weight_scale.shape == (outputs,)
    fits = fits and bias.dtype == np.int32 and bias.shape == bias_scale.shape == (outputs,)
    if not fits or weights.axis != 1 or biases.axis != 0:
        return None
    if not np.array_equal(bias_scale, input_scale * weight_scale):
        return None
    return weight, weight_scale, bias
