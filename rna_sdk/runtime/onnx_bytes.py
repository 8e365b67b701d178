"""ONNX messages as protobuf bytes, for graphs that the runtime makes itself.

Field numbers: onnx.proto of ONNX 1.16. Wire format:
https://protobuf.dev/programming-guides/encoding.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

_FLOAT, _INT64 = 1, 7  # TensorProto.DataType
_INTS = 7  # AttributeProto.AttributeType

Attributes = Mapping[str, Sequence[int]]


def node(
    operator: str, inputs: Iterable[str], output: str, attributes: Attributes | None = None
) -> bytes:
    """A NodeProto of the default domain with one output; attributes are lists of integers."""
    fields = [chunk(1, name.encode()) for name in inputs]
    fields += [chunk(2, output.encode()), chunk(4, operator.encode())]
    for name, values in (attributes or {}).items():
        integers = b"".join(integer(8, value) for value in values)
        fields.append(chunk(5, chunk(1, name.encode()) + integers + integer(20, _INTS)))
    return b"".join(fields)


def tensor(name: str, values: NDArray[np.float32] | NDArray[np.int64]) -> bytes:
    """A TensorProto that holds `values`, float32 or int64."""
    data_type = _FLOAT if values.dtype == np.float32 else _INT64
    dims = b"".join(integer(1, size) for size in values.shape)
    little_endian = values.astype(values.dtype.newbyteorder("<")).tobytes()
    return dims + integer(2, data_type) + chunk(8, name.encode()) + chunk(9, little_endian)


def value(name: str, dims: Sequence[int | str]) -> bytes:
    """A ValueInfoProto of a float32 tensor; a dimension is a size or a symbol."""
    shape = b"".join(
        chunk(1, integer(1, dim) if isinstance(dim, int) else chunk(2, dim.encode()))
        for dim in dims
    )
    tensor_type = integer(1, _FLOAT) + chunk(2, shape)
    return chunk(1, name.encode()) + chunk(2, chunk(1, tensor_type))


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
