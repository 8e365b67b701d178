"""Packages whose base colour or whose decoder of shadowed light is wrong."""

import io
from dataclasses import replace
from typing import Any

import numpy as np
from PIL import Image

from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from tests.package.builders import make_decoder, make_mesh
from tests.package.corpus.registry import (
    DECODER,
    MESH,
    Corpus,
    Entries,
    in_manifest,
    part,
    tier_part,
    with_entry,
    with_manifest,
    without,
)
from tests.package.prints import LABEL, SHADOWED, STAMP, image_bytes

CASES = Corpus("print")


COLUMNS, COLUMNS_OF_SHADOWED = 16, 11


def with_record(entries: Entries, number: int = 0, **changes: Any) -> bytes:
    """The package with other members in a record of base colour."""
    return with_manifest(entries, lambda m: part(m)["baseColor"][number].update(changes))


CASES.add(
    "FIELD_UNKNOWN",
    base_color_with_a_cutoff=lambda e: with_record(e, cutoff=0.5),
    shadowed_light_on_planes_of_its_own=in_manifest(
        lambda m: _shadowed(m).update(planes="features/p.safetensors")
    ),
)
CASES.add(
    "FIELD_MISSING",
    base_color_of_no_range=in_manifest(lambda m: part(m)["baseColor"][2].pop("triangles")),
)
CASES.add(
    "FIELD_VALUE",
    base_color_that_is_null=lambda e: without(
        e, LABEL, STAMP, edit=lambda m: part(m).update(baseColor=None)
    ),
    no_records_of_base_color=lambda e: without(
        e, LABEL, STAMP, edit=lambda m: part(m).update(baseColor=[])
    ),
    base_color_of_no_triangles=lambda e: with_record(e, triangles=[0, 0]),
    base_color_of_an_image_that_is_null=lambda e: with_record(e, 2, image=None),
    base_color_brighter_than_white=lambda e: with_record(e, factor=[0.5, 1.001, 0.5]),
    base_color_below_black=lambda e: with_record(e, factor=[0.5, 0.5, -0.001]),
    base_color_of_two_numbers=lambda e: with_record(e, factor=[0.5, 0.5]),
    base_color_of_unknown_space=lambda e: with_record(e, colorSpace="rec2020"),
    base_color_of_unknown_wrap=lambda e: with_record(e, wrap=["repeat", "border"]),
    base_color_of_one_wrap=lambda e: with_record(e, wrap=["repeat"]),
    base_color_of_five_numbers=lambda e: with_record(e, transform=[1, 0, 0, 0, 1]),
    base_color_beyond_all_coordinates=lambda e: with_record(e, transform=[1, 0, 0, 0, 1, -1.1e18]),
    use_of_base_color_that_is_null=in_manifest(lambda m: tier_part(m).update(usesBaseColor=None)),
    use_of_base_color_that_is_a_number=in_manifest(lambda m: tier_part(m).update(usesBaseColor=1)),
)


@CASES.case("FIELD_VALUE")
def too_many_records_of_base_color(entries: Entries) -> bytes:
    records = [{"triangles": [k, 1], "image": (LABEL, STAMP)[k % 2]} for k in range(65)]
    return with_manifest(entries, lambda m: part(m).update(baseColor=records))


CASES.add(
    "FIELD_VALUE",
    base="parts",
    fibers_with_base_color=in_manifest(
        lambda m: m["parts"][1].update(baseColor=[{"triangles": [0, 1], "factor": [1, 1, 1]}])
    ),
)
CASES.add(
    "FIELD_VALUE",
    base="surface",
    base_color_used_that_is_not_there=lambda e: with_entry(
        e,
        DECODER,
        make_decoder("float32", 18, outputs=12),
        lambda m: tier_part(m).update(usesBaseColor=True),
    ),
)
CASES.add(
    "REFERENCE_MISSING",
    base_color_from_nowhere=lambda e: without(e, STAMP),
    shadowed_light_from_nowhere=lambda e: without(e, SHADOWED),
)
CASES.add(
    "BASE_COLOR_RANGE",
    base_colors_that_overlap=lambda e: with_record(e, 1, triangles=[1, 1]),
    base_color_past_the_mesh=lambda e: with_record(e, 2, triangles=[3, 2]),
    base_color_past_every_mesh=lambda e: with_record(e, 2, triangles=[2**53 - 1, 2**53 - 1]),
)


