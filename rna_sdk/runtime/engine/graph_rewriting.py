"""A decoder's graph with other nodes in the place of some of its own."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from numpy.typing import NDArray

from rna_sdk.package.decoder.onnx_model import Model
from rna_sdk.runtime.engine import onnx_bytes as pb


class GraphRewriting:
    """Nodes and constants of `model`, to be changed and then written.

    Types of values between nodes are left out: they may name shapes that have changed.
    """

    def __init__(self, model: Model) -> None:
        self._model = model
        self._nodes: list[list[bytes | memoryview]] = [[node.data] for node in model.nodes]
        self._tensors: list[bytes | memoryview] = [tensor.data for tensor in model.initializers]

    def remove(self, places: Iterable[int]) -> None:
        """Take out the nodes of these places in the model."""
        for place in places:
            self._nodes[place].clear()

    def add(
        self,
        place: int,
        operator: str,
        inputs: Iterable[str],
        output: str,
        attributes: pb.Attributes | None = None,
        domain: str = "",
    ) -> None:
        """Insert a node after a position in the model's nodes."""
        self._nodes[place].append(pb.node(operator, inputs, output, attributes, domain))

    def constant(self, name: str, values: NDArray[Any]) -> str:
        """Add a constant; its name."""
        self._tensors.append(pb.tensor(name, values))
        return name

    def to_bytes(
        self,
        queries: tuple[str, Sequence[int | str], str] | None = None,
        opsets: Sequence[tuple[str, int]] = (),
    ) -> bytes:
        """The model as ONNX bytes.

        queries: name, dimensions and type of the input, where it is not the model's. opsets: beside
        the model's.
        """
        inputs = [v.data for v in self._model.inputs] if queries is None else [pb.value(*queries)]
        return pb.model(
            [node for group in self._nodes for node in group],
            self._tensors,
            inputs,
            [value.data for value in self._model.outputs],
            [*self._model.opsets, *opsets],
            self._model.ir_version,
        )
