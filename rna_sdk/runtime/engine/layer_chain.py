"""Find the chain of fully connected layers inside a decoder's ONNX bytes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.decoder.onnx_model import Model


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


def find_chain(model: Model, start: str) -> list[Layer]:
    """The layers that follow each other from the value `start`, with Relu and Clip in between.

    The chain ends before a node of another kind, and before a value that more than one node reads
    or that the graph gives out.
    """
    chain: list[Layer] = []
    value = start
    for place, node in enumerate(model.nodes):
        if value not in node.inputs:
            continue
        if model.readers[value] != 1:
            break
        if node.operator == "Gemm":
            layer = _layer(model, place)
            if layer is None:
                break
            chain.append(layer)
        elif node.operator not in ("Relu", "Clip"):
            break
        value = node.outputs[0]
    return chain


def _layer(model: Model, place: int) -> Layer | None:
    """The node Gemm as a layer; None unless weight and bias are plain float32 constants."""
    node = model.nodes[place]
    if len(node.inputs) != 3:
        return None
    plain = node.number("alpha", 1), node.number("beta", 1), node.number("transA", 0)
    weight, bias = (model.floats(name) for name in node.inputs[1:])
    if plain != (1, 1, 0) or weight is None or bias is None or weight.ndim != 2:
        return None
    weight = weight.T if node.number("transB", 0) else weight
    if bias.shape != weight.shape[1:]:
        return None
    return Layer(place, node.inputs[0], node.outputs[0], weight, bias)
