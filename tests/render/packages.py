"""Package files with a known transport."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from onnx import TensorProto, helper, numpy_helper

from rna_sdk.package import (
    Curves,
    Mesh,
    Tier,
    TierData,
    TierEmission,
    TransmittanceRecord,
    write_package,
)
from tests.package.builders import (
    FIBER_INPUTS,
    make_manifest,
    make_part,
    make_planes,
    make_tier,
    make_tier_part,
)
from tests.render.assets import merged, sphere, square

ALBEDO = (0.8, 0.5, 0.2)
SHADOWED = (0.0, 0.0, 0.3)

COLUMNS = 18  # features 4, normal 3, wo 3, wi 3, half_vector 5
COSINE_COLUMN = 15  # n.wi, the third value of half_vector
FIBER_COLUMNS = 23  # features 4, tangent 3, h 1, wo 3, wi 3, fiber_angles 6, fiber_lobes 3
H_COLUMN = 7
OFFSET_BIAS = (0.5, 0.5, 0.5, *SHADOWED)
EMISSION_COLUMNS = 7  # features 4, wo 3


def write_lambert_package(
    path: Path, mesh: Mesh, tiers: tuple[str | Tier, ...] = ("small",), **changes: Any
) -> Path:
    """An asset with `visible` = ALBEDO / pi * max(n.wi, 0) and `shadowed` = SHADOWED.

    tiers: names, or records. changes: of the manifest.
    """
    records = [make_tier(tier) if isinstance(tier, str) else tier for tier in tiers]
    weights = np.zeros((COLUMNS, 6), np.float32)
    weights[COSINE_COLUMN, :3] = np.divide(ALBEDO, np.pi)
    decoder = _linear_decoder(weights, [0, 0, 0, *SHADOWED])
    data = {tier.name: [TierData(planes=make_planes(), decoder=decoder)] for tier in records}
    write_package(path, make_manifest(*records, **changes), [mesh], data)
    return path


def write_offset_package(path: Path, curves: Curves) -> Path:
    """A fiber asset with `visible` = (1 + h) / 2 in all channels and `shadowed` = SHADOWED."""
    tier = make_tier(inputs=FIBER_INPUTS)
    weights = np.zeros((FIBER_COLUMNS, 6), np.float32)
    weights[H_COLUMN, :3] = 0.5
    data = TierData(planes=make_planes(), decoder=_linear_decoder(weights, OFFSET_BIAS))
    write_package(path, make_manifest(tier, kind="fiber"), [curves], {tier.name: [data]})
    return path


def write_lamp_package(path: Path, glow: tuple[float, float, float], tint: np.ndarray) -> Path:
    """A bulb that emits `glow`, a shade of panes of transmittance `tint`, and a fringe of strands.

    The bulb is a ball of radius 0.2, the shade four sides of a cube of half-side 0.5, the fringe
    strands of radius 0.01 on its edge. Transport: nothing of the bulb; of the shade that of
    `write_lambert_package`; of the fringe that of `write_offset_package`. tint: (3,) uint8.
    """
    weights = np.zeros((FIBER_COLUMNS, 6), np.float32)
    weights[H_COLUMN, :3] = 0.5
    lambert = np.zeros((COLUMNS, 6), np.float32)
    lambert[COSINE_COLUMN, :3] = np.divide(ALBEDO, np.pi)
    glowing = _linear_decoder(np.zeros((EMISSION_COLUMNS, 3), np.float32), glow, "emission")
    dark = _linear_decoder(np.zeros((COLUMNS, 6), np.float32), np.zeros(6))
    emission = TierEmission(
        decoder="decoders/glow.onnx", inputs=("features", "wo"), decoder_precision="float32"
    )
    tier = Tier(
        name="small",
        parts=(
            make_tier_part("bulb", emission=emission),
            make_tier_part("shade"),
            make_tier_part("fringe", inputs=FIBER_INPUTS),
        ),
    )
    texture = "transmittance/tint.safetensors"
    pane = TransmittanceRecord(triangles=(0, 8), texture=texture)
    parts = (
        make_part(name="bulb", geometry="geometry/bulb.glb"),
        make_part(name="shade", geometry="geometry/shade.glb", transmittance=(pane,)),
        make_part(name="fringe", kind="fiber", geometry="geometry/fringe.safetensors"),
    )
    data = [
        TierData(make_planes(), dark, {"emission": glowing}),
        TierData(make_planes(), _linear_decoder(lambert, [0, 0, 0, *SHADOWED])),
        TierData(make_planes(), _linear_decoder(weights, OFFSET_BIAS)),
    ]
    geometries = [sphere(3, radius=0.2), _shade(), _fringe()]
    manifest = make_manifest(tier, parts=parts)
    write_package(path, manifest, geometries, {"small": data}, {texture: tint.reshape(1, 1, 3)})
    return path


def _shade() -> Mesh:
    """Four upright sides of a cube of half-side 0.5 that face outward."""
    sides = []
    for quarter in range(4):
        cosine, sine = np.round([np.cos(quarter * np.pi / 2), np.sin(quarter * np.pi / 2)])
        turn = np.array([[cosine, 0, sine], [0, 1, 0], [-sine, 0, cosine]], np.float32)
        side = square(0.5, height=0.5)
        upright = np.float32([[1, 0, 0], [0, 0, -1], [0, 1, 0]]).T @ turn.T
        positions, normals = side.positions @ upright, side.normals @ upright
        sides.append(Mesh(positions, normals, None, side.triangles))
    return merged(*sides)


def _fringe() -> Curves:
    """Strands that stand on the upper edge of the shade's front."""
    x = np.linspace(-0.5, 0.5, 20)
    points = [[(place, 0.5, 0.5), (place, 0.7, 0.5)] for place in x]
    return Curves(
        np.float32(points).reshape(-1, 3),
        np.full(40, 0.01, np.float32),
        np.arange(0, 41, 2, dtype=np.uint32),
    )


def _linear_decoder(
    weights: np.ndarray, bias: Sequence[float] | np.ndarray, output: str = "transport"
) -> bytes:
    """Linear in the queries, but not negative."""
    bias = np.asarray(bias, np.float32)
    constants = {"low": np.float32(-65504), "high": np.float32(65504), "w": weights, "b": bias}
    graph = helper.make_graph(
        [
            helper.make_node("Clip", ["queries", "low", "high"], ["finite"]),
            helper.make_node("Gemm", ["finite", "w", "b"], ["signed"]),
            helper.make_node("Relu", ["signed"], [output]),
        ],
        "linear",
        [helper.make_tensor_value_info("queries", TensorProto.FLOAT, ["N", len(weights)])],
        [helper.make_tensor_value_info(output, TensorProto.FLOAT, ["N", len(bias)])],
        [numpy_helper.from_array(value, name) for name, value in constants.items()],
    )
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 18)], ir_version=10)
    return model.SerializeToString()
