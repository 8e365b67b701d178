"""ONNX messages as protobuf bytes, for graphs that the runtime makes itself.

Wire format: https://protobuf.dev/programming-guides/encoding.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from numpy.typing import NDArray

from rna_sdk.package.onnx_fields import (
    AttributeProto,
    AttributeType,
    DataType,
    DimensionProto,
    GraphProto,
    ModelProto,
    NodeProto,
    OperatorSetIdProto,
    TensorProto,
    TensorShapeProto,
    TensorTypeProto,
    TypeProto,
    ValueInfoProto,
)

Attributes = Mapping[str, int | Sequence[int]]


def model(
    nodes: Iterable[bytes | memoryview],
    tensors: Iterable[bytes | memoryview],
    inputs: Iterable[bytes | memoryview],
    outputs: Iterable[bytes | memoryview],
    opsets: Iterable[tuple[str, int]],
    ir_version: int,
    name: str = "decoder",
    producer: str = "",
) -> bytes:
    """A ModelProto of one graph. nodes, tensors, inputs, outputs: what functions below give."""
    graph = [_chunk(GraphProto.NODE, node) for node in nodes]
    graph += [_chunk(GraphProto.NAME, name.encode())]
    graph += [_chunk(GraphProto.INITIALIZER, tensor) for tensor in tensors]
    graph += [_chunk(GraphProto.INPUT, value) for value in inputs]
    graph += [_chunk(GraphProto.OUTPUT, value) for value in outputs]
    fields = [_integer(ModelProto.IR_VERSION, ir_version)]
    fields += [_chunk(ModelProto.PRODUCER_NAME, producer.encode())] if producer else []
    fields += [_chunk(ModelProto.GRAPH, b"".join(graph))]
    fields += [_chunk(ModelProto.OPSET_IMPORT, _opset(*opset)) for opset in opsets]
    return b"".join(fields)


def node(
    operator: str,
    inputs: Iterable[str],
    output: str,
    attributes: Attributes | None = None,
    domain: str = "",
) -> bytes:
    """A NodeProto with one output; attributes are integers or lists of them."""
    fields = [_chunk(NodeProto.INPUT, name.encode()) for name in inputs]
    fields += [_chunk(NodeProto.OUTPUT, output.encode())]
    fields += [_chunk(NodeProto.OP_TYPE, operator.encode())]
    for name, values in (attributes or {}).items():
        fields.append(_chunk(NodeProto.ATTRIBUTE, _attribute(name, values)))
    fields += [_chunk(NodeProto.DOMAIN, domain.encode())] if domain else []
    return b"".join(fields)


def _attribute(name: str, values: int | Sequence[int]) -> bytes:
    named = _chunk(AttributeProto.NAME, name.encode())
    if isinstance(values, int):
        kind = _integer(AttributeProto.TYPE, AttributeType.INT)
        return named + _integer(AttributeProto.I, values) + kind
    kind = _integer(AttributeProto.TYPE, AttributeType.INTS)
    return named + b"".join(_integer(AttributeProto.INTS, value) for value in values) + kind


def tensor(name: str, values: NDArray[Any]) -> bytes:
    """A TensorProto that holds `values`, of a dtype in _TYPES."""
    dims = b"".join(_integer(TensorProto.DIMS, size) for size in values.shape)
    little_endian = values.astype(values.dtype.newbyteorder("<")).tobytes()
    data_type = _integer(TensorProto.DATA_TYPE, _TYPES[values.dtype.name])
    named = _chunk(TensorProto.NAME, name.encode())
    return dims + data_type + named + _chunk(TensorProto.RAW_DATA, little_endian)


def value(name: str, dims: Sequence[int | str], dtype: str = "float32") -> bytes:
    """A ValueInfoProto of a tensor; a dimension is a size or a symbol."""
    shape = b"".join(_chunk(TensorShapeProto.DIM, _dimension(dim)) for dim in dims)
    element = _integer(TensorTypeProto.ELEM_TYPE, _TYPES[dtype])
    tensor_type = element + _chunk(TensorTypeProto.SHAPE, shape)
    named = _chunk(ValueInfoProto.NAME, name.encode())
    return named + _chunk(ValueInfoProto.TYPE, _chunk(TypeProto.TENSOR_TYPE, tensor_type))


_TYPES = {
    "float32": DataType.FLOAT,
    "uint8": DataType.UINT8,
    "int8": DataType.INT8,
    "int32": DataType.INT32,
    "int64": DataType.INT64,
}


def _dimension(dim: int | str) -> bytes:
    if isinstance(dim, int):
        return _integer(DimensionProto.DIM_VALUE, dim)
    return _chunk(DimensionProto.DIM_PARAM, dim.encode())


def _opset(domain: str, version: int) -> bytes:
    named = _chunk(OperatorSetIdProto.DOMAIN, domain.encode())
    return named + _integer(OperatorSetIdProto.VERSION, version)


def _chunk(number: int, data: bytes | memoryview) -> bytes:
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
