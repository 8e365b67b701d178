"""A decoder of the profile as arrays, for hosts that run it without an ONNX engine."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.errors import QueryError
from rna_sdk.package.decoder.decoder_profile import outside_profile
from rna_sdk.package.decoder.onnx_model import Node, read_model


@dataclass(frozen=True, eq=False)
class ProfileLayer:
    """A fully connected layer: in float32 `y = x weight + bias`.

    In int8 `y = (q weight + bias) unit` with q = clip(round(x / step), 0, 255), rounding halves to
    even.

    Attributes:
        weight: (inputs, outputs) float32 or int8.
        bias: (outputs,) float32 or int32.
        step: quantisation step of the inputs in int8, else 0.
        unit: (outputs,) float32 in int8, else None.
        relu: whether a ReLU follows.
    """

    weight: NDArray[Any]
    bias: NDArray[Any]
    step: float
    unit: NDArray[np.float32] | None
    relu: bool


@dataclass(frozen=True, eq=False)
class ProfileDecoder:
    """spec/RNA.md, 6.4: result = (exp(clip(layers(queries), 0, top)) - 1) times unit or matrix.

    Attributes:
        low, high: limits that queries are clipped to.
        gain, offset: (K,) float32, applied to clipped queries: x gain + offset; or None.
        layers: from K inputs to the outputs of the last layer.
        top: upper limit of the logarithm.
        unit: factor of the result; 1 if there is a matrix.
        matrix: (n, outputs) float32, or None.
    """

    low: float
    high: float
    gain: NDArray[np.float32] | None
    offset: NDArray[np.float32] | None
    layers: tuple[ProfileLayer, ...]
    top: float
    unit: float
    matrix: NDArray[np.float32] | None

    @property
    def is_int8(self) -> bool:
        """Whether the layers are in int8."""
        return self.layers[0].unit is not None

    @property
    def width(self) -> int:
        """Number of outputs of the widest layer."""
        return max(len(layer.bias) for layer in self.layers)


def read_profile_decoder(model: bytes | memoryview, name: str) -> ProfileDecoder:
    """The decoder in the ONNX bytes of a valid package; arrays are views of them.

    name: of the decoder, for errors.

    Raises:
        QueryError: the decoder is outside the decoder profile.

    Examples:
        >>> with Package.open("toy.rna") as package:
        ...     decoder = read_profile_decoder(package.decoder("small"), "small")
        ...     [layer.weight.shape[1] for layer in decoder.layers]
        [64, 64, 64, 64, 6]
    """
    graph = read_model(memoryview(model))
    outside = outside_profile(graph)
    if outside is not None:
        raise QueryError(f"{name}: decoder outside the decoder profile: {outside}")
    read = {name for node in graph.nodes for name in node.inputs}  # others may be of any type
    constants = {t.name: t.values() for t in graph.initializers if t.name in read}
    return _Reader(list(graph.nodes), constants).read()


class _Reader:
    def __init__(self, nodes: list[Node], constants: dict[str, NDArray[Any]]) -> None:
        self._constants = constants
        self._weights = {
            node.outputs[0]: node
            for node in nodes
            if node.operator == "DequantizeLinear" and node.inputs[0] in constants
        }
        self._chain = [node for node in nodes if node.outputs[0] not in self._weights]

    def read(self) -> ProfileDecoder:
        low, high = (float(limit) for limit in self._operands(0))
        names = [node.operator for node in self._chain]
        gain = offset = None
        if names[1] == "Mul":
            (gain,), (offset,) = self._operands(1), self._operands(2)
        gemms = [place for place, name in enumerate(names) if name == "Gemm"]
        top = float(self._operands(gemms[-1] + 1)[1])
        (last,) = self._operands(len(names) - 1)
        matrix = last if names[-1] == "MatMul" else None
        return ProfileDecoder(
            low,
            high,
            gain,
            offset,
            tuple(self._layer(place, names) for place in gemms),
            top,
            1.0 if matrix is not None else float(last),
            matrix,
        )

    def _operands(self, place: int) -> list[NDArray[Any]]:
        """Constant operands of a node in the chain, after its input."""
        return [self._constants[name] for name in self._chain[place].inputs[1:]]

    def _layer(self, place: int, names: list[str]) -> ProfileLayer:
        node, relu = self._chain[place], names[place + 1] == "Relu"
        if node.inputs[1] not in self._weights:
            weight, bias = self._operands(place)
            return ProfileLayer(weight, bias, 0.0, None, relu)
        (weight, _), (bias, unit) = (
            [self._constants[name] for name in self._weights[operand].inputs]
            for operand in node.inputs[1:]
        )
        step = float(self._operands(place - 1)[0])
        return ProfileLayer(weight, bias, step, unit, False)
