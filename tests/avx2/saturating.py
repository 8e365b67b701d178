"""What onnxruntime does with int8 on the CPU at hand."""

from __future__ import annotations

import numpy as np
import onnxruntime

from rna_sdk.runtime.engine import onnx_bytes as pb


def sums_in_16_bits() -> bool:
    """Whether onnxruntime adds uint8 x int8 in pairs of 16 bits here: 2 x 255 x 127 saturates."""
    constants: dict[str, object] = {"one": np.float32(1), "zero": np.uint8(0), "zero8": np.int8(0)}
    constants["weight"] = np.array([[127], [127], [-127], [-127]], np.int8)
    operands = ["q", "one", "zero", "weight", "one", "zero8", "one", "zero"]
    nodes = [pb.node("QLinearMatMul", operands, "y")]
    tensors = [pb.tensor(name, np.asarray(value)) for name, value in constants.items()]
    ends = [pb.value("q", ["N", 4], "uint8")], [pb.value("y", ["N", 1], "uint8")]
    model = pb.model(nodes, tensors, *ends, [("", 17)], ir_version=8, name="pairs")
    session = onnxruntime.InferenceSession(model, providers=["CPUExecutionProvider"])
    q = np.array([[255, 255, 254, 255]] * 8, np.uint8)
    return not bool((session.run(None, {"q": q})[0] == 127).all())
