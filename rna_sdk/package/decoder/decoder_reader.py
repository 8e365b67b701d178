"""From the ONNX bytes of a decoder to its layers, or to where the file leaves the format.

The one reader of decoders: the validator, the runtime and the renderers on other devices all run
what it returns. Fields and rules: spec/RNA.md, 6.2.
"""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.decoder.decoder_form import INPUT_NAME
from rna_sdk.package.decoder.onnx_fields import DataType
from rna_sdk.package.decoder.onnx_model import Model, Node, OutsideFormat, Tensor, read_model
from rna_sdk.package.decoder.profile_decoder import ProfileDecoder, ProfileLayer
from rna_sdk.package.decoder.protobuf import WireError
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import MAX_DECODER_NODES, MAX_DECODER_WIDTH

_FLOAT32, _UINT8 = DataType.FLOAT, DataType.UINT8
_INT8, _INT32 = DataType.INT8, DataType.INT32

Numbers = NDArray[Any]


def decoder_from_bytes(data: bytes | memoryview, name: str) -> ProfileDecoder:
    """The decoder in an ONNX file; its arrays are views of the bytes.

    name: of the entry, for issues.

    Raises:
        PackageError: DECODER_PROFILE, where the file is not of the format.

    Examples:
        >>> with Package.open("toy.rna") as package:
        ...     decoder = decoder_from_bytes(package.decoder("small"), "small")
        ...     [layer.weight.shape[1] for layer in decoder.layers]
        [64, 64, 64, 64, 24]
    """
    try:
        return _Chain(read_model(memoryview(data))).read()
    except WireError as error:
        refuse(Code.DECODER_PROFILE, name, error, "an ONNX model")
    except OutsideFormat as outside:
        where = f"{name}#{outside.where}"
        refuse(Code.DECODER_PROFILE, where, outside.found, outside.expected)


@dataclass(frozen=True)
class _Operand:
    """A constant operand: its type, its shape, () for a scalar, and its number, if it is fixed."""

    dtype: int
    shape: tuple[int, ...] = ()
    number: int | None = None

    def __str__(self) -> str:
        number = "" if self.number is None else f" that is {self.number}"
        return f"a constant of type {self.dtype} {list(self.shape)}{number}, in raw_data"

    def fits(self, tensor: Tensor) -> bool:
        """Whether the tensor is such a constant."""
        if (tensor.dtype, tensor.dims) != (self.dtype, self.shape) or not tensor.is_whole:
            return False
        return self.number is None or bool(tensor.values() == self.number)


_SCALAR, _ZERO, _ONE = _Operand(_FLOAT32), _Operand(_FLOAT32, (), 0), _Operand(_FLOAT32, (), 1)
_ZERO_POINT = _Operand(_UINT8, (), 0)


