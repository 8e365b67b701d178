"""Find the chain of fully connected layers inside a decoder's ONNX bytes."""

from __future__ import annotations

import struct
from collections import Counter
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.protobuf import Message

_FLOAT = 1  # TensorProto.DataType


@dataclass(frozen=True)
class Layer:
    """A fully connected layer: output = input @ weight + bias.

    Attributes:
        place: index of its node in the graph.
        input, output: names of the values.
        weight: (inputs, outputs) float32.
        bias: (outputs,) float32.
    """

    place: int
    input: str
    output: str
    weight: NDArray[np.float32]
    bias: NDArray[np.float32]


def find_chain(graph: Message, start: str) -> list[Layer]:
    """The layers that follow each other from the value `start`, with Relu and Clip in between.

    graph: an ONNX GraphProto. The chain ends before a node of another kind, and before a value
    that more than one node reads or that the graph gives out.
    """
    nodes = graph.messages(1)
    constants = {tensor.text(8): tensor for tensor in graph.messages(5)}
    readers = Counter(name for node in nodes for name in node.texts(1))
    readers.update(value.text(1) for value in graph.messages(12))
    chain: list[Layer] = []
    value = start
    for place, node in enumerate(nodes):
        if value not in node.texts(1):
            continue
        if readers[value] != 1:
            break
        if node.text(4) == "Gemm":
            layer = _layer(place, node, constants)
            if layer is None:
                break
            chain.append(layer)
        elif node.text(4) not in ("Relu", "Clip"):
            break
        value = node.texts(2)[0]
    return chain


def _layer(place: int, node: Message, constants: dict[str, Message]) -> Layer | None:
    """The node Gemm as a layer; None unless weight and bias are plain float32 constants."""
    inputs = node.texts(1)
    if len(inputs) != 3:
        return None
    options = {a.text(1): _number(a) for a in node.messages(5)}
    plain = (options.get("alpha", 1), options.get("beta", 1), options.get("transA", 0))
    weight, bias = (floats(constants.get(name)) for name in inputs[1:])
    if plain != (1, 1, 0) or weight is None or bias is None or weight.ndim != 2:
        return None
    weight = weight.T if options.get("transB", 0) else weight
    if bias.shape != weight.shape[1:]:
        return None
    return Layer(place, inputs[0], node.texts(2)[0], weight, bias)


def _number(attribute: Message) -> float:
    """An AttributeProto's value, which is f (field 2) or i (field 3)."""
    value = attribute.one(2)
    if isinstance(value, memoryview):
        return float(struct.unpack("<f", value)[0])
    return attribute.integer(3)


def floats(tensor: Message | None) -> NDArray[np.float32] | None:
    """A float32 TensorProto as an array; None where it is another, or not there."""
    if tensor is None or tensor.integer(2) != _FLOAT:
        return None
    packed = tensor.one(9) if tensor.has(9) else tensor.one(4)
    if not isinstance(packed, memoryview):
        return None
    return np.frombuffer(packed, "<f4").reshape(tensor.integers(1)).astype(np.float32)
