"""The decoder profile: the form that a host can run without an ONNX engine (spec/RNA.md, 6.4).

float32: Clip, Gemm, Relu, ..., Gemm, Clip, Exp, Sub, and Mul or MatMul
int8:    Clip, Mul, Add, then QuantizeLinear, DequantizeLinear and Gemm for each layer,
         Clip, Exp, Sub, and Mul or MatMul

The graph is read here once: what runs a decoder without the graph runs these layers.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.errors import QueryError
from rna_sdk.package.decoder.decoder_form import INPUT_NAME
from rna_sdk.package.decoder.onnx_fields import DataType
from rna_sdk.package.decoder.onnx_model import Model, Node, Tensor, read_model
from rna_sdk.package.decoder.saturation import can_saturate

_FLOAT32, _UINT8 = DataType.FLOAT, DataType.UINT8
_INT8, _INT32 = DataType.INT8, DataType.INT32


@dataclass(frozen=True, eq=False)
class ProfileLayer:
    """A fully connected layer: in float32 `y = x weight + bias`.

    In int8 `y = (q weight + bias) unit` with q = clip(round(x / step), 0, 255), rounding halves to
    even.

    Attributes:
        weight: (inputs, outputs) float32 or int8.
        bias: (outputs,) float32 or int32.
        step: quantisation step of the inputs in int8, else 0.
        scale: (outputs,) float32 in int8, what a step of the weights means; else None.
        relu: whether a ReLU follows.
    """

    weight: NDArray[Any]
    bias: NDArray[Any]
    step: float
    scale: NDArray[np.float32] | None
    relu: bool

    @property
    def unit(self) -> NDArray[np.float32] | None:
        """(outputs,) float32 in int8, else None."""
        return None if self.scale is None else np.float32(self.step) * self.scale


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
        return self.layers[0].scale is not None

    @property
    def outputs(self) -> int:
        """Number of columns of the result."""
        return len(self.layers[-1].bias) if self.matrix is None else len(self.matrix.T)

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
    decoder = read_profile(read_model(memoryview(model)))
    if isinstance(decoder, str):
        raise QueryError(f"{name}: decoder outside the decoder profile: {decoder}")
    return decoder


def read_profile(model: Model) -> ProfileDecoder | str:
    """The decoder of a model in the profile; else a text, where the graph leaves the profile.

    Arrays are views of the model's bytes.
    """
    try:
        return _Reader(model).read()
    except _Outside as reason:
        return str(reason)


class _Outside(Exception):
    """The graph leaves the profile; the text says where."""


def saturating_weights(model: Model) -> list[str]:
    """Names of the int8 matrices whose products can saturate a sum of two in 16 bits."""
    return [
        tensor.name
        for tensor in model.initializers
        if tensor.dtype == _INT8 and len(tensor.dims) == 2 and tensor.is_whole
        if can_saturate(tensor.values())
    ]


@dataclass(frozen=True)
class _Operand:
    """A constant operand: its type, its shape, () for a scalar, and its number, if it is fixed."""

    dtype: int
    shape: tuple[int, ...] = ()
    number: int | None = None

    def __str__(self) -> str:
        number = "" if self.number is None else f" that is {self.number}"
        return f"a constant of type {self.dtype} {list(self.shape)}{number}"

    def fits(self, tensor: Tensor) -> bool:
        """Whether the tensor is such a constant, its data raw."""
        if not tensor.is_whole or (tensor.dtype, tensor.dims) != (self.dtype, self.shape):
            return False
        return self.number is None or bool(tensor.values() == self.number)


_SCALAR, _ZERO, _ONE = _Operand(_FLOAT32), _Operand(_FLOAT32, (), 0), _Operand(_FLOAT32, (), 1)
_ZERO_POINT = _Operand(_UINT8, (), 0)


class _Reader:
    """Follows the one chain of nodes from queries to the output."""

    def __init__(self, model: Model) -> None:
        self._constants, self._readers = model.constants, model.readers
        self._dequantizers: dict[str, Node] = {}
        self._chain: list[Node] = []
        for node in model.nodes:
            if node.operator == "DequantizeLinear" and node.inputs[0] in self._constants:
                self._dequantizers[node.outputs[0]] = node
            else:
                self._chain.append(node)
        self._is_int8 = any(node.operator == "QuantizeLinear" for node in model.nodes)
        self._at = 0
        self._value = INPUT_NAME
        self._width = model.inputs[0].dims[1] or 0
        self._outputs = model.outputs[0].dims[1] or 0

    def read(self) -> ProfileDecoder:
        """The decoder. Raises _Outside where the graph leaves the profile."""
        low, high = self._take("Clip", _SCALAR, _SCALAR)
        gain = offset = matrix = None
        unit: NDArray[np.float32] | float = 1.0
        if self._is_int8:
            (gain,) = self._take("Mul", _Operand(_FLOAT32, (self._width,)))
            (offset,) = self._take("Add", _Operand(_FLOAT32, (self._width,)))
        layers = tuple(self._layers())
        _, top = self._take("Clip", _ZERO, _SCALAR)
        self._take("Exp")
        self._take("Sub", _ONE)
        if self._operator == "MatMul":
            (matrix,) = self._take("MatMul", _Operand(_FLOAT32, (self._width, self._outputs)))
        else:
            (unit,) = self._take("Mul", _SCALAR)
        if self._operator != "nothing":
            raise _Outside(f"{self._operator} behind the last node")
        if self._dequantizers:
            raise _Outside("a DequantizeLinear that no layer reads")
        limits = float(low), float(high)
        return ProfileDecoder(*limits, gain, offset, layers, float(top), float(unit), matrix)

    def _layers(self) -> Iterator[ProfileLayer]:
        last = False
        while not last:
            step = self._step() if self._is_int8 else None
            weight, bias, scale = self._take_gemm(step)
            last = self._operator == "Clip"
            if not last and not self._is_int8:
                self._take("Relu")
            relu = not (last or self._is_int8)
            yield ProfileLayer(weight, bias, 0.0 if step is None else float(step), scale, relu)

    def _step(self) -> NDArray[np.float32]:
        """Scale of the next value, which is quantised and made float32 again."""
        step, _ = self._take("QuantizeLinear", _SCALAR, _ZERO_POINT)
        again, _ = self._take("DequantizeLinear", _SCALAR, _ZERO_POINT)
        if step.tobytes() != again.tobytes():
            raise _Outside(f"two scales before {self._value}, expected one")
        return step

    @property
    def _operator(self) -> str:
        """Operator of the next node."""
        return self._chain[self._at].operator if self._at < len(self._chain) else "nothing"

    def _take(self, operator: str, *operands: _Operand) -> list[NDArray[Any]]:
        """Constants of the next node, which is this one, of the value and such constants."""
        node = self._next(operator)
        return self._values(node, node.inputs[1:], operands)

    def _next(self, operator: str) -> Node:
        """The next node, an `operator` without attributes of the value; its result is the next."""
        if self._operator != operator:
            raise _Outside(f"{self._operator}, expected {operator}, at {self._value}")
        node = self._chain[self._at]
        if node.inputs[:1] != (self._value,) or self._readers[self._value] != 1:
            raise _Outside(f"{self._value} is not read by {operator} alone")
        if node.attributes or len(node.outputs) != 1:
            raise _Outside(f"{operator} with attributes or several results at {self._value}")
        self._at += 1
        self._value = node.outputs[0]
        return node

    def _take_gemm(
        self, step: NDArray[np.float32] | None
    ) -> tuple[NDArray[Any], NDArray[Any], NDArray[np.float32] | None]:
        """Weight and bias, and in int8 the weight's scale; step: in int8, the inputs' scale."""
        node = self._next("Gemm")
        weights: tuple[str, ...]
        biases: tuple[str, ...]
        if len(node.inputs) != 3:
            raise _Outside(f"Gemm of {len(node.inputs)} operands, expected 3")
        if step is None:
            weights, biases = (node.inputs[1],), (node.inputs[2],)
            weight_type, bias_type = _FLOAT32, _FLOAT32
        else:
            weights = self._dequantized(node.inputs[1], axis=1)
            biases = self._dequantized(node.inputs[2], axis=0)
            weight_type, bias_type = _INT8, _INT32
        dims = self._constants[weights[0]].dims if weights[0] in self._constants else ()
        outputs = dims[-1] if dims else 0
        scales = (_Operand(_FLOAT32, (outputs,)),) * (step is not None)
        shape = self._width, outputs
        weight, *own = self._values(node, weights, (_Operand(weight_type, shape), *scales))
        bias, *units = self._values(node, biases, (_Operand(bias_type, (outputs,)), *scales))
        self._width = outputs
        if step is None:
            return weight, bias, None
        if not np.array_equal(units[0], step * own[0]):
            raise _Outside(f"{biases[1]}, expected the product of the other two scales")
        return weight, bias, own[0]

    def _dequantized(self, name: str, axis: int) -> tuple[str, ...]:
        """Constants of the DequantizeLinear that makes this operand of a Gemm, per channel."""
        maker = self._dequantizers.pop(name, None)
        if maker is None or maker.integers != {"axis": axis} or self._readers[name] != 1:
            raise _Outside(f"{name}, expected a DequantizeLinear of constants along axis {axis}")
        return maker.inputs

    def _values(
        self, node: Node, names: tuple[str, ...], operands: tuple[_Operand, ...]
    ) -> list[NDArray[Any]]:
        """The node's constants of these names, which are such operands."""
        where = f"{node.operator} that makes {node.outputs[0]}"
        if len(names) != len(operands):
            raise _Outside(f"{len(names)} constants of {where}, expected {len(operands)}")
        found = []
        for name, operand in zip(names, operands, strict=True):
            tensor = self._constants.get(name)
            if tensor is None or not operand.fits(tensor):
                raise _Outside(f"{name or 'nothing'} of {where}, expected {operand}, raw")
            found.append(tensor.values())
        return found
