"""The numbers of a float32 decoder that keeps to the profile of spec/RNA.md, 6.4."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.decoder_profile import outside_profile
from rna_sdk.package.onnx_model import Model, read_model

Numbers = NDArray[np.float32]


@dataclass(frozen=True)
class ProfileLayers:
    """The constants of a float32 decoder of the profile.

    Attributes:
        limits: low and high of the queries.
        layers: (weight, bias) of each.
        top: of the exponents.
        unit: what the exponentials are multiplied by.
        colours: (n, outputs) for n exponentials; None where these are the outputs.
    """

    limits: tuple[float, float]
    layers: list[tuple[Numbers, Numbers]]
    top: float
    unit: float
    colours: Numbers | None

    @property
    def width(self) -> int:
        """Of the widest layer."""
        return max(len(bias) for _, bias in self.layers)


def profile_layers(model: bytes) -> ProfileLayers | None:
    """The constants of a decoder in ONNX; None of one in int8, or outside the profile."""
    graph = read_model(memoryview(model))
    if outside_profile(graph) is not None:
        return None
    if any(node.operator == "QuantizeLinear" for node in graph.nodes):
        return None
    constants = _constants(graph)
    operands = [(n.operator, [constants[name] for name in n.inputs[1:]]) for n in graph.nodes]
    layers = [(values[0], values[1]) for operator, values in operands if operator == "Gemm"]
    (low, high), (_, top) = (values for operator, values in operands if operator == "Clip")
    operator, (last,) = operands[-1]
    unit, colours = (float(last), None) if operator == "Mul" else (1.0, last)
    return ProfileLayers((float(low), float(high)), layers, float(top), unit, colours)


def _constants(graph: Model) -> dict[str, Numbers]:
    """Those that nodes read; others may be of any type."""
    read = {name for node in graph.nodes for name in node.inputs}
    return {
        tensor.name: np.frombuffer(tensor.raw or b"", "<f4").reshape(tensor.dims)
        for tensor in graph.initializers
        if tensor.name in read
    }
