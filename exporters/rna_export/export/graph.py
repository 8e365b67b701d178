"""An ONNX graph under construction, for decoders."""

from __future__ import annotations

from typing import Any

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

OPSET = 17


class Graph:
    """Nodes and constants in order; values and constants get names by number."""

    def __init__(self) -> None:
        self._nodes: list[onnx.NodeProto] = []
        self._constants: list[onnx.TensorProto] = []

    def constant(self, value: np.ndarray | np.generic | float) -> str:
        """A constant of the array's dtype; float32 for a Python number."""
        name = f"c{len(self._constants)}"
        array = np.asarray(value, np.float32 if isinstance(value, float) else None)
        self._constants.append(numpy_helper.from_array(array, name))
        return name

    def add(
        self, operator: str, inputs: list[str], output: str | None = None, **attributes: Any
    ) -> str:
        """A node; the name of its result."""
        output = output or f"v{len(self._nodes)}"
        self._nodes.append(helper.make_node(operator, inputs, [output], **attributes))
        return output

    def clip(self, value: str, low: float, high: float) -> str:
        return self.add("Clip", [value, self.constant(low), self.constant(high)])

    def serialize(self, columns: int, output: str, width: int) -> bytes:
        """The model from `queries` (N, columns) to the output (N, width)."""
        graph = helper.make_graph(
            self._nodes,
            "decoder",
            [helper.make_tensor_value_info("queries", TensorProto.FLOAT, ["N", columns])],
            [helper.make_tensor_value_info(output, TensorProto.FLOAT, ["N", width])],
            self._constants,
        )
        opsets = [helper.make_opsetid("", OPSET)]
        model = helper.make_model(
            graph, opset_imports=opsets, ir_version=8, producer_name="rna-export"
        )
        onnx.checker.check_model(model)
        data: bytes = model.SerializeToString(deterministic=True)
        return data
