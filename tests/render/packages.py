"""Package files with a known transport."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from onnx import TensorProto, helper, numpy_helper

from rna_sdk.package import Mesh, TierData, write_package
from tests.package.builders import make_manifest, make_planes, make_tier

ALBEDO = (0.8, 0.5, 0.2)
SHADOWED = (0.0, 0.0, 0.3)

COLUMNS = 18  # features 4, normal 3, wo 3, wi 3, half_vector 5
COSINE_COLUMN = 15  # n.wi, the third value of half_vector


def write_lambert_package(path: Path, mesh: Mesh, tiers: tuple[str, ...] = ("small",)) -> Path:
    """An asset with `visible` = ALBEDO / pi * max(n.wi, 0) and `shadowed` = SHADOWED."""
    records = [make_tier(name) for name in tiers]
    decoder = _lambert_decoder()
    data = {tier.name: TierData(planes=make_planes(), decoder=decoder) for tier in records}
    write_package(path, make_manifest(*records), mesh, data)
    return path


def _lambert_decoder() -> bytes:
    weights, bias = np.zeros((COLUMNS, 6), np.float32), np.zeros(6, np.float32)
    weights[COSINE_COLUMN, :3] = np.divide(ALBEDO, np.pi)
    bias[3:] = SHADOWED
    constants = {"low": np.float32(-65504), "high": np.float32(65504), "w": weights, "b": bias}
    graph = helper.make_graph(
        [
            helper.make_node("Clip", ["queries", "low", "high"], ["finite"]),
            helper.make_node("Gemm", ["finite", "w", "b"], ["signed"]),
            helper.make_node("Relu", ["signed"], ["transport"]),
        ],
        "lambert",
        [helper.make_tensor_value_info("queries", TensorProto.FLOAT, ["N", COLUMNS])],
        [helper.make_tensor_value_info("transport", TensorProto.FLOAT, ["N", 6])],
        [numpy_helper.from_array(value, name) for name, value in constants.items()],
    )
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 18)], ir_version=10)
    return model.SerializeToString()
