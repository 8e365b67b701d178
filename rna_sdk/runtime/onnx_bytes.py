"""ONNX messages as protobuf bytes, for graphs that the runtime makes itself.

Field numbers: onnx.proto of ONNX 1.16. Wire format:
https://protobuf.dev/programming-guides/encoding.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from numpy.typing import NDArray

from rna_sdk.package.protobuf import Message

_TYPES = {"float32": 1, "uint8": 2, "int8": 3, "int32": 6, "int64": 7}  # TensorProto.DataType
_INT, _INTS = 2, 7  # AttributeProto.AttributeType

Attributes = Mapping[str, int | Sequence[int]]


def node(
    operator: str,
    inputs: Iterable[str],
    output: str,
    attributes: Attributes | None = None,
    domain: str = "",
) -> bytes:
    """A NodeProto with one output; attributes are integers or lists of them."""
    fields = [chunk(1, name.encode()) for name in inputs]
    fields += [chunk(2, output.encode()), chunk(4, operator.encode())]
    for name, values in (attributes or {}).items():
        if isinstance(values, int):
            numbers = integer(3, values) + integer(20, _INT)
        else:
            numbers = b"".join(integer(8, value) for value in values) + integer(20, _INTS)
        fields.append(chunk(5, chunk(1, name.encode()) + numbers))
    return b"".join([*fields, chunk(7, domain.encode())] if domain else fields)


def tensor(name: str, values: NDArray[Any]) -> bytes:
    """A TensorProto that holds `values`, of a dtype in _TYPES."""
    dims = b"".join(integer(1, size) for size in values.shape)
    little_endian = values.astype(values.dtype.newbyteorder("<")).tobytes()
    data_type = integer(2, _TYPES[values.dtype.name])
    return dims + data_type + chunk(8, name.encode()) + chunk(9, little_endian)


def opset(domain: str, version: int) -> bytes:
    """An OperatorSetIdProto."""
    return chunk(1, domain.encode()) + integer(2, version)


def value(name: str, dims: Sequence[int | str], dtype: str = "float32") -> bytes:
    """A ValueInfoProto of a tensor; a dimension is a size or a symbol."""
    shape = b"".join(
        chunk(1, integer(1, dim) if isinstance(dim, int) else chunk(2, dim.encode()))
        for dim in dims
    )
    tensor_type = integer(1, _TYPES[dtype]) + chunk(2, shape)
    return chunk(1, name.encode()) + chunk(2, chunk(1, tensor_type))


def chunks(message: Message, number: int) -> list[bytes]:
    """The values of a repeated field of bytes."""
    return [bytes(v) for v in message.fields.get(number, []) if not isinstance(v, int)]


def chunk(number: int, data: bytes | memoryview) -> bytes:
    """A field of bytes: a string or a message inside a message."""
    return _varint(number << 3 | 2) + _varint(len(data)) + bytes(data)


def integer(number: int, value: int) -> bytes:
    """A varint field."""
    return _varint(number << 3) + _varint(value)


def _varint(value: int) -> bytes:
    result = bytearray()
    while value > 0x7F:
        result.append(value & 0x7F | 0x80)
        value >>= 7
    result.append(value)
    return bytes(result)
