"""An ONNX model as its checkers and the runtime see it, read without the onnx package."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.decoder import onnx_fields as fields
from rna_sdk.package.decoder.protobuf import Message

FLOAT = fields.DataType.FLOAT

DTYPES: dict[int, np.dtype[Any]] = {
    fields.DataType.FLOAT: np.dtype("<f4"),
    fields.DataType.UINT8: np.dtype("u1"),
    fields.DataType.INT8: np.dtype("i1"),
    fields.DataType.INT32: np.dtype("<i4"),
}
"""TensorProto.DataType -> that of arrays, for the types that layers are made of."""

_GRAPHS_AND_SPARSE = (
    fields.AttributeProto.G,
    fields.AttributeProto.GRAPHS,
    fields.AttributeProto.TP,
    fields.AttributeProto.TYPE_PROTOS,
    fields.AttributeProto.REF_ATTR_NAME,
    fields.AttributeProto.SPARSE_TENSOR,
    fields.AttributeProto.SPARSE_TENSORS,
)


@dataclass(frozen=True)
class Tensor:
    """An initializer or a tensor in an attribute.

    raw: its data, where it is `raw_data`.
    """

    name: str
    dtype: int
    dims: tuple[int, ...]
    external: bool
    raw: memoryview | None

    @property
    def is_whole(self) -> bool:
        """Whether the data is raw, and as long as type and shape want it."""
        if self.raw is None or self.dtype not in DTYPES:
            return False
        return len(self.raw) == math.prod(self.dims) * DTYPES[self.dtype].itemsize

    def values(self) -> NDArray[Any]:
        """Those of a tensor that is whole."""
        assert self.raw is not None
        return np.frombuffer(self.raw, DTYPES[self.dtype]).reshape(self.dims)


@dataclass(frozen=True)
class Node:
    """One operator call.

    tensors: those in its attributes. integers: attributes that are one, by name.
    """

    operator: str
    domain: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    tensors: tuple[Tensor, ...]
    attributes: tuple[str, ...]
    integers: dict[str, int]
    longest_list: int
    nested: bool


@dataclass(frozen=True)
class Value:
    """A graph input or output. `dtype` 0: no tensor; a dim of None: symbolic or unknown."""

    name: str
    dtype: int
    dims: tuple[int | None, ...]


@dataclass(frozen=True)
class Model:
    """A model. `nested`: functions, training info or sparse tensors are there."""

    ir_version: int
    opsets: tuple[tuple[str, int], ...]
    nodes: tuple[Node, ...]
    initializers: tuple[Tensor, ...]
    inputs: tuple[Value, ...]
    outputs: tuple[Value, ...]
    nested: bool

    @cached_property
    def constants(self) -> dict[str, Tensor]:
        """The initializers by name."""
        return {tensor.name: tensor for tensor in self.initializers}

    @cached_property
    def readers(self) -> Counter[str]:
        """Number of readers of each value: nodes, and 1 for an output of the graph."""
        read = Counter(name for node in self.nodes for name in node.inputs)
        read.update(value.name for value in self.outputs)
        return read


def read_model(data: memoryview) -> Model:
    """The model in serialized ModelProto bytes.

    Raises:
        WireError: the bytes are no such message, or say one thing twice.
    """
    model = Message(data)
    graph = model.message(fields.ModelProto.GRAPH)
    outside = model.has(fields.ModelProto.TRAINING_INFO) or model.has(fields.ModelProto.FUNCTIONS)
    opsets = model.messages(fields.ModelProto.OPSET_IMPORT)
    return Model(
        ir_version=model.integer(fields.ModelProto.IR_VERSION),
        opsets=tuple(
            (
                opset.text(fields.OperatorSetIdProto.DOMAIN),
                opset.integer(fields.OperatorSetIdProto.VERSION),
            )
            for opset in opsets
        ),
        nodes=tuple(_node(node) for node in graph.messages(fields.GraphProto.NODE)),
        initializers=tuple(
            _tensor(tensor) for tensor in graph.messages(fields.GraphProto.INITIALIZER)
        ),
        inputs=tuple(_value(value) for value in graph.messages(fields.GraphProto.INPUT)),
        outputs=tuple(_value(value) for value in graph.messages(fields.GraphProto.OUTPUT)),
        nested=outside or graph.has(fields.GraphProto.SPARSE_INITIALIZER),
    )


def _tensor(tensor: Message) -> Tensor:
    external = tensor.has(fields.TensorProto.EXTERNAL_DATA)
    raw = tensor.one(fields.TensorProto.RAW_DATA)
    return Tensor(
        name=tensor.text(fields.TensorProto.NAME),
        dtype=tensor.integer(fields.TensorProto.DATA_TYPE),
        dims=tuple(tensor.integers(fields.TensorProto.DIMS)),
        external=external or any(tensor.integers(fields.TensorProto.DATA_LOCATION)),
        raw=raw if isinstance(raw, memoryview) else None,
    )


def _node(node: Message) -> Node:
    attributes = node.messages(fields.NodeProto.ATTRIBUTE)
    named = [(attribute.text(fields.AttributeProto.NAME), attribute) for attribute in attributes]
    tensor_fields = fields.AttributeProto.T, fields.AttributeProto.TENSORS
    return Node(
        operator=node.text(fields.NodeProto.OP_TYPE),
        domain=node.text(fields.NodeProto.DOMAIN),
        inputs=tuple(node.texts(fields.NodeProto.INPUT)),
        outputs=tuple(node.texts(fields.NodeProto.OUTPUT)),
        tensors=tuple(_tensor(t) for a in attributes for n in tensor_fields for t in a.messages(n)),
        attributes=tuple(name for name, _ in named),
        integers={
            name: a.integer(fields.AttributeProto.I)
            for name, a in named
            if a.has(fields.AttributeProto.I)
        },
        longest_list=max((_longest_list(attribute) for attribute in attributes), default=0),
        nested=any(attribute.has(n) for attribute in attributes for n in _GRAPHS_AND_SPARSE),
    )


def _longest_list(attribute: Message) -> int:
    """Upper bound of the number of elements of a list attribute (floats, ints, strings)."""
    packed = attribute.fields.get(fields.AttributeProto.FLOATS, [])
    floats = sum(len(v) // 4 for v in packed if isinstance(v, memoryview))
    integers = len(attribute.integers(fields.AttributeProto.INTS))
    return max(floats, integers, len(attribute.fields.get(fields.AttributeProto.STRINGS, [])))


def _value(value: Message) -> Value:
    tensor = value.message(fields.ValueInfoProto.TYPE).message(fields.TypeProto.TENSOR_TYPE)
    dims = tensor.message(fields.TensorTypeProto.SHAPE).messages(fields.TensorShapeProto.DIM)
    return Value(
        name=value.text(fields.ValueInfoProto.NAME),
        dtype=tensor.integer(fields.TensorTypeProto.ELEM_TYPE),
        dims=tuple(map(_size, dims)),
    )


def _size(dim: Message) -> int | None:
    """None for one that is free; its name, which engines read, is UTF-8 or refused."""
    dim.text(fields.DimensionProto.DIM_PARAM)
    return (
        dim.integer(fields.DimensionProto.DIM_VALUE)
        if dim.has(fields.DimensionProto.DIM_VALUE)
        else None
    )
