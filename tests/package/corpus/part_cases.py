"""Packages of parts that are wrong: parts that differ, emission, holes and glass."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from rna_sdk.package.container.tensor_file import tensors_to_bytes
from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from tests.package.builders import make_decoder, make_mesh
from tests.package.corpus.registry import Entries, case, with_entry, with_manifest
from tests.package.lantern import GLOW, GLOW_COLUMNS, LEAF, MESH


@case("KIND_UNSUPPORTED", "parts")
def part_of_unknown_kind(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["parts"][1].update(kind="volume"))


@case("FIELD_UNKNOWN", "parts")
def bounds_beside_parts(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(bounds=m["parts"][0]["bounds"]))


@case("FIELD_UNKNOWN", "parts")
def tier_with_planes_beside_parts(entries: Entries) -> bytes:
    return with_manifest(
        entries, lambda m: m["tiers"][0].update(planes="features/body.safetensors")
    )


@case("FIELD_VALUE", "parts")
def emission_that_is_null(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["tiers"][0]["parts"][1].update(emission=None))


@case("BOUNDS_EMPTY", "parts")
def part_of_flat_bounds(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["parts"][1]["bounds"]["max"].__setitem__(1, -1.0))


@case("PART_DUPLICATE", "parts")
def two_parts_of_one_name(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["parts"][1].update(name="body"))


@case("PARTS_DIFFER", "parts")
def tier_without_the_second_part(entries: Entries) -> bytes:
    names = ("features/hq-tuft.safetensors", "decoders/hq-tuft.onnx")

    def edit(manifest: dict[str, Any]) -> None:
        manifest["tiers"][1]["parts"].pop()
        for name in names:
            manifest["entries"].pop(name)

    remaining = {name: data for name, data in entries.items() if name not in names}
    return with_manifest(remaining, edit)


@case("PARTS_DIFFER", "parts")
def tier_that_does_not_emit(entries: Entries) -> bytes:
    name = "decoders/hq-body-glow.onnx"

    def edit(manifest: dict[str, Any]) -> None:
        manifest["tiers"][1]["parts"][0].pop("emission")
        manifest["entries"].pop(name)

    return with_manifest({key: data for key, data in entries.items() if key != name}, edit)


def with_emission(entries: Entries, **changes: Any) -> bytes:
    """The package with other members in the first tier's emission."""
    return with_manifest(entries, lambda m: m["tiers"][0]["parts"][0]["emission"].update(changes))


@case("INPUT_KIND", "parts")
def emission_of_a_light_direction(entries: Entries) -> bytes:
    return with_emission(entries, inputs=["features", "position", "normal", "wi"])


@case("INPUT_KIND", "parts")
def emission_of_a_tangent(entries: Entries) -> bytes:
    return with_emission(entries, inputs=["features", "position", "tangent", "wo"])


@case("INPUT_UNKNOWN", "parts")
def emission_of_a_block_twice(entries: Entries) -> bytes:
    return with_emission(entries, inputs=["features", "wo", "normal", "wo"])


@case("REFERENCE_MISSING", "parts")
def emission_from_nowhere(entries: Entries) -> bytes:
    remaining = {name: data for name, data in entries.items() if name != GLOW}
    return with_manifest(remaining, lambda m: m["entries"].pop(GLOW))


@case("DECODER_PROFILE", "parts")
def emission_in_int8_that_is_not(entries: Entries) -> bytes:
    return with_emission(entries, decoderPrecision="int8")


@case("DECODER_PROFILE", "parts")
def emission_of_other_columns(entries: Entries) -> bytes:
    return with_emission(entries, inputs=["features", "wo"])


@case("DECODER_PROFILE", "parts")
def emission_decoder_that_gives_transport(entries: Entries) -> bytes:
    return with_entry(entries, GLOW, make_decoder("float32", GLOW_COLUMNS))


@case("GEOMETRY_OUTSIDE", "parts")
def second_part_outside_its_bounds(entries: Entries) -> bytes:
    box = {"min": [-2, -2, -2], "max": [-1, -1, -1]}
    return with_manifest(entries, lambda m: m["parts"][1].update(bounds=box))


def with_record(entries: Entries, number: int = 0, **changes: Any) -> bytes:
    """The package with other members in a record of transmittance."""
    return with_manifest(entries, lambda m: m["parts"][0]["transmittance"][number].update(changes))