@CASES.case("BASE_COLOR_IMAGE")
def base_color_in_inks(entries: Entries) -> bytes:
    file = io.BytesIO()
    Image.new("CMYK", (2, 2)).save(file, "JPEG")
    return with_entry(entries, STAMP, file.getvalue())


@CASES.case("BASE_COLOR_RANGE")
def base_colors_that_descend(entries: Entries) -> bytes:
    def edit(manifest: dict[str, Any]) -> None:
        first, second, _ = part(manifest)["baseColor"]
        part(manifest)["baseColor"] = [second, first]

    return with_manifest(entries, edit)


CASES.add(
    "BASE_COLOR_IMAGE",
    base_color_of_another_format=lambda e: with_entry(
        e, LABEL, image_bytes(np.zeros((2, 2), np.uint8), "GIF")
    ),
    base_color_of_an_empty_file=lambda e: with_entry(e, LABEL, b""),
    base_color_of_half_a_header=lambda e: with_entry(e, LABEL, e[LABEL][:20]),
    base_color_too_wide=lambda e: with_entry(
        e, LABEL, image_bytes(np.zeros((1, 8193, 3), np.uint8))
    ),
    base_color_too_high_in_jpeg=lambda e: with_entry(
        e, STAMP, image_bytes(np.zeros((8193, 1), np.uint8), "JPEG")
    ),
    base_color_too_wide_in_webp=lambda e: with_entry(
        e, STAMP, image_bytes(np.zeros((1, 8193, 3), np.uint8), "WEBP")
    ),
)
CASES.add(
    "BASE_COLOR_UV",
    base_color_without_coordinates=lambda e: with_entry(
        e, MESH, mesh_to_glb(replace(make_mesh(), uvs=None))
    ),
)
CASES.add(
    "DECODER_PROFILE",
    decoder_without_factors=lambda e: with_entry(e, DECODER, make_decoder("float32", COLUMNS)),
    decoder_with_factors_that_none_uses=in_manifest(lambda m: tier_part(m).pop("usesBaseColor")),
)


@CASES.case("DECODER_PROFILE")
def decoder_of_transport_beside_one_of_shadowed_light(entries: Entries) -> bytes:
    data = make_decoder("float32", COLUMNS, outputs=12)
    return with_entry(entries, "decoders/hq.onnx", data)


@CASES.case("DECODER_PROFILE")
def decoder_of_shadowed_light_without_factors(entries: Entries) -> bytes:
    data = make_decoder("float32", COLUMNS_OF_SHADOWED, outputs=3, output="shadowed")
    return with_entry(entries, SHADOWED, data)


@CASES.case("DECODER_PROFILE")
def decoder_of_visible_light_for_shadowed(entries: Entries) -> bytes:
    data = make_decoder("float32", COLUMNS_OF_SHADOWED, outputs=6, output="visible")
    return with_entry(entries, SHADOWED, data)


@CASES.case("DECODER_PROFILE")
def one_decoder_for_visible_and_for_shadowed_light(entries: Entries) -> bytes:
    def edit(manifest: dict[str, Any]) -> None:
        record = manifest["tiers"][1]["parts"][0]
        record["shadowed"].update(decoder=record["decoder"], inputs=record["inputs"])

    return without(entries, SHADOWED, edit=edit)


CASES.add(
    "INPUT_KIND",
    shadowed_light_of_a_tangent=in_manifest(
        lambda m: _shadowed(m).update(inputs=["features", "tangent", "wo", "wi"])
    ),
)


@CASES.case("FIELD_VALUE")
def shadowed_light_that_is_null(entries: Entries) -> bytes:
    def edit(manifest: dict[str, Any]) -> None:
        manifest["tiers"][1]["parts"][0]["shadowed"] = None

    return without(entries, SHADOWED, edit=edit)


def _shadowed(manifest: dict[str, Any]) -> dict[str, Any]:
    record: dict[str, Any] = manifest["tiers"][1]["parts"][0]["shadowed"]
    return record
