"""The members of ONNX messages that a decoder has, read without the onnx package (spec, 6.2)."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.decoder import onnx_fields as fields
from rna_sdk.package.decoder.protobuf import Message
from rna_sdk.package.limits import IR_VERSIONS, OPSET_VERSIONS

DTYPES: dict[int, np.dtype[Any]] = {
    fields.DataType.FLOAT: np.dtype("<f4"),
    fields.DataType.UINT8: np.dtype("u1"),
    fields.DataType.INT8: np.dtype("i1"),
    fields.DataType.INT32: np.dtype("<i4"),
}
"""TensorProto.DataType -> dtype of arrays, for the types of layers."""

_DEFAULT_DOMAINS = ("", "ai.onnx")
_OF_MODEL = fields.ModelProto.TRAINING_INFO, fields.ModelProto.FUNCTIONS
_OTHER_DATA = *fields.TensorProto.OTHER_DATA, fields.TensorProto.EXTERNAL_DATA


class OutsideFormat(Exception):
    """The model is not a decoder of the format.

    Attributes:
        where: JSON pointer into the model, or to the name of a value.
        found, expected: what is there, and what the format wants.
    """

    def __init__(self, where: str, found: object, expected: object) -> None:
        super().__init__(f"{where}: found {found}, expected {expected}")
        self.where, self.found, self.expected = where, found, expected


@dataclass(frozen=True)
class Tensor:
    """An initializer; raw: its data."""

    name: str
    dtype: int
    dims: tuple[int, ...]
    raw: memoryview

    @property
    def is_whole(self) -> bool:
        """Whether the type is one of layers, and the data as long as type and shape want it."""
        known = self.dtype in DTYPES
        return known and len(self.raw) == math.prod(self.dims) * DTYPES[self.dtype].itemsize

    def values(self) -> NDArray[Any]:
        """Values of a complete tensor."""
        return np.frombuffer(self.raw, DTYPES[self.dtype]).reshape(self.dims)


@dataclass(frozen=True)
class Node:
    """One operator call; axis: its one attribute, if it has one."""

    operator: str
    inputs: tuple[str, ...]
    output: str
    axis: int | None


@dataclass(frozen=True)
class Side:
    """The graph's input or output, float32 [N, columns], N symbolic."""

    name: str
    columns: int


@dataclass(frozen=True)
class Model:
    """The graph of a model."""

    nodes: tuple[Node, ...]
    initializers: tuple[Tensor, ...]
    input: Side
    output: Side


def read_model(data: memoryview) -> Model:
    """The model in serialized ModelProto bytes.

    Raises:
        WireError: the bytes are no such message, or say one thing twice.
        OutsideFormat: a member is none that a decoder has.
    """
    model = Message(data)
    graph = model.message(fields.ModelProto.GRAPH)
    _check_versions(model)
    if any(map(model.has, _OF_MODEL)) or graph.has(fields.GraphProto.SPARSE_INITIALIZER):
        raise OutsideFormat("", "functions, training information or sparse tensors", "none")
    return Model(
        nodes=tuple(_node(k, one) for k, one in enumerate(graph.messages(fields.GraphProto.NODE))),
        initializers=tuple(map(_tensor, graph.messages(fields.GraphProto.INITIALIZER))),
        input=_side(graph.message(fields.GraphProto.INPUT), "/graph/input"),
        output=_side(graph.message(fields.GraphProto.OUTPUT), "/graph/output"),
    )


def _check_versions(model: Message) -> None:
    opset = model.message(fields.ModelProto.OPSET_IMPORT)
    _check_domain(opset.text(fields.OperatorSetIdProto.DOMAIN), "/opset_import/0")
    for where, version, versions in (
        ("/ir_version", model.integer(fields.ModelProto.IR_VERSION), IR_VERSIONS),
        ("/opset_import/0", opset.integer(fields.OperatorSetIdProto.VERSION), OPSET_VERSIONS),
    ):
        if version not in versions:
            raise OutsideFormat(where, version, f"{versions.start} to {versions.stop - 1}")


def _check_domain(domain: str, where: str) -> None:
    if domain not in _DEFAULT_DOMAINS:
        raise OutsideFormat(f"{where}/domain", repr(domain), "the default domain")


def _tensor(tensor: Message) -> Tensor:
    name = tensor.text(fields.TensorProto.NAME)
    raw = tensor.one(fields.TensorProto.RAW_DATA)
    elsewhere = any(map(tensor.has, _OTHER_DATA)) or tensor.integer(
        fields.TensorProto.DATA_LOCATION
    )
    if elsewhere or not isinstance(raw, memoryview):
        raise OutsideFormat(f"/graph/{name}", "a constant without raw_data, or more", "raw_data")
    return Tensor(
        name=name,
        dtype=tensor.integer(fields.TensorProto.DATA_TYPE),
        dims=tuple(tensor.integers(fields.TensorProto.DIMS)),
        raw=raw,
    )


def _node(number: int, node: Message) -> Node:
    where = f"/graph/node/{number}"
    _check_domain(node.text(fields.NodeProto.DOMAIN), where)
    axis = None
    if node.has(fields.NodeProto.ATTRIBUTE):
        attribute = node.message(fields.NodeProto.ATTRIBUTE)
        name = attribute.text(fields.AttributeProto.NAME)
        if name != "axis" or not attribute.has(fields.AttributeProto.I):
            raise OutsideFormat(f"{where}/attribute/0", repr(name), "an integer, axis")
        axis = attribute.integer(fields.AttributeProto.I)
    return Node(
        operator=node.text(fields.NodeProto.OP_TYPE),
        inputs=tuple(node.texts(fields.NodeProto.INPUT)),
        output=node.text(fields.NodeProto.OUTPUT),
        axis=axis,
    )


def _side(value: Message, where: str) -> Side:
    name = value.text(fields.ValueInfoProto.NAME)
    tensor = value.message(fields.ValueInfoProto.TYPE).message(fields.TypeProto.TENSOR_TYPE)
    dtype = tensor.integer(fields.TensorTypeProto.ELEM_TYPE)
    shape = []
    for dim in tensor.message(fields.TensorTypeProto.SHAPE).messages(fields.TensorShapeProto.DIM):
        symbol = dim.text(fields.DimensionProto.DIM_PARAM)
        sized = dim.has(fields.DimensionProto.DIM_VALUE)
        shape.append(dim.integer(fields.DimensionProto.DIM_VALUE) if sized else symbol or "N")
    match shape:
        case [str(), int(columns)] if columns > 0 and dtype == fields.DataType.FLOAT:
            return Side(name, columns)
    found = f"{name!r} type {dtype} {shape}"
    raise OutsideFormat(where, found, "one of float32 [N, columns], N symbolic")