@case("FIELD_VALUE", "parts")
def no_records_of_transmittance(entries: Entries) -> bytes:
    names = ("transmittance/leaf.safetensors", "transmittance/pane.safetensors")

    def edit(manifest: dict[str, Any]) -> None:
        manifest["parts"][0]["transmittance"] = []
        for name in names:
            manifest["entries"].pop(name)

    return with_manifest({key: data for key, data in entries.items() if key not in names}, edit)


@case("FIELD_VALUE", "parts")
def fibers_with_holes(entries: Entries) -> bytes:
    record = {"triangles": [0, 1], "texture": LEAF}
    return with_manifest(entries, lambda m: m["parts"][1].update(transmittance=[record]))


@case("FIELD_VALUE", "parts")
def cutoff_of_1(entries: Entries) -> bytes:
    return with_record(entries, cutoff=1.0)


@case("FIELD_VALUE", "parts")
def cutoff_that_is_null(entries: Entries) -> bytes:
    return with_record(entries, cutoff=None)


@case("FIELD_VALUE", "parts")
def index_of_refraction_of_0(entries: Entries) -> bytes:
    return with_record(entries, 1, ior=[1.5, 0])


@case("FIELD_VALUE", "parts")
def record_of_no_triangles(entries: Entries) -> bytes:
    return with_record(entries, triangles=[0, 0])


@case("TRANSMITTANCE_RANGE", "parts")
def records_that_overlap(entries: Entries) -> bytes:
    return with_record(entries, triangles=[2, 2])


@case("TRANSMITTANCE_RANGE", "parts")
def records_that_descend(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["parts"][0]["transmittance"].reverse())


@case("TRANSMITTANCE_RANGE", "parts")
def record_past_the_mesh(entries: Entries) -> bytes:
    return with_record(entries, 1, triangles=[3, 2])


@case("TRANSMITTANCE_RANGE", "parts")
def record_past_every_mesh(entries: Entries) -> bytes:
    return with_record(entries, 1, triangles=[2**53 - 1, 2**53 - 1])


def with_texture(entries: Entries, texture: np.ndarray, name: str = "transmittance") -> bytes:
    return with_entry(entries, LEAF, tensors_to_bytes({name: texture}))


@case("TRANSMITTANCE_TEXTURE", "parts")
def texture_of_floats(entries: Entries) -> bytes:
    return with_texture(entries, np.zeros((2, 2, 1), np.float32))


@case("TRANSMITTANCE_TEXTURE", "parts")
def texture_of_two_channels(entries: Entries) -> bytes:
    return with_texture(entries, np.zeros((2, 2, 2), np.uint8))


@case("TRANSMITTANCE_TEXTURE", "parts")
def texture_without_a_channel_axis(entries: Entries) -> bytes:
    return with_texture(entries, np.zeros((2, 2), np.uint8))


@case("TRANSMITTANCE_TEXTURE", "parts")
def texture_too_wide(entries: Entries) -> bytes:
    return with_texture(entries, np.zeros((1, 8193, 1), np.uint8))


@case("TRANSMITTANCE_TEXTURE", "parts")
def texture_of_no_rows(entries: Entries) -> bytes:
    return with_texture(entries, np.zeros((0, 4, 1), np.uint8))


@case("TRANSMITTANCE_TEXTURE", "parts")
def texture_of_another_name(entries: Entries) -> bytes:
    return with_texture(entries, np.zeros((2, 2, 1), np.uint8), "alpha")


@case("TRANSMITTANCE_TEXTURE", "parts")
def texture_that_is_no_tensor_file(entries: Entries) -> bytes:
    return with_entry(entries, LEAF, b"\x89PNG")


@case("TRANSMITTANCE_TEXTURE", "parts")
def texture_cut_short(entries: Entries) -> bytes:
    return with_entry(entries, LEAF, entries[LEAF][:-1])


@case("TRANSMITTANCE_TEXTURE", "parts")
def coloured_texture_with_a_cutoff(entries: Entries) -> bytes:
    return with_record(entries, 1, cutoff=0.5)


@case("TRANSMITTANCE_UV", "parts")
def texture_without_coordinates(entries: Entries) -> bytes:
    return with_entry(entries, MESH, mesh_to_glb(replace(make_mesh(), uvs=None)))
