"""What onnxruntime does with int8 on the CPU at hand."""

import numpy as np
import onnxruntime

from rna_sdk.package.decoder.onnx_writer import GraphWriter, value


def sums_in_16_bits() -> bool:
    """Whether onnxruntime adds uint8 x int8 in pairs of 16 bits here: 2 x 255 x 127 saturates."""
    weight = np.array([[127], [127], [-127], [-127]], np.int8)
    graph, one = GraphWriter(), np.float32(1)
    of_q, of_weight, of_y = (one, np.uint8(0)), (one, np.int8(0)), (one, np.uint8(0))
    graph.node("QLinearMatMul", "q", *of_q, weight, *of_weight, *of_y, output="y")
    model = graph.model(value("q", ["N", 4], "uint8"), value("y", ["N", 1], "uint8"))
    session = onnxruntime.InferenceSession(model, providers=["CPUExecutionProvider"])
    q = np.array([[255, 255, 254, 255]] * 8, np.uint8)
    return not bool((session.run(None, {"q": q})[0] == 127).all())