class _Chain:
    """Follows the one chain of nodes from the queries to the output."""

    def __init__(self, model: Model) -> None:
        self._nodes = model.nodes
        if len(model.nodes) > MAX_DECODER_NODES:
            found, expected = f"{len(model.nodes)} nodes", f"at most {MAX_DECODER_NODES}"
            raise OutsideFormat("/graph/node", found, expected)
        self._constants = {tensor.name: tensor for tensor in model.initializers}
        self._unread = set(self._constants)
        self._readers = Counter(name for node in model.nodes for name in node.inputs)
        self._dequantizers: dict[str, Node] = {}
        self._at = 0
        self._value = INPUT_NAME
        self._width, self._outputs = model.input.columns, model.output.columns
        self._output = model.output.name
        if model.input.name != INPUT_NAME:
            raise OutsideFormat("/graph/input", repr(model.input.name), repr(INPUT_NAME))
        made = [INPUT_NAME, *(node.output for node in model.nodes)]
        made += [tensor.name for tensor in model.initializers]
        if twice := sorted(name for name, count in Counter(made).items() if count > 1 or not name):
            raise OutsideFormat(
                f"/graph/{twice[0]}", f"{twice[0]!r} made twice", "names of one value"
            )

    def read(self) -> ProfileDecoder:
        """The decoder. Raises OutsideFormat where the model leaves the format."""
        low, high = self._take("Clip", _SCALAR, _SCALAR)
        gain = offset = matrix = None
        unit: Numbers | float = 1.0
        if is_int8 := self._peek() == "Mul":
            (gain,) = self._take("Mul", _Operand(_FLOAT32, (self._width,)))
            (offset,) = self._take("Add", _Operand(_FLOAT32, (self._width,)))
        layers = tuple(self._int8_layers() if is_int8 else self._float_layers())
        _, top = self._take("Clip", _ZERO, _SCALAR)
        self._take("Exp")
        self._take("Sub", _ONE)
        if self._peek() == "MatMul":
            (matrix,) = self._take("MatMul", _Operand(_FLOAT32, (self._width, self._outputs)))
        elif self._width == self._outputs:
            (unit,) = self._take("Mul", _SCALAR)
        else:
            raise self._outside(f"{self._width} values", f"{self._outputs}, or a MatMul to them")
        self._end()
        return ProfileDecoder(
            *(float(low), float(high)),
            gain,
            offset,
            layers,
            *(float(top), float(unit)),
            matrix,
            self._output,
        )

    def _end(self) -> None:
        """Nothing is left over, and the last value is the output."""
        if self._peek() != "nothing":
            raise self._outside(self._peek(), "nothing behind the last node")
        if self._value != self._output or self._readers[self._value]:
            found = f"{self._value!r}, read {self._readers[self._value]} times"
            raise OutsideFormat("/graph/output", found, f"{self._output!r}, read by no node")
        if unread := sorted(self._unread | set(self._dequantizers)):
            raise OutsideFormat(f"/graph/{unread[0]}", "read by no layer", "no other constants")

    def _float_layers(self) -> Iterator[ProfileLayer]:
        last = False
        while not last:
            node = self._next("Gemm")
            outputs = self._columns_of(node.inputs[1:2])
            operands = _Operand(_FLOAT32, (self._width, outputs)), _Operand(_FLOAT32, (outputs,))
            weight, bias = self._values(node, node.inputs[1:], operands)
            self._width = outputs
            last = self._peek() == "Clip"
            if not last:
                self._take("Relu")
            yield ProfileLayer(weight, bias, 0.0, None, not last)

    def _int8_layers(self) -> Iterator[ProfileLayer]:
        last = False
        while not last:
            step, _ = self._take("QuantizeLinear", _SCALAR, _ZERO_POINT)
            again, _ = self._take("DequantizeLinear", _SCALAR, _ZERO_POINT)
            if step.tobytes() != again.tobytes():
                raise self._outside(f"scales {step} and {again}", "one scale")
            node = self._next("Gemm")
            if len(node.inputs) != 3:
                raise self._outside(f"Gemm of {len(node.inputs)} operands", "3", node)
            weights, biases = self._dequantized(node, 1, axis=1), self._dequantized(node, 2, axis=0)
            outputs = self._columns_of(weights)
            scales, shape = _Operand(_FLOAT32, (outputs,)), (self._width, outputs)
            weight, scale = self._values(node, weights, (_Operand(_INT8, shape), scales))
            bias, product = self._values(node, biases, (_Operand(_INT32, (outputs,)), scales))
            if not np.array_equal(product, step * scale):
                raise self._outside(
                    f"{biases[1]!r} as scale of the bias", "the other two's product"
                )
            self._width = outputs
            last = self._peek() == "Clip"
            yield ProfileLayer(weight, bias, float(step), scale, False)

    def _peek(self) -> str:
        """Operator of the next node of the chain; notes dequantised constants before it."""
        while self._at < len(self._nodes):
            node = self._nodes[self._at]
            if node.operator != "DequantizeLinear" or node.inputs[:1] == (self._value,):
                return node.operator
            self._dequantizers[node.output] = node
            self._at += 1
        return "nothing"

    def _outside(self, result: object, expected: object, node: Node | None = None) -> OutsideFormat:
        """About a node that was read, or else the next one."""
        at = self._at if node is None else self._nodes.index(node)
        return OutsideFormat(f"/graph/node/{at}", result, expected)

    def _take(self, operator: str, *operands: _Operand) -> list[Numbers]:
        """Constants of the next node, which is this one, of the value and such constants."""
        node = self._next(operator)
        return self._values(node, node.inputs[1:], operands)

    def _next(self, operator: str) -> Node:
        """The next node, an `operator` without attributes of the value; its result is the next."""
        if self._peek() != operator:
            raise self._outside(self._peek(), operator)
        node = self._nodes[self._at]
        if node.inputs[:1] != (self._value,) or self._readers[self._value] != 1:
            raise self._outside(f"{operator} of {list(node.inputs)}", f"{self._value!r}, once")
        if node.axis is not None:
            raise self._outside(f"{operator} with an attribute", "none")
        self._at += 1
        self._value = node.output
        return node

    def _dequantized(self, node: Node, operand: int, axis: int) -> tuple[str, ...]:
        """Constants of the DequantizeLinear that makes this operand, one scale a channel."""
        name = node.inputs[operand]
        maker = self._dequantizers.pop(name, None)
        if maker is None or maker.axis != axis or self._readers[name] != 1:
            expected = f"a DequantizeLinear of constants along axis {axis}"
            raise self._outside(f"Gemm of {name!r}", expected, node)
        return maker.inputs

    def _columns_of(self, names: Sequence[str]) -> int:
        """Columns of the weight, the first of these constants: a layer's outputs."""
        tensor = self._constants.get(names[0]) if names else None
        outputs = tensor.dims[-1] if tensor and tensor.dims else 0
        if not 0 < outputs <= MAX_DECODER_WIDTH:
            raise self._outside(f"a layer of {outputs} outputs", f"1 to {MAX_DECODER_WIDTH}")
        return outputs

    def _values(
        self, node: Node, names: Sequence[str], operands: Sequence[_Operand]
    ) -> list[Numbers]:
        """The constants of these names, which are such operands."""
        if len(names) != len(operands):
            found = f"{node.operator} of {len(names)} constants"
            raise self._outside(found, len(operands), node)
        arrays = []
        for name, operand in zip(names, operands, strict=True):
            tensor = self._constants.get(name)
            if tensor is None or not operand.fits(tensor):
                shown = f"type {tensor.dtype} {list(tensor.dims)}" if tensor else "no constant"
                raise self._outside(f"{node.operator} of {name!r}, {shown}", operand, node)
            self._unread.discard(name)
            arrays.append(tensor.values())
        return arrays
