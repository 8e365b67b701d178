"""Small good packages, and the pieces to make bad ones of."""

from __future__ import annotations

import io
from collections.abc import Iterable
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import onnx
from numpy.typing import NDArray
from onnx import TensorProto, helper, numpy_helper

from rna_sdk.package import (
    Bounds,
    Cost,
    Curves,
    Domain,
    FlipAtHeight,
    Int8Planes,
    Manifest,
    Mesh,
    Part,
    Provenance,
    Tier,
    TierData,
    TierPart,
    Validation,
    write_package,
)
from rna_sdk.package.container.zip_container import MANIFEST_NAME, Container
from rna_sdk.package.container.zip_writer import write_container
from rna_sdk.package.manifest.manifest_fields import GEOMETRY_ENTRIES

INPUTS = ("features", "normal", "wo", "wi", "half_vector")
FIBER_INPUTS = ("features", "tangent", "h", "wo", "wi", "fiber_angles", "fiber_lobes")


def make_mesh(uvs: bool = True) -> Mesh:
    """A tetrahedron inside the bounds [-1, 1]^3, flat shaded: 12 vertices, 4 triangles."""
    corners = np.float32([[0, 0.9, 0], [-0.8, -0.5, 0.6], [0.8, -0.5, 0.6], [0, -0.5, -0.9]])
    faces = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])
    positions = corners[faces].reshape(-1, 3)
    a, b, c = (corners[faces[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return Mesh(
        positions=positions,
        normals=np.repeat(normals, 3, axis=0).astype(np.float32),
        uvs=np.abs(positions[:, :2]) if uvs else None,
        triangles=np.arange(12, dtype=np.uint32).reshape(-1, 3),
    )


def make_curves() -> Curves:
    """Three strands inside the bounds [-1, 1]^3, of 4, 2 and 3 points, thinner to the tip."""
    counts = (4, 2, 3)
    strands = [
        np.linspace((k - 1, -0.5, 0), ((k - 1) / 2, 0.5, k / 4), counts[k]) for k in range(3)
    ]
    radii = [np.linspace(0.02, 0.01, count) for count in counts]
    return Curves(
        points=(np.concatenate(strands) * 0.9).astype(np.float32),
        radii=np.concatenate(radii).astype(np.float32),
        offsets=np.cumsum((0, *counts)).astype(np.uint32),
    )


def make_planes(
    resolution: int = 8, channels: int = 4, precision: str = "float16", seed: int = 1
) -> Any:
    """(3, R, R, C) of normal random numbers; of int8, scales that differ fourfold with them."""
    shape, rng = (3, resolution, resolution, channels), np.random.default_rng(seed)
    if precision == "int8":
        texels = rng.integers(-128, 128, shape).astype(np.int8)
        return Int8Planes(texels, rng.uniform(0.002, 0.008, (3, channels)).astype(np.float32))
    return rng.normal(0, 0.5, shape).astype(precision)


def make_decoder_model(
    columns: int = 18, width: int = 8, layers: int = 1, seed: int = 2, **overrides: Any
) -> onnx.ModelProto:
    """An MLP of ReLU layers that ends in exp(x) - 1, safe for every finite input.

    `overrides`: opset, ir_version, outputs (6; 3 for emission), output (its name).
    """
    rng = np.random.default_rng(seed)
    outputs = outputs_of(overrides)
    sizes = [columns, *[width] * layers, outputs]
    constants: dict[str, NDArray[np.float32]] = {
        "low": np.float32(-65504.0),
        "high": np.float32(65504.0),
    }
    nodes = [helper.make_node("Clip", ["queries", "low", "high"], ["x0"])]
    for i, (rows, cols) in enumerate(pairwise(sizes)):
        constants[f"w{i}"] = rng.normal(0, (2 / rows) ** 0.5, (rows, cols)).astype(np.float32)
        constants[f"b{i}"] = rng.normal(0, 0.1, cols).astype(np.float32)
        last = i == len(sizes) - 2
        nodes.append(helper.make_node("Gemm", [f"x{i}", f"w{i}", f"b{i}"], [f"y{i}"]))
        if not last:
            nodes.append(helper.make_node("Relu", [f"y{i}"], [f"x{i + 1}"]))
    return _decoder(nodes, constants, f"y{len(sizes) - 2}", columns, **overrides)


def make_int8_decoder_model(
    columns: int = 18, width: int = 8, layers: int = 1, seed: int = 2, **overrides: Any
) -> onnx.ModelProto:
    """The like of `make_decoder_model` in int8; the queries have another zero point than 0.

    `overrides`: also `largest`, of the weights (127); `in_profile`, with a gain and an offset for
    each column instead of the zero point.
    """
    rng = np.random.default_rng(seed)
    sizes = [columns, *[width] * layers, outputs_of(overrides)]
    largest, in_profile = overrides.get("largest", 127), overrides.get("in_profile", False)
    step = np.float32(1 / 30)
    constants: dict[str, NDArray[Any]] = {"low": np.float32(-65504.0), "high": np.float32(65504.0)}
    nodes = [helper.make_node("Clip", ["queries", "low", "high"], ["y"])]
    value = "y"
    if in_profile:
        constants |= {"gain": np.full(columns, 30, np.float32)}
        constants |= {"offset": np.full(columns, 100, np.float32)}
        nodes.append(helper.make_node("Mul", ["y", "gain"], ["scaled"]))
        nodes.append(helper.make_node("Add", ["scaled", "offset"], ["moved"]))
        value = "moved"
    for i, (rows, cols) in enumerate(pairwise(sizes)):
        weight = rng.integers(-largest, largest + 1, (rows, cols)).astype(np.int8)
        scale = (rng.uniform(0.5, 1.5, cols) * (2 / rows) ** 0.5 / 73).astype(np.float32)
        bias = rng.normal(1 if i == layers else 0, 0.2, cols) / (step * scale)
        own_step, zero = step, 100 if i == 0 else 0
        if in_profile and i == 0:
            own_step, zero, scale = np.float32(1), 0, scale * step
            bias -= 100 * weight.astype(np.int64).sum(axis=0)
        constants |= {f"step{i}": own_step, f"z{i}": np.uint8(zero)}
        constants |= {f"s{i}": scale, f"t{i}": own_step * scale, f"w{i}": weight}
        constants[f"b{i}"] = np.round(bias).astype(np.int32)
        for operator, inputs, output, axis in (
            ("QuantizeLinear", [value, f"step{i}", f"z{i}"], f"q{i}", None),
            ("DequantizeLinear", [f"q{i}", f"step{i}", f"z{i}"], f"x{i}", None),
            ("DequantizeLinear", [f"w{i}", f"s{i}"], f"v{i}", 1),
            ("DequantizeLinear", [f"b{i}", f"t{i}"], f"c{i}", 0),
            ("Gemm", [f"x{i}", f"v{i}", f"c{i}"], f"y{i}", None),
        ):
            attributes = {} if axis is None else {"axis": axis}
            nodes.append(helper.make_node(operator, inputs, [output], **attributes))
        value = f"y{i}"
    return _decoder(nodes, constants, value, columns, **overrides)


def outputs_of(overrides: dict[str, Any]) -> int:
    """Columns of the output."""
    return overrides.get("outputs", 3 if overrides.get("output") == "emission" else 6)


def _decoder(
    nodes: list[onnx.NodeProto],
    constants: dict[str, NDArray[Any]],
    value: str,
    columns: int,
    **overrides: Any,
) -> onnx.ModelProto:
    """The model of these nodes and exp(value) - 1."""
    output = overrides.get("output", "transport")
    ends = {"one": 1.0, "zero": 0.0, "largest": 11.0, "unit": 1.0}
    constants = constants | {name: np.float32(number) for name, number in ends.items()}
    nodes = [
        *nodes,
        helper.make_node("Clip", [value, "zero", "largest"], ["logs"]),
        helper.make_node("Exp", ["logs"], ["exps"]),
        helper.make_node("Sub", ["exps", "one"], ["above"]),
        helper.make_node("Mul", ["above", "unit"], [output]),
    ]
    graph = helper.make_graph(
        nodes,
        "decoder",
        [helper.make_tensor_value_info("queries", TensorProto.FLOAT, ["N", columns])],
        [helper.make_tensor_value_info(output, TensorProto.FLOAT, ["N", outputs_of(overrides)])],
        [numpy_helper.from_array(np.asarray(value), name) for name, value in constants.items()],
    )
    opsets = [helper.make_opsetid("", overrides.get("opset", 18))]
    return helper.make_model(
        graph, opset_imports=opsets, ir_version=overrides.get("ir_version", 10)
    )


def make_tier_part(name: str = "small", **changes: Any) -> TierPart:
    """The record of a tier part that `make_planes` and `make_decoder_model` fit."""
    fields: dict[str, Any] = {
        "planes": f"features/{name}.safetensors",
        "decoder": f"decoders/{name}.onnx",
        "inputs": INPUTS,
        "resolution": 8,
        "channels": 4,
        "plane_precision": "float16",
        "decoder_precision": "float32",
    }
    return TierPart(**{**fields, **changes})


def make_tier(name: str = "small", **changes: Any) -> Tier:
    """The record of a tier of one part; `changes` are fields of the tier or of its part."""
    own = {key: changes.pop(key) for key in ("parts", "validation", "cost") if key in changes}
    return Tier(**{"name": name, "parts": (make_tier_part(name, **changes),), **own})


def make_part(**changes: Any) -> Part:
    """The record of a part in the bounds [-1, 1]^3."""
    kind = changes.get("kind", "surface")
    fields: dict[str, Any] = {
        "name": "asset",
        "kind": kind,
        "bounds": Bounds(min=(-1, -1, -1), max=(1, 1, 1)),
        "geometry": GEOMETRY_ENTRIES[kind],
    }
    return Part(**{**fields, **changes})


def make_manifest(*tiers: Tier, **changes: Any) -> Manifest:
    """A manifest without entries, for these tiers (or for one, `small`).

    `changes` are fields of the manifest or of its one part.
    """
    own = {key: changes.pop(key) for key in ("kind", "bounds", "geometry") if key in changes}
    fields: dict[str, Any] = {
        "generator": "tests",
        "name": "tetrahedron",
        "parts": (make_part(**own),),
        "domain": Domain(wo="sphere", wi="sphere"),
        "tiers": tiers or (make_tier(),),
        "provenance": Provenance(source="tests/package/builders.py", tool="tests"),
        "license": "Apache-2.0",
    }
    return Manifest(**{**fields, **changes})


def make_measured_tier(
    name: str, flip: float | None, multiply_adds: int | None, *at_heights: tuple[int, float]
) -> Tier:
    """A tier with a recorded error, and with errors at heights; or without a record."""
    validation = flip is not None and Validation(
        psnr=30.0,
        flip=flip,
        relative_mse=0.1,
        images=1,
        definition="made up",
        flip_at_height=tuple(FlipAtHeight(height=h, flip=e) for h, e in at_heights),
    )
    cost = multiply_adds is not None and Cost(
        multiply_adds=multiply_adds, ns_per_query=1.0, threads=1, machine="made up"
    )
    return make_tier(name, validation=validation or None, cost=cost or None)


def make_tier_data(tier: Tier, width: int = 8, layers: int = 1, seed: int = 1) -> list[TierData]:
    """For each part, random planes and random decoders that fit the tier."""
    return [make_part_data(part, width, layers, seed + k) for k, part in enumerate(tier.parts)]


def make_part_data(part: TierPart, width: int = 8, layers: int = 1, seed: int = 1) -> TierData:
    """Random planes and random decoders that fit the tier part."""
    made = {
        own.form.name: make_decoder(
            *(own.precision, own.columns, width, layers, seed),
            outputs=own.width,
            output=own.form.name,
        )
        for own in part.decoders
    }
    planes = make_planes(part.resolution, part.channels, part.plane_precision, seed)
    return TierData(planes, made.pop("transport"), made)


def make_decoder(precision: str, *sizes: int, **overrides: Any) -> bytes:
    """The file of a random decoder of this precision."""
    make = make_int8_decoder_model if precision == "int8" else make_decoder_model
    return make(*sizes, **overrides).SerializeToString()


def make_tiny_package(path: str | Path, *tiers: Tier, **changes: Any) -> Path:
    """Write a good package of a few kilobytes to `path`; `changes` as for `make_manifest`."""
    manifest = make_manifest(*tiers, **changes)
    data = {tier.name: make_tier_data(tier) for tier in manifest.tiers}
    geometries = [make_curves() if p.kind == "fiber" else make_mesh() for p in manifest.parts]
    write_package(path, manifest, geometries, data)
    return Path(path)


def make_tiny_fiber_package(path: str | Path, **changes: Any) -> Path:
    """The like of `make_tiny_package` for curves."""
    tier = make_tier(inputs=FIBER_INPUTS)
    return make_tiny_package(path, tier, kind="fiber", name="tuft", **changes)


def read_entries(path: str | Path) -> dict[str, bytes]:
    """All entries of a good package, name -> data."""
    container = Container.open(path)
    return {name: bytes(container.view(name)) for name in container.entries}


def pack(entries: Iterable[tuple[str, bytes]]) -> bytes:
    """The container of these (name, data) entries, none of them checked."""
    file = io.BytesIO()
    write_container(file, entries)
    return file.getvalue()


__all__ = [
    "FIBER_INPUTS",
    "INPUTS",
    "MANIFEST_NAME",
    "make_curves",
    "make_decoder",
    "make_decoder_model",
    "make_int8_decoder_model",
    "make_manifest",
    "make_measured_tier",
    "make_mesh",
    "make_part",
    "make_part_data",
    "make_planes",
    "make_tier",
    "make_tier_data",
    "make_tier_part",
    "make_tiny_fiber_package",
    "make_tiny_package",
    "pack",
    "read_entries",
]
