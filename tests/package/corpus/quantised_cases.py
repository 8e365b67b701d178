"""Packages whose quantised mesh or curves are wrong, though declared with their true hash."""

from collections.abc import Callable
from typing import Any

import numpy as np

from rna_sdk.package.container.tensor_file import tensors_to_bytes
from rna_sdk.package.geometry.geometry_files import quantise
from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from tests.package.builders import make_curves, make_mesh
from tests.package.corpus.content_cases import in_gltf, with_gltf
from tests.package.corpus.registry import CURVES, MESH, Corpus, Entries, breaks_by, with_entry

CASES = Corpus("surface")


def with_quantised_gltf(entries: Entries, edit: Callable[[dict[str, Any]], object]) -> bytes:
    """The package with a quantised mesh, whose JSON chunk is edited."""
    return with_gltf({**entries, MESH: mesh_to_glb(quantise(make_mesh()))}, edit)


in_quantised = breaks_by(with_quantised_gltf)


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


CASES.add(
    "GEOMETRY_PROFILE",
    quantised_glb_that_requires_nothing=in_quantised(lambda g: g.pop("extensionsRequired")),
    quantised_glb_without_translation=in_quantised(lambda g: g["nodes"][0].pop("translation")),
    quantised_glb_of_three_scales=in_quantised(lambda g: g["nodes"][0].update(scale=[1, 1, 2])),
    quantised_glb_without_extent=in_quantised(lambda g: g["nodes"][0].update(scale=[0, 0, 0])),
    quantised_glb_of_whole_normals=in_quantised(lambda g: g["accessors"][1].pop("normalized")),
    quantised_glb_of_normalized_positions=in_quantised(
        lambda g: g["accessors"][0].update(normalized=True)
    ),
    quantised_glb_of_float_positions=in_quantised(
        lambda g: g["accessors"][0].update(componentType=5126)
    ),
    quantised_glb_without_stride=in_quantised(lambda g: g["bufferViews"][0].pop("byteStride")),
    glb_with_a_stride=in_gltf(lambda g: g["bufferViews"][0].update(byteStride=8)),
    glb_with_a_normalized_accessor=in_gltf(lambda g: g["accessors"][0].update(normalized=True)),
    quantised_glb_of_short_indices_for_many=in_quantised(
        lambda g: g["accessors"][0].update(count=65535)
    ),
)


@CASES.case("GEOMETRY_PROFILE")
def quantised_glb_of_another_extension(entries: Entries) -> bytes:
    def edit(document: dict[str, Any]) -> None:
        document["extensionsUsed"] = document["extensionsRequired"] = ["KHR_draco_mesh_compression"]

    return with_quantised_gltf(entries, edit)


@CASES.case("GEOMETRY_PROFILE")
def quantised_glb_that_does_not_say_so(entries: Entries) -> bytes:
    def edit(document: dict[str, Any]) -> None:
        for name in ("extensionsUsed", "extensionsRequired"):
            del document[name]
        for name in ("translation", "scale"):
            del document["nodes"][0][name]

    return with_quantised_gltf(entries, edit)


CASES.add(
    "GEOMETRY_RANGE",
    quantised_glb_past_its_view=in_quantised(lambda g: g["bufferViews"][1].update(byteLength=93)),
)
CASES.add(
    "GEOMETRY_BOUNDS",
    quantised_glb_of_metric_bounds=in_quantised(
        lambda g: g["accessors"][0].update(max=[0.8, 0.9, 0.6])
    ),
)
CASES.add(
    "GEOMETRY_NOT_FINITE",
    quantised_glb_that_overflows=in_quantised(lambda g: g["nodes"][0].update(scale=[1e38] * 3)),
)
CASES.add(
    "GEOMETRY_NORMAL",
    quantised_glb_with_a_normal_of_zero=lambda e: with_quantised_arrays(
        e, normals=np.zeros((12, 3), np.int16)
    ),
    quantised_glb_with_half_a_normal=lambda e: with_quantised_arrays(
        e, normals=quantise(make_mesh()).quantised.normals // 2
    ),
)
CASES.add(
    "GEOMETRY_INDEX",
    quantised_glb_of_a_missing_vertex=lambda e: with_quantised_arrays(
        e, triangles=np.uint32([[0, 1, 12]])
    ),
)


# Curves


CASES.add(
    "GEOMETRY_PROFILE",
    base="fiber",
    quantised_curves_with_points=lambda e: with_steps(e, points=make_curves().points),
    quantised_curves_without_origins=lambda e: with_steps(e, origins=None),
    quantised_curves_of_float_steps=lambda e: with_steps(e, steps=np.ones((6, 3), np.float32)),
    quantised_curves_of_int8_steps=lambda e: with_steps(e, steps=np.ones((6, 3), np.int8)),
)
CASES.add(
    "GEOMETRY_ARRAY",
    base="fiber",
    quantised_curves_of_too_few_steps=lambda e: with_steps(e, steps=np.ones((5, 3), np.int16)),
    quantised_curves_of_too_few_origins=lambda e: with_steps(
        e, origins=np.zeros((2, 3), np.float32)
    ),
)
CASES.add(
    "GEOMETRY_STRANDS",
    base="fiber",
    quantised_curves_of_one_point=lambda e: with_steps(e, offsets=np.uint32([0, 4, 5, 9])),
    quantised_curves_that_go_back=lambda e: with_steps(e, offsets=np.uint32([0, 2**31, 4, 9])),
)
CASES.add(
    "GEOMETRY_STEPS",
    base="fiber",
    quantised_curves_of_no_step=lambda e: with_steps(e, scales=np.float32([0, 1e-4])),
    quantised_curves_of_steps_backwards=lambda e: with_steps(e, scales=np.float32([-1e-4, 1e-4])),
    quantised_curves_of_unknown_steps=lambda e: with_steps(e, scales=np.float32([np.nan, 1e-4])),
    quantised_curves_of_too_many_steps=lambda e: with_steps(
        e, steps=np.full((6, 3), 2**30, np.int32)
    ),
)
CASES.add(
    "GEOMETRY_SEGMENT",
    base="fiber",
    quantised_curves_that_stand_still=lambda e: with_steps(e, steps=np.zeros((6, 3), np.int16)),
)


@CASES.case("GEOMETRY_SEGMENT", "fiber")
def quantised_curves_of_steps_below_float32(entries: Entries) -> bytes:
    steps = np.ones((6, 3), np.int16)
    return with_steps(
        entries, origins=np.ones((3, 3), np.float32), steps=steps, scales=np.float32([1e-9, 1e-4])
    )


CASES.add(
    "GEOMETRY_RADIUS",
    base="fiber",
    quantised_curves_with_a_radius_of_zero=lambda e: with_steps(
        e, radii=np.uint8([9, 9, 9, 0, 9, 9, 9, 9, 9])
    ),
    quantised_curves_of_negative_radii=lambda e: with_steps(e, scales=np.float32([1e-4, -1e-4])),
)
CASES.add(
    "GEOMETRY_NOT_FINITE",
    base="fiber",
    quantised_curves_from_infinity=lambda e: with_steps(
        e, origins=np.float32([[np.inf, 0, 0]] * 3)
    ),
)
