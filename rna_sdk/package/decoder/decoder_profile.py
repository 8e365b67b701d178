"""The decoder profile: the form that a host can run without an ONNX engine (spec/RNA.md, 6.4).

float32: Clip, Gemm, Relu, ..., Gemm, Clip, Exp, Sub, and Mul or MatMul
int8:    Clip, Mul, Add, then QuantizeLinear, DequantizeLinear and Gemm for each layer,
         Clip, Exp, Sub, and Mul or MatMul
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rna_sdk.package.decoder.onnx_fields import DataType
from rna_sdk.package.decoder.onnx_model import Model, Node, Tensor
from rna_sdk.package.decoder.saturation import can_saturate

_FLOAT32, _UINT8 = DataType.FLOAT, DataType.UINT8
_INT8, _INT32 = DataType.INT8, DataType.INT32


class _Outside(Exception):
    """The graph leaves the profile; the text says where."""


def outside_profile(model: Model) -> str | None:
    """Why the model is outside the decoder profile; None if it is inside."""
    try:
        _Walk(model).check()
    except _Outside as reason:
        return str(reason)
    return None


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


class _Walk:
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
        self._value = "queries"
        self._width = model.inputs[0].dims[1] or 0
        self._outputs = model.outputs[0].dims[1] or 0

    def check(self) -> None:
        """Raises _Outside where the graph leaves the profile."""
        self._take("Clip", _SCALAR, _SCALAR)
        if self._is_int8:
            self._take("Mul", _Operand(_FLOAT32, (self._width,)))
            self._take("Add", _Operand(_FLOAT32, (self._width,)))
        self._layers()
        self._take("Clip", _ZERO, _SCALAR)
        self._take("Exp")
        self._take("Sub", _ONE)
        if self._operator == "MatMul":
            self._take("MatMul", _Operand(_FLOAT32, (self._width, self._outputs)))
        else:
            self._take("Mul", _SCALAR)
        if self._operator != "nothing":
            raise _Outside(f"{self._operator} behind the last node")
        if self._dequantizers:
            raise _Outside("a DequantizeLinear that no layer reads")

    def _layers(self) -> None:
        while True:
            steps = [
                self._constants[self._take(operator, _SCALAR, _ZERO_POINT).inputs[1]]
                for operator in ("QuantizeLinear", "DequantizeLinear")
                if self._is_int8
            ]
            if len({bytes(step.raw or b"") for step in steps}) > 1:
                raise _Outside(f"two scales before {self._value}, expected one")
            self._take_gemm(*steps[:1])
            if self._operator == "Clip":
                return
            if not self._is_int8:
                self._take("Relu")

    @property
    def _operator(self) -> str:
        """Operator of the next node."""
        return self._chain[self._at].operator if self._at < len(self._chain) else "nothing"

    def _take(self, operator: str, *operands: _Operand) -> Node:
        """The next node, which is this one, of the value and these constants."""
        node = self._next(operator)
        self._check_constants(node, node.inputs[1:], operands)
        return node

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

    def _take_gemm(self, *step: Tensor) -> None:
        """step: of int8, the scale of the inputs."""
        node = self._next("Gemm")
        if len(node.inputs) != 3:
            raise _Outside(f"Gemm of {len(node.inputs)} operands, expected 3")
        if self._is_int8:
            weight = self._dequantized(node.inputs[1], axis=1)
            bias = self._dequantized(node.inputs[2], axis=0)
        else:
            weight, bias = node.inputs[1:2], node.inputs[2:]
        dims = self._constants[weight[0]].dims if weight[0] in self._constants else ()
        outputs = dims[-1] if dims else 0
        weight_type, bias_type = (_INT8, _INT32) if self._is_int8 else (_FLOAT32, _FLOAT32)
        scales = (_Operand(_FLOAT32, (outputs,)),) * self._is_int8
        self._check_constants(
            node, weight, (_Operand(weight_type, (self._width, outputs)), *scales)
        )
        self._check_constants(node, bias, (_Operand(bias_type, (outputs,)), *scales))
        for scale in step:
            of_weight, of_bias = (self._constants[names[1]] for names in (weight, bias))
            if not np.array_equal(of_bias.values(), scale.values() * of_weight.values()):
                raise _Outside(f"{of_bias.name}, expected the product of the other two scales")
        self._width = outputs

    def _dequantized(self, name: str, axis: int) -> tuple[str, ...]:
        """Constants of the DequantizeLinear that makes this operand of a Gemm, per channel."""
        maker = self._dequantizers.pop(name, None)
        if maker is None or maker.integers != {"axis": axis} or self._readers[name] != 1:
            raise _Outside(f"{name}, expected a DequantizeLinear of constants along axis {axis}")
        return maker.inputs

    def _check_constants(
        self, node: Node, names: tuple[str, ...], operands: tuple[_Operand, ...]
    ) -> None:
        where = f"{node.operator} that makes {node.outputs[0]}"
        if len(names) != len(operands):
            raise _Outside(f"{len(names)} constants of {where}, expected {len(operands)}")
        for name, operand in zip(names, operands, strict=True):
            tensor = self._constants.get(name)
            if tensor is None or not operand.fits(tensor):
                raise _Outside(f"{name or 'nothing'} of {where}, expected {operand}, raw")
