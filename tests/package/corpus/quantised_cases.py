"""Packages whose quantised mesh or curves are wrong, though declared with their true hash."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from rna_sdk.package.container.tensor_file import tensors_to_bytes
from rna_sdk.package.geometry.geometry_files import quantise
from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from tests.package.builders import make_curves, make_mesh
from tests.package.corpus.content_cases import with_gltf
from tests.package.corpus.registry import CURVES, MESH, Entries, case, with_entry


def with_quantised_gltf(entries: Entries, edit: Callable[[dict[str, Any]], object]) -> bytes:
    """The package with a quantised mesh, whose JSON chunk is edited."""
    return with_gltf({**entries, MESH: mesh_to_glb(quantise(make_mesh()))}, edit)


def with_quantised_arrays(entries: Entries, **changes: Any) -> bytes:
    """The package with a quantised mesh of other arrays."""
    mesh = quantise(make_mesh())
    for name, array in changes.items():
        object.__setattr__(mesh.quantised, name, array)
    return with_entry(entries, MESH, mesh_to_glb(mesh))


def with_steps(entries: Entries, **changes: Any) -> bytes:
    """The package with quantised curves of other tensors; None leaves one out."""
    tensors = {**vars(quantise(make_curves()).quantised), **changes}
    remaining = {name: array for name, array in tensors.items() if array is not None}
    return with_entry(entries, CURVES, tensors_to_bytes(remaining))


# Meshes


@case("GEOMETRY_PROFILE")
def quantised_glb_that_requires_nothing(entries: Entries) -> bytes:
    return with_quantised_gltf(entries, lambda g: g.pop("extensionsRequired"))


@case("GEOMETRY_PROFILE")
def quantised_glb_of_another_extension(entries: Entries) -> bytes:
    def edit(document: dict[str, Any]) -> None:
        document["extensionsUsed"] = document["extensionsRequired"] = ["KHR_draco_mesh_compression"]

    return with_quantised_gltf(entries, edit)


@case("GEOMETRY_PROFILE")
def quantised_glb_that_does_not_say_so(entries: Entries) -> bytes:
    def edit(document: dict[str, Any]) -> None:
        for name in ("extensionsUsed", "extensionsRequired"):
            del document[name]
        for name in ("translation", "scale"):
            del document["nodes"][0][name]

    return with_quantised_gltf(entries, edit)


@case("GEOMETRY_PROFILE")
def quantised_glb_without_translation(entries: Entries) -> bytes:
    return with_quantised_gltf(entries, lambda g: g["nodes"][0].pop("translation"))


@case("GEOMETRY_PROFILE")
def quantised_glb_of_three_scales(entries: Entries) -> bytes:
    return with_quantised_gltf(entries, lambda g: g["nodes"][0].update(scale=[1, 1, 2]))


@case("GEOMETRY_PROFILE")
def quantised_glb_without_extent(entries: Entries) -> bytes:
    return with_quantised_gltf(entries, lambda g: g["nodes"][0].update(scale=[0, 0, 0]))


@case("GEOMETRY_PROFILE")
def quantised_glb_of_whole_normals(entries: Entries) -> bytes:
    return with_quantised_gltf(entries, lambda g: g["accessors"][1].pop("normalized"))


@case("GEOMETRY_PROFILE")
def quantised_glb_of_normalized_positions(entries: Entries) -> bytes:
    return with_quantised_gltf(entries, lambda g: g["accessors"][0].update(normalized=True))


@case("GEOMETRY_PROFILE")
def quantised_glb_of_float_positions(entries: Entries) -> bytes:
    return with_quantised_gltf(entries, lambda g: g["accessors"][0].update(componentType=5126))


@case("GEOMETRY_PROFILE")
def quantised_glb_without_stride(entries: Entries) -> bytes:
    return with_quantised_gltf(entries, lambda g: g["bufferViews"][0].pop("byteStride"))


@case("GEOMETRY_PROFILE")
def glb_with_a_stride(entries: Entries) -> bytes:
    return with_gltf(entries, lambda g: g["bufferViews"][0].update(byteStride=8))


@case("GEOMETRY_PROFILE")
def glb_with_a_normalized_accessor(entries: Entries) -> bytes:
    return with_gltf(entries, lambda g: g["accessors"][0].update(normalized=True))


@case("GEOMETRY_PROFILE")
def quantised_glb_of_short_indices_for_many(entries: Entries) -> bytes:
    return with_quantised_gltf(entries, lambda g: g["accessors"][0].update(count=65535))


@case("GEOMETRY_RANGE")
def quantised_glb_past_its_view(entries: Entries) -> bytes:
    return with_quantised_gltf(entries, lambda g: g["bufferViews"][1].update(byteLength=93))


@case("GEOMETRY_BOUNDS")
def quantised_glb_of_metric_bounds(entries: Entries) -> bytes:
    return with_quantised_gltf(entries, lambda g: g["accessors"][0].update(max=[0.8, 0.9, 0.6]))


@case("GEOMETRY_NOT_FINITE")
def quantised_glb_that_overflows(entries: Entries) -> bytes:
    return with_quantised_gltf(entries, lambda g: g["nodes"][0].update(scale=[1e38] * 3))


@case("GEOMETRY_NORMAL")
def quantised_glb_with_a_normal_of_zero(entries: Entries) -> bytes:
    return with_quantised_arrays(entries, normals=np.zeros((12, 3), np.int16))


@case("GEOMETRY_NORMAL")
def quantised_glb_with_half_a_normal(entries: Entries) -> bytes:
    normals = quantise(make_mesh()).quantised.normals
    return with_quantised_arrays(entries, normals=normals // 2)


@case("GEOMETRY_INDEX")
def quantised_glb_of_a_missing_vertex(entries: Entries) -> bytes:
    return with_quantised_arrays(entries, triangles=np.uint32([[0, 1, 12]]))


# Curves


@case("GEOMETRY_PROFILE", base="fiber")
def quantised_curves_with_points(entries: Entries) -> bytes:
    return with_steps(entries, points=make_curves().points)


@case("GEOMETRY_PROFILE", base="fiber")
def quantised_curves_without_origins(entries: Entries) -> bytes:
    return with_steps(entries, origins=None)


@case("GEOMETRY_PROFILE", base="fiber")
def quantised_curves_of_float_steps(entries: Entries) -> bytes:
    return with_steps(entries, steps=np.ones((6, 3), np.float32))


@case("GEOMETRY_PROFILE", base="fiber")
def quantised_curves_of_int8_steps(entries: Entries) -> bytes:
    return with_steps(entries, steps=np.ones((6, 3), np.int8))


@case("GEOMETRY_ARRAY", base="fiber")
def quantised_curves_of_too_few_steps(entries: Entries) -> bytes:
    return with_steps(entries, steps=np.ones((5, 3), np.int16))


@case("GEOMETRY_ARRAY", base="fiber")
def quantised_curves_of_too_few_origins(entries: Entries) -> bytes:
    return with_steps(entries, origins=np.zeros((2, 3), np.float32))


@case("GEOMETRY_STRANDS", base="fiber")
def quantised_curves_of_one_point(entries: Entries) -> bytes:
    return with_steps(entries, offsets=np.uint32([0, 4, 5, 9]))


@case("GEOMETRY_STRANDS", base="fiber")
def quantised_curves_that_go_back(entries: Entries) -> bytes:
    return with_steps(entries, offsets=np.uint32([0, 2**31, 4, 9]))


@case("GEOMETRY_STEPS", base="fiber")
def quantised_curves_of_no_step(entries: Entries) -> bytes:
    return with_steps(entries, scales=np.float32([0, 1e-4]))


@case("GEOMETRY_STEPS", base="fiber")
def quantised_curves_of_steps_backwards(entries: Entries) -> bytes:
    return with_steps(entries, scales=np.float32([-1e-4, 1e-4]))


@case("GEOMETRY_STEPS", base="fiber")
def quantised_curves_of_unknown_steps(entries: Entries) -> bytes:
    return with_steps(entries, scales=np.float32([np.nan, 1e-4]))


@case("GEOMETRY_STEPS", base="fiber")
def quantised_curves_of_too_many_steps(entries: Entries) -> bytes:
    return with_steps(entries, steps=np.full((6, 3), 2**30, np.int32))


@case("GEOMETRY_SEGMENT", base="fiber")
def quantised_curves_that_stand_still(entries: Entries) -> bytes:
    return with_steps(entries, steps=np.zeros((6, 3), np.int16))


@case("GEOMETRY_SEGMENT", base="fiber")
def quantised_curves_of_steps_below_float32(entries: Entries) -> bytes:
    steps = np.ones((6, 3), np.int16)
    return with_steps(
        entries, origins=np.ones((3, 3), np.float32), steps=steps, scales=np.float32([1e-9, 1e-4])
    )


@case("GEOMETRY_RADIUS", base="fiber")
def quantised_curves_with_a_radius_of_zero(entries: Entries) -> bytes:
    return with_steps(entries, radii=np.uint8([9, 9, 9, 0, 9, 9, 9, 9, 9]))


@case("GEOMETRY_RADIUS", base="fiber")
def quantised_curves_of_negative_radii(entries: Entries) -> bytes:
    return with_steps(entries, scales=np.float32([1e-4, -1e-4]))


@case("GEOMETRY_NOT_FINITE", base="fiber")
def quantised_curves_from_infinity(entries: Entries) -> bytes:
    return with_steps(entries, origins=np.float32([[np.inf, 0, 0]] * 3))
