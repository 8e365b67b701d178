"""The decoder as an ONNX graph (RNA-1.0, Decoder), and the check that it is the trained one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import onnx
import onnxruntime
import torch
from onnx import TensorProto, helper, numpy_helper

from rna_export.training.model import NeuralAsset
from rna_sdk.errors import ExportError

OPSET = 17
RELATIVE, ABSOLUTE = 1e-4, 1e-5  # a larger difference refuses the export
LARGEST_INPUT = 65504.0  # keeps sums finite whatever is asked
_RANDOM_QUERIES = 20_000


@dataclass(frozen=True)
class Agreement:
    """Largest differences between ONNX and PyTorch over the checked queries."""

    max_absolute: float
    max_relative: float  # of values above ABSOLUTE / RELATIVE


def export_decoder(model: NeuralAsset) -> bytes:
    """Clamp, Gemm and Relu per layer, clamp, expm1: `queries` (N, K) to `transport` (N, 6)."""
    linear = [m for m in model.decoder if isinstance(m, torch.nn.Linear)]
    ceiling = float(model.ceiling)
    limits = {"low": -LARGEST_INPUT, "high": LARGEST_INPUT, "zero": 0.0,
              "highest": np.log1p(ceiling), "one": 1.0}
    constants = [numpy_helper.from_array(np.float32(v), name) for name, v in limits.items()]
    nodes, name = [helper.make_node("Clip", ["queries", "low", "high"], ["inputs"])], "inputs"
    for k, layer in enumerate(linear):
        weight, bias = f"weight{k}", f"bias{k}"
        constants += [
            numpy_helper.from_array(layer.weight.detach().numpy().T.copy(), weight),
            numpy_helper.from_array(layer.bias.detach().numpy(), bias),
        ]
        nodes.append(helper.make_node("Gemm", [name, weight, bias], [f"sum{k}"]))
        name = f"sum{k}"
        if layer is not linear[-1]:
            nodes.append(helper.make_node("Relu", [name], [f"hidden{k}"]))
            name = f"hidden{k}"
    nodes += [
        helper.make_node("Clip", [name, "zero", "highest"], ["y"]),
        helper.make_node("Exp", ["y"], ["x_plus_one"]),
        helper.make_node("Sub", ["x_plus_one", "one"], ["transport"]),
    ]
    columns = linear[0].in_features
    graph = helper.make_graph(
        nodes,
        "decoder",
        [helper.make_tensor_value_info("queries", TensorProto.FLOAT, ["N", columns])],
        [helper.make_tensor_value_info("transport", TensorProto.FLOAT, ["N", 6])],
        constants,
    )
    opsets = [helper.make_opsetid("", OPSET)]
    model_proto = helper.make_model(graph, opset_imports=opsets, ir_version=8, producer_name="rna-export")
    onnx.checker.check_model(model_proto)
    return model_proto.SerializeToString(deterministic=True)


@torch.no_grad()
def check_decoder(decoder: bytes, model: NeuralAsset, seed: int = 0) -> Agreement:
    """Compare ONNX with PyTorch on random and extreme queries; `ExportError` beyond tolerance."""
    queries = torch.cat([random_queries(model, _RANDOM_QUERIES, seed), extreme_queries(model, seed)])
    session = onnxruntime.InferenceSession(decoder, providers=["CPUExecutionProvider"])
    (found,) = session.run(["transport"], {"queries": queries.numpy()})
    expected = model.transport(model.decoder(queries)).numpy()
    difference = np.abs(found.astype(np.float64) - expected)
    large = np.abs(expected) > ABSOLUTE / RELATIVE
    agreement = Agreement(
        float(difference.max()),
        float((difference[large] / np.abs(expected[large])).max(initial=0.0)),
    )
    if not np.all(difference <= ABSOLUTE + RELATIVE * np.abs(expected)):
        raise ExportError(
            f"the ONNX decoder differs from PyTorch by up to {agreement.max_absolute:.2e} absolute, "
            f"{agreement.max_relative:.2e} relative; expected at most {ABSOLUTE:g} + {RELATIVE:g} |x|"
        )
    return agreement


def random_queries(model: NeuralAsset, n: int, seed: int) -> torch.Tensor:
    """Decoder inputs for random positions in the bounds and random directions, (n, K)."""
    generator = torch.Generator().manual_seed(seed)
    low, high = model.triplane.low, model.triplane.high
    position = low + (high - low) * torch.rand(n, 3, generator=generator)
    n_, wo, wi = torch.nn.functional.normalize(torch.randn(3, n, 3, generator=generator), dim=2)
    return model.queries(position, n_, wo, wi)


def extreme_queries(model: NeuralAsset, seed: int) -> torch.Tensor:
    """Corners of the box and beyond, aligned and opposite directions, features far out of range."""
    queries = random_queries(model, 600, seed + 1)
    low, high = model.triplane.low, model.triplane.high
    axis = torch.eye(3).repeat(100, 1)
    far = high + 10.0 * (high - low)
    corners = [
        model.queries(low.expand(300, 3), axis, axis, axis),
        model.queries(high.expand(300, 3), axis, axis, -axis),
        model.queries(far.expand(300, 3), axis, -axis, -axis),
    ]
    return torch.cat([torch.zeros_like(queries[:1]), 10.0 * queries, -10.0 * queries, *corners])
