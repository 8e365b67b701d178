"""Packages whose normal maps are wrong."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from rna_sdk.package.container.tensor_file import tensors_to_bytes
from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from tests.package.builders import make_mesh
from tests.package.corpus.registry import MESH, Entries, case, with_entry, with_manifest
from tests.package.lantern import LEAF
from tests.package.relief import BARK, DENT


def with_map(entries: Entries, number: int = 0, **changes: Any) -> bytes:
    """The package with other members in a record of a normal map."""
    return with_manifest(entries, lambda m: m["parts"][0]["normalMaps"][number].update(changes))


def with_texels(entries: Entries, texels: np.ndarray, name: str = "normals") -> bytes:
    return with_entry(entries, BARK, tensors_to_bytes({name: texels}))


@case("FIELD_UNKNOWN", "relief")
def normal_map_with_a_cutoff(entries: Entries) -> bytes:
    return with_map(entries, cutoff=0.5)


@case("FIELD_MISSING", "relief")
def normal_map_of_no_range(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["parts"][0]["normalMaps"][1].pop("triangles"))


@case("FIELD_VALUE", "relief")
def normal_maps_that_are_null(entries: Entries) -> bytes:
    return _without_maps(entries, lambda m: m["parts"][0].update(normalMaps=None))


@case("FIELD_VALUE", "relief")
def no_records_of_normal_maps(entries: Entries) -> bytes:
    return _without_maps(entries, lambda m: m["parts"][0].update(normalMaps=[]))


@case("FIELD_VALUE", "relief")
def too_many_normal_maps(entries: Entries) -> bytes:
    records = [{"triangles": [k, 1], "texture": (BARK, DENT)[k % 2]} for k in range(65)]
    return with_manifest(entries, lambda m: m["parts"][0].update(normalMaps=records))


@case("FIELD_VALUE", "relief")
def normal_map_of_no_triangles(entries: Entries) -> bytes:
    return with_map(entries, triangles=[0, 0])


@case("FIELD_VALUE", "parts")
def fibers_with_normal_maps(entries: Entries) -> bytes:
    record = {"triangles": [0, 1], "texture": LEAF}
    return with_manifest(entries, lambda m: m["parts"][1].update(normalMaps=[record]))


def _without_maps(entries: Entries, edit: Any) -> bytes:
    remaining = {name: data for name, data in entries.items() if name not in (BARK, DENT)}

    def drop(manifest: dict[str, Any]) -> None:
        edit(manifest)
        for name in (BARK, DENT):
            manifest["entries"].pop(name)

    return with_manifest(remaining, drop)


@case("REFERENCE_MISSING", "relief")
def normal_map_from_nowhere(entries: Entries) -> bytes:
    remaining = {name: data for name, data in entries.items() if name != DENT}
    return with_manifest(remaining, lambda m: m["entries"].pop(DENT))


@case("NORMAL_MAP_RANGE", "relief")
def normal_maps_that_overlap(entries: Entries) -> bytes:
    return with_map(entries, triangles=[2, 2])


@case("NORMAL_MAP_RANGE", "relief")
def normal_maps_that_descend(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["parts"][0]["normalMaps"].reverse())


@case("NORMAL_MAP_RANGE", "relief")
def normal_map_past_the_mesh(entries: Entries) -> bytes:
    return with_map(entries, 1, triangles=[3, 2])


@case("NORMAL_MAP_RANGE", "relief")
def normal_map_past_every_mesh(entries: Entries) -> bytes:
    return with_map(entries, 1, triangles=[2**53 - 1, 2**53 - 1])


@case("NORMAL_MAP_TEXTURE", "relief")
def normal_map_of_floats(entries: Entries) -> bytes:
    return with_texels(entries, np.zeros((2, 2, 2), np.float32))


@case("NORMAL_MAP_TEXTURE", "relief")
def normal_map_of_three_channels(entries: Entries) -> bytes:
    return with_texels(entries, np.zeros((2, 2, 3), np.uint8))


@case("NORMAL_MAP_TEXTURE", "relief")
def normal_map_of_one_channel(entries: Entries) -> bytes:
    return with_texels(entries, np.zeros((2, 2, 1), np.uint8))


@case("NORMAL_MAP_TEXTURE", "relief")
def normal_map_too_wide(entries: Entries) -> bytes:
    return with_texels(entries, np.zeros((1, 8193, 2), np.uint8))


@case("NORMAL_MAP_TEXTURE", "relief")
def normal_map_of_no_rows(entries: Entries) -> bytes:
    return with_texels(entries, np.zeros((0, 4, 2), np.uint8))


@case("NORMAL_MAP_TEXTURE", "relief")
def normal_map_of_another_name(entries: Entries) -> bytes:
    return with_texels(entries, np.zeros((2, 2, 2), np.uint8), "transmittance")


@case("NORMAL_MAP_TEXTURE", "relief")
def normal_map_that_is_no_tensor_file(entries: Entries) -> bytes:
    return with_entry(entries, BARK, b"\x89PNG")


@case("NORMAL_MAP_TEXTURE", "relief")
def normal_map_cut_short(entries: Entries) -> bytes:
    return with_entry(entries, BARK, entries[BARK][:-1])


@case("NORMAL_MAP_UV", "relief")
def normal_map_without_coordinates(entries: Entries) -> bytes:
    return with_entry(entries, MESH, mesh_to_glb(replace(make_mesh(), uvs=None)))
