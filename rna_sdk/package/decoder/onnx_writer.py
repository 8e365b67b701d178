"""ONNX graphs as protobuf bytes, without the onnx package.

Wire format: https://protobuf.dev/programming-guides/encoding.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.decoder import onnx_fields as fields

Attributes = Mapping[str, int | Sequence[int]]
Operand = str | float | np.generic | NDArray[Any]

_IR_VERSION, _OPSET = 8, 17


class GraphWriter:
    """Nodes and constants in order; values and constants get names by number."""

    def __init__(self) -> None:
        self._nodes: list[bytes] = []
        self._constants: list[bytes] = []

    def node(
        self,
        operator: str,
        *inputs: Operand,
        output: str = "",
        domain: str = "",
        **attributes: int | Sequence[int],
    ) -> str:
        """Add a node; numbers (float32) and arrays among its inputs become constants.

        Returns the name of its result: `output`, or one by number.
        """
        names = [one if isinstance(one, str) else self.constant(one) for one in inputs]
        output = output or f"v{len(self._nodes)}"
        self._nodes.append(_node(operator, names, output, attributes, domain))
        return output

    def constant(self, number: float | np.generic | NDArray[Any]) -> str:
        """Add a constant, float32 if it is a Python number; its name."""
        array = np.float32(number) if isinstance(number, float) else number
        name = f"c{len(self._constants)}"
        self._constants.append(_tensor(name, np.asarray(array)))
        return name

    def model(self, source: bytes, result: bytes, domain: str = "", producer: str = "") -> bytes:
        """The ModelProto from one `value` to another.

        domain: of further operators, version 1.
        """
        graph = [_chunk(fields.GraphProto.NODE, node) for node in self._nodes]
        graph += [_chunk(fields.GraphProto.NAME, b"decoder")]
        graph += [_chunk(fields.GraphProto.INITIALIZER, tensor) for tensor in self._constants]
        graph += [_chunk(fields.GraphProto.INPUT, source), _chunk(fields.GraphProto.OUTPUT, result)]
        parts = [_integer(fields.ModelProto.IR_VERSION, _IR_VERSION)]
        parts += [_chunk(fields.ModelProto.PRODUCER_NAME, producer.encode())] if producer else []
        parts += [_chunk(fields.ModelProto.GRAPH, b"".join(graph))]
        for opset in [("", _OPSET), *([(domain, 1)] if domain else [])]:
            parts.append(_chunk(fields.ModelProto.OPSET_IMPORT, _opset(*opset)))
        return b"".join(parts)


def value(name: str, dims: Sequence[int | str], dtype: str = "float32") -> bytes:
    """A ValueInfoProto of a tensor; a dimension is a size or a symbol."""
    shape = b"".join(_chunk(fields.TensorShapeProto.DIM, _dimension(dim)) for dim in dims)
    element = _integer(fields.TensorTypeProto.ELEM_TYPE, _TYPES[dtype])
    tensor_type = element + _chunk(fields.TensorTypeProto.SHAPE, shape)
    named = _chunk(fields.ValueInfoProto.NAME, name.encode())
    return named + _chunk(
        fields.ValueInfoProto.TYPE, _chunk(fields.TypeProto.TENSOR_TYPE, tensor_type)
    )


def _node(
    operator: str, inputs: Iterable[str], output: str, attributes: Attributes, domain: str
) -> bytes:
    """A NodeProto; attributes are integers or lists of them."""
    parts = [_chunk(fields.NodeProto.INPUT, name.encode()) for name in inputs]
    parts += [_chunk(fields.NodeProto.OUTPUT, output.encode())]
    parts += [_chunk(fields.NodeProto.OP_TYPE, operator.encode())]
    for name, values in attributes.items():
        parts.append(_chunk(fields.NodeProto.ATTRIBUTE, _attribute(name, values)))
    parts += [_chunk(fields.NodeProto.DOMAIN, domain.encode())] if domain else []
    return b"".join(parts)


def _attribute(name: str, values: int | Sequence[int]) -> bytes:
    named = _chunk(fields.AttributeProto.NAME, name.encode())
    if isinstance(values, int):
        kind = _integer(fields.AttributeProto.TYPE, fields.AttributeType.INT)
        return named + _integer(fields.AttributeProto.I, values) + kind
    kind = _integer(fields.AttributeProto.TYPE, fields.AttributeType.INTS)
    return named + b"".join(_integer(fields.AttributeProto.INTS, value) for value in values) + kind


def _tensor(name: str, values: NDArray[Any]) -> bytes:
    """A TensorProto that holds `values`, of a dtype in _TYPES."""
    dims = b"".join(_integer(fields.TensorProto.DIMS, size) for size in values.shape)
    little_endian = values.astype(values.dtype.newbyteorder("<")).tobytes()
    data_type = _integer(fields.TensorProto.DATA_TYPE, _TYPES[values.dtype.name])
    named = _chunk(fields.TensorProto.NAME, name.encode())
    return dims + data_type + named + _chunk(fields.TensorProto.RAW_DATA, little_endian)


_TYPES = {
    "float32": fields.DataType.FLOAT,
    "uint8": fields.DataType.UINT8,
    "int8": fields.DataType.INT8,
    "int32": fields.DataType.INT32,
    "int64": fields.DataType.INT64,
}


def _dimension(dim: int | str) -> bytes:
    if isinstance(dim, int):
        return _integer(fields.DimensionProto.DIM_VALUE, dim)
    return _chunk(fields.DimensionProto.DIM_PARAM, dim.encode())


def _opset(domain: str, version: int) -> bytes:
    named = _chunk(fields.OperatorSetIdProto.DOMAIN, domain.encode())
    return named + _integer(fields.OperatorSetIdProto.VERSION, version)


def _chunk(number: int, data: bytes) -> bytes:
    """A field of bytes: a string or a message inside a message."""
    return _varint(number << 3 | 2) + _varint(len(data)) + bytes(data)


def _integer(number: int, value: int) -> bytes:
    """A varint field."""
    return _varint(number << 3) + _varint(value)


def _varint(value: int) -> bytes:
    result = bytearray()
    while value > 0x7F:
        result.append(value & 0x7F | 0x80)
        value >>= 7
    result.append(value)
    return bytes(result)
