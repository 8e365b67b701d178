"""Packages of parts that are wrong: parts that differ, emission, holes and glass."""

from dataclasses import replace
from typing import Any

import numpy as np

from rna_sdk.package.container.tensor_file import tensors_to_bytes
from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from tests.package.builders import make_decoder, make_mesh
from tests.package.corpus.registry import (
    Corpus,
    Entries,
    in_manifest,
    with_entry,
    with_manifest,
    without,
)
from tests.package.lantern import GLOW, GLOW_COLUMNS, LEAF, MESH

CASES = Corpus("parts")


CASES.add(
    "KIND_UNSUPPORTED",
    part_of_unknown_kind=in_manifest(lambda m: m["parts"][1].update(kind="volume")),
)
CASES.add(
    "FIELD_UNKNOWN",
    bounds_beside_parts=in_manifest(lambda m: m.update(bounds=m["parts"][0]["bounds"])),
    tier_with_planes_beside_parts=in_manifest(
        lambda m: m["tiers"][0].update(planes="features/body.safetensors")
    ),
)
CASES.add(
    "FIELD_VALUE",
    emission_that_is_null=in_manifest(lambda m: m["tiers"][0]["parts"][1].update(emission=None)),
    fibers_with_holes=in_manifest(
        lambda m: m["parts"][1].update(transmittance=[{"triangles": [0, 1], "texture": LEAF}])
    ),
    cutoff_of_1=lambda e: with_record(e, cutoff=1.0),
    cutoff_that_is_null=lambda e: with_record(e, cutoff=None),
    index_of_refraction_of_0=lambda e: with_record(e, 1, ior=[1.5, 0]),
    record_of_no_triangles=lambda e: with_record(e, triangles=[0, 0]),
)
CASES.add(
    "BOUNDS_EMPTY",
    part_of_flat_bounds=in_manifest(lambda m: m["parts"][1]["bounds"]["max"].__setitem__(1, -1.0)),
)
CASES.add(
    "PART_DUPLICATE", two_parts_of_one_name=in_manifest(lambda m: m["parts"][1].update(name="body"))
)


@CASES.case("PARTS_DIFFER")
def tier_without_the_second_part(entries: Entries) -> bytes:
    names = ("features/hq-tuft.safetensors", "decoders/hq-tuft.onnx")
    return without(entries, *names, edit=lambda m: m["tiers"][1]["parts"].pop())


@CASES.case("PARTS_DIFFER")
def tier_that_does_not_emit(entries: Entries) -> bytes:
    name = "decoders/hq-body-glow.onnx"
    return without(entries, name, edit=lambda m: m["tiers"][1]["parts"][0].pop("emission"))


def with_emission(entries: Entries, **changes: Any) -> bytes:
    """The package with other members in the first tier's emission."""
    return with_manifest(entries, lambda m: m["tiers"][0]["parts"][0]["emission"].update(changes))


CASES.add(
    "INPUT_KIND",
    emission_of_a_light_direction=lambda e: with_emission(
        e, inputs=["features", "position", "normal", "wi"]
    ),
    emission_of_a_tangent=lambda e: with_emission(
        e, inputs=["features", "position", "tangent", "wo"]
    ),
)
CASES.add(
    "INPUT_UNKNOWN",
    emission_of_a_block_twice=lambda e: with_emission(e, inputs=["features", "wo", "normal", "wo"]),
)
CASES.add(
    "REFERENCE_MISSING",
    emission_from_nowhere=lambda e: without(e, GLOW),
)
CASES.add(
    "DECODER_PROFILE",
    emission_in_int8_that_is_not=lambda e: with_emission(e, decoderPrecision="int8"),
    emission_of_other_columns=lambda e: with_emission(e, inputs=["features", "wo"]),
    emission_decoder_that_gives_transport=lambda e: with_entry(
        e, GLOW, make_decoder("float32", GLOW_COLUMNS)
    ),
)
CASES.add(
    "GEOMETRY_OUTSIDE",
    second_part_outside_its_bounds=in_manifest(
        lambda m: m["parts"][1].update(bounds={"min": [-2, -2, -2], "max": [-1, -1, -1]})
    ),
)


def with_record(entries: Entries, number: int = 0, **changes: Any) -> bytes:
    """The package with other members in a record of transmittance."""
    return with_manifest(entries, lambda m: m["parts"][0]["transmittance"][number].update(changes))


@CASES.case("FIELD_VALUE")
def no_records_of_transmittance(entries: Entries) -> bytes:
    names = ("transmittance/leaf.safetensors", "transmittance/pane.safetensors")
    return without(entries, *names, edit=lambda m: m["parts"][0].update(transmittance=[]))


CASES.add(
    "TRANSMITTANCE_RANGE",
    records_that_overlap=lambda e: with_record(e, triangles=[2, 2]),
    records_that_descend=in_manifest(lambda m: m["parts"][0]["transmittance"].reverse()),
    record_past_the_mesh=lambda e: with_record(e, 1, triangles=[3, 2]),
    record_past_every_mesh=lambda e: with_record(e, 1, triangles=[2**53 - 1, 2**53 - 1]),
)


def with_texture(entries: Entries, texture: np.ndarray, name: str = "transmittance") -> bytes:
    return with_entry(entries, LEAF, tensors_to_bytes({name: texture}))


CASES.add(
    "TRANSMITTANCE_TEXTURE",
    texture_of_floats=lambda e: with_texture(e, np.zeros((2, 2, 1), np.float32)),
    texture_of_two_channels=lambda e: with_texture(e, np.zeros((2, 2, 2), np.uint8)),
    texture_without_a_channel_axis=lambda e: with_texture(e, np.zeros((2, 2), np.uint8)),
    texture_too_wide=lambda e: with_texture(e, np.zeros((1, 8193, 1), np.uint8)),
    texture_of_no_rows=lambda e: with_texture(e, np.zeros((0, 4, 1), np.uint8)),
    texture_of_another_name=lambda e: with_texture(e, np.zeros((2, 2, 1), np.uint8), "alpha"),
    texture_that_is_no_tensor_file=lambda e: with_entry(e, LEAF, b"\x89PNG"),
    texture_cut_short=lambda e: with_entry(e, LEAF, e[LEAF][:-1]),
    coloured_texture_with_a_cutoff=lambda e: with_record(e, 1, cutoff=0.5),
)
CASES.add(
    "TRANSMITTANCE_UV",
    texture_without_coordinates=lambda e: with_entry(
        e, MESH, mesh_to_glb(replace(make_mesh(), uvs=None))
    ),
)
