"""Packages whose normal maps are wrong."""

from dataclasses import replace
from typing import Any

import numpy as np

from rna_sdk.package.container.tensor_file import tensors_to_bytes
from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from tests.package.builders import make_mesh
from tests.package.corpus.registry import (
    MESH,
    Corpus,
    Entries,
    in_manifest,
    with_entry,
    with_manifest,
    without,
)
from tests.package.lantern import LEAF
from tests.package.relief import BARK, DENT

CASES = Corpus("relief")


def with_map(entries: Entries, number: int = 0, **changes: Any) -> bytes:
    """The package with other members in a record of a normal map."""
    return with_manifest(entries, lambda m: m["parts"][0]["normalMaps"][number].update(changes))


def with_texels(entries: Entries, texels: np.ndarray, name: str = "normals") -> bytes:
    return with_entry(entries, BARK, tensors_to_bytes({name: texels}))


CASES.add("FIELD_UNKNOWN", normal_map_with_a_cutoff=lambda e: with_map(e, cutoff=0.5))
CASES.add(
    "FIELD_MISSING",
    normal_map_of_no_range=in_manifest(lambda m: m["parts"][0]["normalMaps"][1].pop("triangles")),
)
CASES.add(
    "FIELD_VALUE",
    normal_maps_that_are_null=lambda e: without(
        e, BARK, DENT, edit=lambda m: m["parts"][0].update(normalMaps=None)
    ),
    no_records_of_normal_maps=lambda e: without(
        e, BARK, DENT, edit=lambda m: m["parts"][0].update(normalMaps=[])
    ),
    normal_map_of_no_triangles=lambda e: with_map(e, triangles=[0, 0]),
)


@CASES.case("FIELD_VALUE")
def too_many_normal_maps(entries: Entries) -> bytes:
    records = [{"triangles": [k, 1], "texture": (BARK, DENT)[k % 2]} for k in range(65)]
    return with_manifest(entries, lambda m: m["parts"][0].update(normalMaps=records))


CASES.add(
    "FIELD_VALUE",
    base="parts",
    fibers_with_normal_maps=in_manifest(
        lambda m: m["parts"][1].update(normalMaps=[{"triangles": [0, 1], "texture": LEAF}])
    ),
)


CASES.add(
    "REFERENCE_MISSING",
    normal_map_from_nowhere=lambda e: without(e, DENT),
)
CASES.add(
    "NORMAL_MAP_RANGE",
    normal_maps_that_overlap=lambda e: with_map(e, triangles=[2, 2]),
    normal_maps_that_descend=in_manifest(lambda m: m["parts"][0]["normalMaps"].reverse()),
    normal_map_past_the_mesh=lambda e: with_map(e, 1, triangles=[3, 2]),
    normal_map_past_every_mesh=lambda e: with_map(e, 1, triangles=[2**53 - 1, 2**53 - 1]),
)
CASES.add(
    "NORMAL_MAP_TEXTURE",
    normal_map_of_floats=lambda e: with_texels(e, np.zeros((2, 2, 2), np.float32)),
    normal_map_of_three_channels=lambda e: with_texels(e, np.zeros((2, 2, 3), np.uint8)),
    normal_map_of_one_channel=lambda e: with_texels(e, np.zeros((2, 2, 1), np.uint8)),
    normal_map_too_wide=lambda e: with_texels(e, np.zeros((1, 8193, 2), np.uint8)),
    normal_map_of_no_rows=lambda e: with_texels(e, np.zeros((0, 4, 2), np.uint8)),
    normal_map_of_another_name=lambda e: with_texels(
        e, np.zeros((2, 2, 2), np.uint8), "transmittance"
    ),
    normal_map_that_is_no_tensor_file=lambda e: with_entry(e, BARK, b"\x89PNG"),
    normal_map_cut_short=lambda e: with_entry(e, BARK, e[BARK][:-1]),
)
CASES.add(
    "NORMAL_MAP_UV",
    normal_map_without_coordinates=lambda e: with_entry(
        e, MESH, mesh_to_glb(replace(make_mesh(), uvs=None))
    ),
)
