"""Small good packages, and the pieces to make bad ones of."""

import io
from collections.abc import Iterable, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

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
    ProfileDecoder,
    ProfileLayer,
    Provenance,
    Tier,
    TierData,
    TierPart,
    Validation,
    decoder_to_bytes,
    write_package,
)
from rna_sdk.package.container.zip_container import MANIFEST_NAME, Container, read_file
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


LIMIT = 65504.0
"""What queries of the decoders here are clipped to, either way."""


def random_decoder(
    columns: int = 18, width: int = 8, layers: int = 1, seed: int = 2, **overrides: Any
) -> ProfileDecoder:
    """ReLU layers whose result is exp(x) - 1, safe for every finite input.

    `overrides`: output (its name), outputs (6; 3 for emission).
    """
    rng = np.random.default_rng(seed)
    sizes = [columns, *[width] * layers, outputs_of(overrides)]
    made = []
    for i, (rows, cols) in enumerate(pairwise(sizes)):
        weight = rng.normal(0, (2 / rows) ** 0.5, (rows, cols)).astype(np.float32)
        bias = rng.normal(0, 0.1, cols).astype(np.float32)
        made.append(ProfileLayer(weight, bias, 0.0, None, relu=i < layers))
    return decoder_of(made, **overrides)


def random_int8_decoder(
    columns: int = 18, width: int = 8, layers: int = 1, seed: int = 2, **overrides: Any
) -> ProfileDecoder:
    """The like of `random_decoder` in int8; `overrides`: also `largest`, of the weights (127)."""
    rng = np.random.default_rng(seed)
    sizes = [columns, *[width] * layers, outputs_of(overrides)]
    largest, step = overrides.pop("largest", 127), np.float32(1 / 30)
    made = []
    for i, (rows, cols) in enumerate(pairwise(sizes)):
        weight = rng.integers(-largest, largest + 1, (rows, cols)).astype(np.int8)
        scale = (rng.uniform(0.5, 1.5, cols) * (2 / rows) ** 0.5 / 73).astype(np.float32)
        bias = rng.normal(1 if i == layers else 0, 0.2, cols) / (step * scale)
        decoder = step
        if i == 0:  # of queries in steps, from -100 of them up
            decoder, scale = np.float32(1), scale * step
            bias -= 100 * weight.astype(np.int64).sum(axis=0)
        rounded = np.round(bias).astype(np.int32)
        made.append(ProfileLayer(weight, rounded, float(decoder), scale, relu=False))
    gain, offset = (np.full(columns, value, np.float32) for value in (30, 100))
    return decoder_of(made, gain=gain, offset=offset, **overrides)


def decoder_of(layers: Sequence[ProfileLayer], **overrides: Any) -> ProfileDecoder:
    """The decoder of these layers; `overrides`: members of it, except `outputs`."""
    fields: dict[str, Any] = {"low": -LIMIT, "high": LIMIT, "gain": None, "offset": None}
    fields |= {"top": 11.0, "unit": 1.0, "matrix": None, **overrides}
    fields.pop("outputs", None)
    return ProfileDecoder(layers=tuple(layers), **fields)


def outputs_of(overrides: dict[str, Any]) -> int:
    """Columns of the output."""
    return overrides.get("outputs", 3 if overrides.get("output") == "emission" else 6)


def make_tier_part(name: str = "small", **changes: Any) -> TierPart:
    """The record of a tier part that `make_planes` and `random_decoder` fit."""
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
    members = {key: changes.pop(key) for key in ("parts", "validation", "cost") if key in changes}
    return Tier(**{"name": name, "parts": (make_tier_part(name, **changes),), **members})


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
    part_members = {
        key: changes.pop(key) for key in ("kind", "bounds", "geometry") if key in changes
    }
    fields: dict[str, Any] = {
        "generator": "tests",
        "name": "tetrahedron",
        "parts": (make_part(**part_members),),
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
        decoder.form.name: make_decoder(
            *(decoder.precision, decoder.columns, width, layers, seed),
            outputs=decoder.width,
            output=decoder.form.name,
        )
        for decoder in part.decoders
    }
    planes = make_planes(part.resolution, part.channels, part.plane_precision, seed)
    return TierData(planes, made.pop(part.decoders[0].form.name), made)


def make_decoder(precision: str, *sizes: int, **overrides: Any) -> bytes:
    """The file of a random decoder of this precision."""
    make = random_int8_decoder if precision == "int8" else random_decoder
    return decoder_to_bytes(make(*sizes, **overrides))


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
    container = Container.of(read_file(path), path)
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
    "random_decoder",
    "random_int8_decoder",
    "read_entries",
]
