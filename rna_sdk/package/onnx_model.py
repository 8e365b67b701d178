"""What a checker needs to know of an ONNX model, read without the onnx package.

Field numbers: onnx.proto of ONNX 1.16 (IR version 10).
"""

from __future__ import annotations

from dataclasses import dataclass

from rna_sdk.package.protobuf import Message

FLOAT = 1


@dataclass(frozen=True)
class Tensor:
    """An initializer or a tensor in an attribute. `raw`: its data, where it is `raw_data`."""

    name: str
    dtype: int
    dims: tuple[int, ...]
    external: bool
    raw: memoryview | None


@dataclass(frozen=True)
class Node:
    """One operator call. `tensors` are those in its attributes; `integers`, those that are one."""

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


def read_model(data: memoryview) -> Model:
    """The model in serialized ModelProto bytes.

    Raises:
        WireError: the bytes are no such message, or say one thing twice.
    """
    model = Message(data)
    graph = model.message(7)
    return Model(
        ir_version=model.integer(1),
        opsets=tuple((opset.text(1), opset.integer(2)) for opset in model.messages(8)),
        nodes=tuple(_node(node) for node in graph.messages(1)),
        initializers=tuple(_tensor(tensor) for tensor in graph.messages(5)),
        inputs=tuple(_value(value) for value in graph.messages(11)),
        outputs=tuple(_value(value) for value in graph.messages(12)),
        nested=model.has(20) or model.has(25) or graph.has(15),
    )


def _tensor(tensor: Message) -> Tensor:
    dims = tuple(tensor.integers(1))
    external = tensor.has(13) or any(tensor.integers(14))
    raw = tensor.one(9)
    data = raw if isinstance(raw, memoryview) else None
    return Tensor(tensor.text(8), tensor.integer(2), dims, external, data)


def _node(node: Message) -> Node:
    attributes = node.messages(5)
    graphs_and_sparse = (6, 11, 14, 15, 21, 22, 23)
    return Node(
        operator=node.text(4),
        domain=node.text(7),
        inputs=tuple(node.texts(1)),
        outputs=tuple(node.texts(2)),
        tensors=tuple(_tensor(t) for a in attributes for n in (5, 10) for t in a.messages(n)),
        attributes=tuple(attribute.text(1) for attribute in attributes),
        integers={a.text(1): a.integer(3) for a in attributes if a.has(3)},
        longest_list=max((_longest_list(attribute) for attribute in attributes), default=0),
        nested=any(attribute.has(n) for attribute in attributes for n in graphs_and_sparse),
    )


def _longest_list(attribute: Message) -> int:
    """Upper bound of the number of elements of a list attribute (floats, ints, strings)."""
    floats = sum(len(v) // 4 for v in attribute.fields.get(7, []) if isinstance(v, memoryview))
    return max(floats, len(attribute.integers(8)), len(attribute.fields.get(9, [])))


def _value(value: Message) -> Value:
    tensor = value.message(2).message(1)
    dims = tensor.message(2).messages(1)
    return Value(
        name=value.text(1),
        dtype=tensor.integer(1),
        dims=tuple(map(_size, dims)),
    )


def _size(dim: Message) -> int | None:
    """None for one that is free; its name, which engines read, is UTF-8 or refused."""
    dim.text(2)
    return dim.integer(1) if dim.has(1) else None
