"""The decoder as an ONNX graph (RNA-1.0, Decoder), and the check that it is the trained one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import onnx
import onnxruntime
import torch
from onnx import TensorProto, helper, numpy_helper

from rna_export.training.inputs import Points
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
    """`queries` (N, K) to `transport` (N, 6), with no more than RNA-1.0's operators."""
    graph = _Graph()
    value = graph.clip("queries", -LARGEST_INPUT, LARGEST_INPUT)
    for layer in model.decoder:
        if isinstance(layer, torch.nn.Linear):
            weight, bias = layer.weight.detach().numpy().T, layer.bias.detach().numpy()
            value = graph.add("Gemm", [value, graph.constant(weight), graph.constant(bias)])
        else:
            value = graph.add("Relu", [value])
    y = graph.clip(value, 0.0, float(torch.log1p(model.ceiling / model.unit)))
    x = graph.add("Sub", [graph.add("Exp", [y]), graph.constant(1.0)])
    sums, unit = np.array(model.config.colour_sums), float(model.unit)
    if np.array_equal(sums, np.eye(2)):
        graph.add("Mul", [x, graph.constant(unit)], "transport")
    else:
        matrix = unit * np.kron(sums.T, np.eye(3))
        graph.add("MatMul", [x, graph.constant(matrix)], "transport")
    return graph.serialize(model.decoder[0].in_features)


class _Graph:
    """An ONNX graph under construction; values and constants get names by number."""

    def __init__(self) -> None:
        self._nodes: list[onnx.NodeProto] = []
        self._constants: list[onnx.TensorProto] = []

    def constant(self, value: np.ndarray | float) -> str:
        name = f"c{len(self._constants)}"
        self._constants.append(numpy_helper.from_array(np.array(value, np.float32), name))
        return name

    def add(self, operator: str, inputs: list[str], output: str | None = None) -> str:
        output = output or f"v{len(self._nodes)}"
        self._nodes.append(helper.make_node(operator, inputs, [output]))
        return output

    def clip(self, value: str, low: float, high: float) -> str:
        return self.add("Clip", [value, self.constant(low), self.constant(high)])

    def serialize(self, columns: int) -> bytes:
        graph = helper.make_graph(
            self._nodes,
            "decoder",
            [helper.make_tensor_value_info("queries", TensorProto.FLOAT, ["N", columns])],
            [helper.make_tensor_value_info("transport", TensorProto.FLOAT, ["N", 6])],
            self._constants,
        )
        opsets = [helper.make_opsetid("", OPSET)]
        model = helper.make_model(
            graph, opset_imports=opsets, ir_version=8, producer_name="rna-export"
        )
        onnx.checker.check_model(model)
        return model.SerializeToString(deterministic=True)


@torch.no_grad()
def check_decoder(decoder: bytes, model: NeuralAsset, seed: int = 0) -> Agreement:
    """Compare ONNX with PyTorch on random and extreme queries; `ExportError` beyond tolerance."""
    queries = torch.cat(
        [random_queries(model, _RANDOM_QUERIES, seed), extreme_queries(model, seed)]
    )
    session = onnxruntime.InferenceSession(decoder, providers=["CPUExecutionProvider"])
    (found,) = session.run(["transport"], {"queries": queries.numpy()})
    expected = model.transport(model.decoder(queries).unflatten(1, (-1, 3))).flatten(1).numpy()
    difference = np.abs(found.astype(np.float64) - expected)
    large = np.abs(expected) > ABSOLUTE / RELATIVE
    agreement = Agreement(
        float(difference.max()),
        float((difference[large] / np.abs(expected[large])).max(initial=0.0)),
    )
    if not np.all(difference <= ABSOLUTE + RELATIVE * np.abs(expected)):
        raise ExportError(
            f"the ONNX decoder differs from PyTorch by up to {agreement.max_absolute:.2e} "
            f"absolute, {agreement.max_relative:.2e} relative; expected at most {ABSOLUTE:g} + "
            f"{RELATIVE:g} |x|"
        )
    return agreement


def random_queries(model: NeuralAsset, n: int, seed: int) -> torch.Tensor:
    """Decoder inputs for random positions in the bounds and random directions, (n, K)."""
    generator = torch.Generator().manual_seed(seed)
    low, high = model.triplane.low, model.triplane.high
    position = low + (high - low) * torch.rand(n, 3, generator=generator)
    frame, wo, wi = torch.nn.functional.normalize(torch.randn(3, n, 3, generator=generator), dim=2)
    return model.queries(_points(position, frame, wo, wi, 2.0 * wo[:, 0]))


def extreme_queries(model: NeuralAsset, seed: int) -> torch.Tensor:
    """Corners of the box and beyond, aligned and opposite directions, features far out of range."""
    queries = random_queries(model, 600, seed + 1)
    low, high = model.triplane.low, model.triplane.high
    axis = torch.eye(3).repeat(100, 1)
    far = high + 10.0 * (high - low)
    h = axis[:, 0]
    corners = [
        model.queries(_points(low.expand(300, 3), axis, axis, axis, h)),
        model.queries(_points(high.expand(300, 3), axis, axis, -axis, -h)),
        model.queries(_points(far.expand(300, 3), axis, -axis, -axis, h)),
    ]
    return torch.cat([torch.zeros_like(queries[:1]), 10.0 * queries, -10.0 * queries, *corners])


def _points(
    position: torch.Tensor, frame: torch.Tensor, wo: torch.Tensor, wi: torch.Tensor, h: torch.Tensor
) -> Points:
    """Points of either kind: `frame` is the normal or the tangent."""
    named = {"position": position, "normal": frame, "tangent": frame, "wo": wo, "wi": wi}
    return named | {"h": h}
