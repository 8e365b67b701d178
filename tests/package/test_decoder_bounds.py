"""Decoders for engines that keep within the bounds are taken, whatever their operators."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import onnx
from numpy.typing import NDArray
from onnx import helper, numpy_helper

from rna_sdk.package import Package, validate
from tests.package.builders import make_decoder_model
from tests.package.corpus.registry import DECODER, Entries, with_entry

COLUMNS, WIDTH = 18, 16


def engine_model() -> onnx.ModelProto:
    """Encodings of some columns, a layer with its weights transposed, a normalised one, MatMul."""
    rng = np.random.default_rng(5)
    constants: dict[str, NDArray[np.float32] | NDArray[np.int64]] = {
        "sizes": np.int64([3, COLUMNS - 3]),
        "frequency": np.float32([[1, 2, 4]]),
        "w0t": rng.normal(0, 0.3, (WIDTH, COLUMNS + 6)).astype(np.float32),
        "bias0": np.zeros(WIDTH, np.float32),
        "ones": np.ones(WIDTH, np.float32),
        "half": np.full((WIDTH, 6), 0.1, np.float32),
        "bias1": rng.normal(0, 0.3, (1, 6)).astype(np.float32),
    }
    nodes = [
        helper.make_node("Split", ["x0", "sizes"], ["few", "rest"], axis=1),
        helper.make_node("Mul", ["few", "frequency"], ["angle"]),
        helper.make_node("Sin", ["angle"], ["sine"]),
        helper.make_node("Cos", ["angle"], ["cosine"]),
        helper.make_node("Concat", ["few", "rest", "sine", "cosine"], ["encoded"], axis=-1),
        helper.make_node("Gemm", ["encoded", "w0t", "bias0"], ["layer"], transB=1),
        helper.make_node("LayerNormalization", ["layer", "ones", "bias0"], ["normal"]),
        helper.make_node("Gelu", ["normal"], ["active"]),
        helper.make_node("Mul", ["half", "half"], ["square"]),
        helper.make_node("MatMul", ["active", "square"], ["product"]),
        helper.make_node("Add", ["product", "bias1"], ["y0"]),
    ]
    model = make_decoder_model(COLUMNS, layers=0, opset=20)
    kept = [node for node in model.graph.node if node.op_type != "Gemm"]
    model.graph.initializer.extend(numpy_helper.from_array(v, k) for k, v in constants.items())
    del model.graph.node[:]
    model.graph.node.extend([kept[0], *nodes, *kept[1:]])
    return model


def test_a_decoder_of_many_operators_is_valid(entries: Entries, tmp_path: Path) -> None:
    path = tmp_path / "engine.rna"
    path.write_bytes(with_entry(entries, DECODER, engine_model().SerializeToString()))
    assert [issue.code for issue in validate(path)] == ["DECODER_PROFILE"]
    Package.open(path).close()
