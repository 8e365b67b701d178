"""Package files with a known transport."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from onnx import TensorProto, helper, numpy_helper

from rna_sdk.package import Curves, Mesh, Tier, TierData, write_package
from tests.package.builders import FIBER_INPUTS, make_manifest, make_planes, make_tier

ALBEDO = (0.8, 0.5, 0.2)
SHADOWED = (0.0, 0.0, 0.3)

COLUMNS = 18  # features 4, normal 3, wo 3, wi 3, half_vector 5
COSINE_COLUMN = 15  # n.wi, the third value of half_vector
FIBER_COLUMNS = 23  # features 4, tangent 3, h 1, wo 3, wi 3, fiber_angles 6, fiber_lobes 3
H_COLUMN = 7


def write_lambert_package(
    path: Path, mesh: Mesh, tiers: tuple[str | Tier, ...] = ("small",), **changes: Any
) -> Path:
    """An asset with `visible` = ALBEDO / pi * max(n.wi, 0) and `shadowed` = SHADOWED.

    tiers: names, or records. changes: of the manifest.
    """
    records = [make_tier(tier) if isinstance(tier, str) else tier for tier in tiers]
    weights = np.zeros((COLUMNS, 6), np.float32)
    weights[COSINE_COLUMN, :3] = np.divide(ALBEDO, np.pi)
    decoder = _linear_decoder(weights, np.zeros(3))
    data = {tier.name: [TierData(planes=make_planes(), decoder=decoder)] for tier in records}
    write_package(path, make_manifest(*records, **changes), [mesh], data)
    return path


def write_offset_package(path: Path, curves: Curves) -> Path:
    """A fiber asset with `visible` = (1 + h) / 2 in all channels and `shadowed` = SHADOWED."""
    tier = make_tier(inputs=FIBER_INPUTS)
    weights = np.zeros((FIBER_COLUMNS, 6), np.float32)
    weights[H_COLUMN, :3] = 0.5
    data = TierData(planes=make_planes(), decoder=_linear_decoder(weights, np.full(3, 0.5)))
    write_package(path, make_manifest(tier, kind="fiber"), [curves], {tier.name: [data]})
    return path


def _linear_decoder(weights: np.ndarray, visible_bias: np.ndarray) -> bytes:
    """`visible` is linear in the queries, but not negative; `shadowed` is SHADOWED."""
    bias = np.concatenate([visible_bias, SHADOWED]).astype(np.float32)
    constants = {"low": np.float32(-65504), "high": np.float32(65504), "w": weights, "b": bias}
    graph = helper.make_graph(
        [
            helper.make_node("Clip", ["queries", "low", "high"], ["finite"]),
            helper.make_node("Gemm", ["finite", "w", "b"], ["signed"]),
            helper.make_node("Relu", ["signed"], ["transport"]),
        ],
        "linear",
        [helper.make_tensor_value_info("queries", TensorProto.FLOAT, ["N", len(weights)])],
        [helper.make_tensor_value_info("transport", TensorProto.FLOAT, ["N", 6])],
        [numpy_helper.from_array(value, name) for name, value in constants.items()],
    )
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 18)], ir_version=10)
    return model.SerializeToString()
