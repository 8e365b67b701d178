"""Find the fully connected layers of an int8 decoder inside its ONNX bytes.

A layer in the format's form is a Gemm of three DequantizeLinear, and mostly a QuantizeLinear
behind it.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.protobuf import Message

_DTYPES = {1: "<f4", 2: "u1", 3: "i1", 6: "<i4"}  # TensorProto.DataType
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


def find_int8_layers(graph: Message) -> list[Int8Layer]:
    """The layers of an ONNX GraphProto that read uint8, in its order."""
    view = _Graph(graph)
    layers = (view.layer(place) for place in range(len(view.nodes)))
    return [layer for layer in layers if layer is not None]


@dataclass(frozen=True)
class _Quantized:
    """What a DequantizeLinear reads: names, and values where they are constants."""

    place: int
    names: list[str]
    values: list[_Array | None]
    axis: int


class _Graph:
    def __init__(self, graph: Message) -> None:
        self.nodes = graph.messages(1)
        self._constants = {tensor.text(8): tensor for tensor in graph.messages(5)}
        self._makers = {name: k for k, n in enumerate(self.nodes) for name in n.texts(2)}
        self._readers = Counter(name for node in self.nodes for name in node.texts(1))
        self._readers.update(value.text(1) for value in graph.messages(12))

    def layer(self, place: int) -> Int8Layer | None:
        """The layer whose Gemm is the node at `place`; None for anything else."""
        gemm = self.nodes[place]
        if gemm.text(4) != "Gemm" or gemm.has(5):
            return None
        operands = [self._dequantized(name) for name in gemm.texts(1)]
        behind = self._quantizer(gemm.texts(2)[0])
        if len(operands) != 3:
            return None
        source, weights, biases = operands
        if source is None or weights is None or biases is None or len(source.names) != 3:
            return None
        constants = _constants(source, weights, biases)
        if constants is None:
            return None
        places, output = [place], gemm.texts(2)
        if behind is not None:
            places.insert(0, behind)
            output = [*self.nodes[behind].texts(2), *self.nodes[behind].texts(1)[1:]]
        for name, operand in zip(gemm.texts(1), (source, weights, biases), strict=True):
            if self._readers[name] == 1:
                places.append(operand.place)
        return Int8Layer(tuple(places), tuple(source.names), tuple(output), *constants)

    def _dequantized(self, name: str) -> _Quantized | None:
        place = self._makers.get(name)
        if place is None or self.nodes[place].text(4) != "DequantizeLinear":
            return None
        names = self.nodes[place].texts(1)
        axes = {a.text(1): a.integer(3) for a in self.nodes[place].messages(5)}
        if not axes.keys() <= {"axis"}:
            return None
        values = [numbers(self._constants.get(n)) for n in names]
        return _Quantized(place, names, values, axes.get("axis", 1))

    def _quantizer(self, name: str) -> int | None:
        """Place of the one node that reads the value, if it makes uint8 of it, on one scale."""
        if self._readers[name] != 1:
            return None
        place = next(k for k, node in enumerate(self.nodes) if name in node.texts(1))
        node = self.nodes[place]
        parts = [numbers(self._constants.get(n)) for n in node.texts(1)[1:]]
        if node.text(4) != "QuantizeLinear" or node.has(5) or len(parts) != 2:
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


def numbers(tensor: Message | None) -> _Array | None:
    """A TensorProto as an array; None where it is not there, or packed in another way."""
    if tensor is None or tensor.integer(2) not in _DTYPES:
        return None
    packed = tensor.one(9)
    if not isinstance(packed, memoryview):
        return None
    return np.frombuffer(packed, _DTYPES[tensor.integer(2)]).reshape(tensor.integers(1))
