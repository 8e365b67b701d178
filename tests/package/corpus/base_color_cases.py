"""Packages whose base colour or whose decoder of shadowed light is wrong."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from tests.package.builders import make_decoder, make_mesh
from tests.package.corpus.registry import (
    DECODER,
    MESH,
    Entries,
    case,
    part,
    tier_part,
    with_entry,
    with_manifest,
)
from tests.package.prints import LABEL, SHADOWED, STAMP, image_bytes

COLUMNS, COLUMNS_OF_SHADOWED = 16, 11


def with_record(entries: Entries, number: int = 0, **changes: Any) -> bytes:
    """The package with other members in a record of base colour."""
    return with_manifest(entries, lambda m: part(m)["baseColor"][number].update(changes))


def without(entries: Entries, names: Sequence[str], edit: Any) -> bytes:
    """The package without these entries, neither in the file nor in the manifest."""
    remaining = {name: data for name, data in entries.items() if name not in names}

    def drop(manifest: dict[str, Any]) -> None:
        edit(manifest)
        for name in names:
            manifest["entries"].pop(name)

    return with_manifest(remaining, drop)


@case("FIELD_UNKNOWN", "print")
def base_color_with_a_cutoff(entries: Entries) -> bytes:
    return with_record(entries, cutoff=0.5)


@case("FIELD_MISSING", "print")
def base_color_of_no_range(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: part(m)["baseColor"][2].pop("triangles"))


@case("FIELD_VALUE", "print")
def base_color_that_is_null(entries: Entries) -> bytes:
    return without(entries, (LABEL, STAMP), lambda m: part(m).update(baseColor=None))


@case("FIELD_VALUE", "print")
def no_records_of_base_color(entries: Entries) -> bytes:
    return without(entries, (LABEL, STAMP), lambda m: part(m).update(baseColor=[]))


@case("FIELD_VALUE", "print")
def too_many_records_of_base_color(entries: Entries) -> bytes:
    records = [{"triangles": [k, 1], "image": (LABEL, STAMP)[k % 2]} for k in range(65)]
    return with_manifest(entries, lambda m: part(m).update(baseColor=records))


@case("FIELD_VALUE", "print")
def base_color_of_no_triangles(entries: Entries) -> bytes:
    return with_record(entries, triangles=[0, 0])


@case("FIELD_VALUE", "print")
def base_color_of_an_image_that_is_null(entries: Entries) -> bytes:
    return with_record(entries, 2, image=None)


@case("FIELD_VALUE", "print")
def base_color_brighter_than_white(entries: Entries) -> bytes:
    return with_record(entries, factor=[0.5, 1.001, 0.5])


@case("FIELD_VALUE", "print")
def base_color_below_black(entries: Entries) -> bytes:
    return with_record(entries, factor=[0.5, 0.5, -0.001])


@case("FIELD_VALUE", "print")
def base_color_of_two_numbers(entries: Entries) -> bytes:
    return with_record(entries, factor=[0.5, 0.5])


@case("FIELD_VALUE", "print")
def base_color_of_unknown_space(entries: Entries) -> bytes:
    return with_record(entries, colorSpace="rec2020")


@case("FIELD_VALUE", "print")
def base_color_of_unknown_wrap(entries: Entries) -> bytes:
    return with_record(entries, wrap=["repeat", "border"])


@case("FIELD_VALUE", "print")
def base_color_of_one_wrap(entries: Entries) -> bytes:
    return with_record(entries, wrap=["repeat"])


@case("FIELD_VALUE", "print")
def base_color_of_five_numbers(entries: Entries) -> bytes:
    return with_record(entries, transform=[1, 0, 0, 0, 1])


@case("FIELD_VALUE", "print")
def base_color_beyond_all_coordinates(entries: Entries) -> bytes:
    return with_record(entries, transform=[1, 0, 0, 0, 1, -1.1e18])


@case("FIELD_VALUE", "parts")
def fibers_with_base_color(entries: Entries) -> bytes:
    record = {"triangles": [0, 1], "factor": [1, 1, 1]}
    return with_manifest(entries, lambda m: m["parts"][1].update(baseColor=[record]))


@case("FIELD_VALUE")
def base_color_used_that_is_not_there(entries: Entries) -> bytes:
    data = make_decoder("float32", 18, outputs=12)
    return with_entry(entries, DECODER, data, lambda m: tier_part(m).update(usesBaseColor=True))


@case("FIELD_VALUE", "print")
def use_of_base_color_that_is_null(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: tier_part(m).update(usesBaseColor=None))


@case("FIELD_VALUE", "print")
def use_of_base_color_that_is_a_number(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: tier_part(m).update(usesBaseColor=1))


@case("REFERENCE_MISSING", "print")
def base_color_from_nowhere(entries: Entries) -> bytes:
    remaining = {name: data for name, data in entries.items() if name != STAMP}
    return with_manifest(remaining, lambda m: m["entries"].pop(STAMP))


@case("BASE_COLOR_RANGE", "print")
def base_colors_that_overlap(entries: Entries) -> bytes:
    return with_record(entries, 1, triangles=[1, 1])


@case("BASE_COLOR_RANGE", "print")
def base_colors_that_descend(entries: Entries) -> bytes:
    def edit(manifest: dict[str, Any]) -> None:
        first, second, _ = part(manifest)["baseColor"]
        part(manifest)["baseColor"] = [second, first]

    return with_manifest(entries, edit)


@case("BASE_COLOR_RANGE", "print")
def base_color_past_the_mesh(entries: Entries) -> bytes:
    return with_record(entries, 2, triangles=[3, 2])


@case("BASE_COLOR_RANGE", "print")
def base_color_past_every_mesh(entries: Entries) -> bytes:
    return with_record(entries, 2, triangles=[2**53 - 1, 2**53 - 1])


@case("BASE_COLOR_IMAGE", "print")
def base_color_of_another_format(entries: Entries) -> bytes:
    return with_entry(entries, LABEL, image_bytes(np.zeros((2, 2), np.uint8), "GIF"))


@case("BASE_COLOR_IMAGE", "print")
def base_color_of_an_empty_file(entries: Entries) -> bytes:
    return with_entry(entries, LABEL, b"")


@case("BASE_COLOR_IMAGE", "print")
def base_color_of_half_a_header(entries: Entries) -> bytes:
    return with_entry(entries, LABEL, entries[LABEL][:20])


@case("BASE_COLOR_IMAGE", "print")
def base_color_too_wide(entries: Entries) -> bytes:
    return with_entry(entries, LABEL, image_bytes(np.zeros((1, 8193, 3), np.uint8)))


@case("BASE_COLOR_IMAGE", "print")
def base_color_too_high_in_jpeg(entries: Entries) -> bytes:
    return with_entry(entries, STAMP, image_bytes(np.zeros((8193, 1), np.uint8), "JPEG"))


@case("BASE_COLOR_IMAGE", "print")
def base_color_too_wide_in_webp(entries: Entries) -> bytes:
    return with_entry(entries, STAMP, image_bytes(np.zeros((1, 8193, 3), np.uint8), "WEBP"))


@case("BASE_COLOR_UV", "print")
def base_color_without_coordinates(entries: Entries) -> bytes:
    return with_entry(entries, MESH, mesh_to_glb(replace(make_mesh(), uvs=None)))


@case("DECODER_PROFILE", "print")
def decoder_without_factors(entries: Entries) -> bytes:
    return with_entry(entries, DECODER, make_decoder("float32", COLUMNS))


@case("DECODER_PROFILE", "print")
def decoder_with_factors_that_none_uses(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: tier_part(m).pop("usesBaseColor"))


@case("DECODER_PROFILE", "print")
def decoder_of_transport_beside_one_of_shadowed_light(entries: Entries) -> bytes:
    data = make_decoder("float32", COLUMNS, outputs=12)
    return with_entry(entries, "decoders/hq.onnx", data)


@case("DECODER_PROFILE", "print")
def decoder_of_shadowed_light_without_factors(entries: Entries) -> bytes:
    data = make_decoder("float32", COLUMNS_OF_SHADOWED, outputs=3, output="shadowed")
    return with_entry(entries, SHADOWED, data)


@case("DECODER_PROFILE", "print")
def decoder_of_visible_light_for_shadowed(entries: Entries) -> bytes:
    data = make_decoder("float32", COLUMNS_OF_SHADOWED, outputs=6, output="visible")
    return with_entry(entries, SHADOWED, data)


@case("DECODER_PROFILE", "print")
def one_decoder_for_visible_and_for_shadowed_light(entries: Entries) -> bytes:
    def edit(manifest: dict[str, Any]) -> None:
        record = manifest["tiers"][1]["parts"][0]
        record["shadowed"].update(decoder=record["decoder"], inputs=record["inputs"])

    return without(entries, (SHADOWED,), edit)


@case("INPUT_KIND", "print")
def shadowed_light_of_a_tangent(entries: Entries) -> bytes:
    inputs = ["features", "tangent", "wo", "wi"]
    return with_manifest(entries, lambda m: _shadowed(m).update(inputs=inputs))


@case("FIELD_VALUE", "print")
def shadowed_light_that_is_null(entries: Entries) -> bytes:
    def edit(manifest: dict[str, Any]) -> None:
        manifest["tiers"][1]["parts"][0]["shadowed"] = None

    return without(entries, (SHADOWED,), edit)


@case("FIELD_UNKNOWN", "print")
def shadowed_light_on_planes_of_its_own(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: _shadowed(m).update(planes="features/p.safetensors"))


@case("REFERENCE_MISSING", "print")
def shadowed_light_from_nowhere(entries: Entries) -> bytes:
    remaining = {name: data for name, data in entries.items() if name != SHADOWED}
    return with_manifest(remaining, lambda m: m["entries"].pop(SHADOWED))


def _shadowed(manifest: dict[str, Any]) -> dict[str, Any]:
    record: dict[str, Any] = manifest["tiers"][1]["parts"][0]["shadowed"]
    return record
