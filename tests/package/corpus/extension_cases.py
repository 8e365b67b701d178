"""Packages whose extensions of the specification's text are wrong."""

from __future__ import annotations

import hashlib
import struct
import zlib
from typing import Any

import numpy as np

from rna_sdk.package.container.tensor_file import tensors_to_bytes
from rna_sdk.package.manifest.deflate import encode
from tests.package.builders import INPUTS, make_decoder
from tests.package.corpus.registry import (
    DECODER,
    MESH,
    PLANES,
    Entries,
    case,
    with_entry,
    with_manifest,
)

POSTER = "extensions/RNA_poster/poster.png"
LOBES = "extensions/RNA_environment/asset.onnx"
VISIBILITY = "extensions/RNA_environment/asset-visibility.safetensors"
TEXTURE = "extensions/RNA_standin_textures/asset.png"
PROXY = "extensions/RNA_proxy/asset-64.glb"
RED = "extensions/RNA_variants/red.png"


def used(manifest: dict[str, Any], name: str, data: Any, required: bool = False) -> None:
    """Declare the extension with its data."""
    manifest["extensionsUsed"] = [name]
    manifest["extensionsRequired"] = [name] if required else []
    manifest["extensions"] = {name: data}


def coding_of(data: bytes, **changes: Any) -> dict[str, Any]:
    digest = hashlib.sha256(data).hexdigest()
    return {"elementSize": 2, "distance": 3, "size": len(data), "sha256": digest} | changes


def with_coded_mesh(entries: Entries, stream: bytes | None = None, **changes: Any) -> bytes:
    """The package with its mesh coded, or with another stream, and with changes of the record."""
    coding = coding_of(entries[MESH], **changes)
    data = {"entries": {MESH: coding}}
    coded = encode(entries[MESH], 2, 3) if stream is None else stream
    return with_entry(entries, MESH, coded, lambda m: used(m, "RNA_deflate", data, True))


def with_poster(entries: Entries, png: bytes, **changes: Any) -> bytes:
    data = {"image": POSTER, "width": 2, "height": 1} | changes
    return with_entry(entries, POSTER, png, lambda m: used(m, "RNA_poster", data))


def with_proxy(entries: Entries, mesh: bytes, *levels: dict[str, Any]) -> bytes:
    data = {"parts": [list(levels) or [{"geometry": PROXY, "height": 64}]]}
    return with_entry(entries, PROXY, mesh, lambda m: used(m, "RNA_proxy", data))


def lobes_record(**changes: Any) -> dict[str, Any]:
    """Two lobes on the planes of the package."""
    return {
        **{"planes": PLANES, "decoder": LOBES, "inputs": list(INPUTS), "lobes": 2},
        **{"resolution": 8, "channels": 4},
        **{"planePrecision": "float16", "decoderPrecision": "float32"},
        **changes,
    }


def with_record(entries: Entries, **changes: Any) -> bytes:
    """The package with the record of lobes, and for their decoder that of transport."""
    data = {"parts": [lobes_record(**{"decoder": DECODER, **changes})]}
    return with_manifest(entries, lambda m: used(m, "RNA_environment", data))


def with_visibility(entries: Entries, harmonics: np.ndarray) -> bytes:
    """The package with lobes and a visibility about its vertices."""
    file = tensors_to_bytes({"harmonics": harmonics})
    data = {"parts": [lobes_record(visibility=VISIBILITY)]}
    decoder = make_decoder("float32", 18 + 16, outputs=18, output="environment")

    def declare(manifest: dict[str, Any]) -> None:
        digest = hashlib.sha256(decoder).hexdigest()
        manifest["entries"][LOBES] = {"size": len(decoder), "sha256": digest}
        used(manifest, "RNA_environment", data)

    return with_entry({**entries, LOBES: decoder}, VISIBILITY, file, declare)


def png_of(width: int, height: int) -> bytes:
    """The first bytes of a PNG."""
    return b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)


@case("DEFLATE_STREAM")
def coded_entry_of_no_stream(entries: Entries) -> bytes:
    return with_coded_mesh(entries, b"no zlib stream")


@case("DEFLATE_STREAM")
def coded_entry_cut_short(entries: Entries) -> bytes:
    return with_coded_mesh(entries, encode(entries[MESH], 2, 3)[:-9])


@case("DEFLATE_STREAM")
def coded_entry_with_bytes_behind(entries: Entries) -> bytes:
    return with_coded_mesh(entries, encode(entries[MESH], 2, 3) + b"more")


@case("DEFLATE_STREAM")
def coded_entry_that_goes_on_and_on(entries: Entries) -> bytes:
    return with_coded_mesh(entries, zlib.compress(bytes(2**26)))


@case("DEFLATE_STREAM")
def coded_entry_of_fewer_bytes(entries: Entries) -> bytes:
    return with_coded_mesh(entries, size=len(entries[MESH]) + 1)


@case("ENTRY_HASH")
def coded_entry_of_other_bytes(entries: Entries) -> bytes:
    return with_coded_mesh(entries, distance=4)


@case("FIELD_VALUE")
def coded_entry_of_three_bytes_an_element(entries: Entries) -> bytes:
    return with_coded_mesh(entries, elementSize=3)


@case("FIELD_VALUE")
def coded_entry_beyond_a_file(entries: Entries) -> bytes:
    return with_coded_mesh(entries, size=2**32)


@case("FIELD_VALUE")
def coded_entries_beyond_a_file_together(entries: Entries) -> bytes:
    codings = {name: coding_of(b"", size=2**31) for name in entries if name != "manifest.json"}
    data = {"entries": codings}
    return with_manifest(entries, lambda m: used(m, "RNA_deflate", data, True))


@case("DEFLATE_SIZE")
def coded_entry_of_zeros(entries: Entries) -> bytes:
    """Of 2 MiB in 2 KB: a small file would take much memory."""
    zeros = bytes(2**21)
    return with_coded_mesh(entries, zlib.compress(zeros), size=len(zeros), distance=0)


@case("EXTENSION_UNDECLARED")
def coded_entry_that_is_not_required(entries: Entries) -> bytes:
    data = {"entries": {MESH: coding_of(entries[MESH])}}
    coded = encode(entries[MESH], 2, 3)
    return with_entry(entries, MESH, coded, lambda m: used(m, "RNA_deflate", data))


@case("REFERENCE_MISSING")
def coded_entry_that_is_not_there(entries: Entries) -> bytes:
    data = {"entries": {"manifest.json": coding_of(b"")}}
    return with_manifest(entries, lambda m: used(m, "RNA_deflate", data, True))


@case("FIELD_MISSING")
def known_extension_without_data(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(extensionsUsed=["RNA_standin"]))


@case("POSTER_IMAGE")
def poster_that_is_no_png(entries: Entries) -> bytes:
    return with_poster(entries, b"JFIF")


@case("POSTER_IMAGE")
def poster_of_another_size(entries: Entries) -> bytes:
    return with_poster(entries, png_of(2, 2))


@case("FIELD_UNKNOWN")
def poster_with_a_title(entries: Entries) -> bytes:
    return with_poster(entries, png_of(2, 1), title="toy")


@case("PARTS_DIFFER")
def standin_of_two_parts(entries: Entries) -> bytes:
    material = {"baseColor": [1, 1, 1], "roughness": 1, "metallic": 0}
    data = {"parts": [material, material]}
    return with_manifest(entries, lambda m: used(m, "RNA_standin", data))


@case("FIELD_VALUE")
def standin_brighter_than_white(entries: Entries) -> bytes:
    material = {"baseColor": [1, 1, 1.5], "roughness": 1, "metallic": 0}
    return with_manifest(entries, lambda m: used(m, "RNA_standin", {"parts": [material]}))


@case("STANDIN_TEXTURE")
def standin_texture_that_is_no_png(entries: Entries) -> bytes:
    """Of 64 KB, which keeps it out of the conformance kit: other readers have no such textures."""
    members = dict.fromkeys(("baseColor", "metallicRoughness", "normal"), TEXTURE)
    data = {"parts": [members]}
    png = b"JFIF" * 16_384
    return with_entry(entries, TEXTURE, png, lambda m: used(m, "RNA_standin_textures", data))


@case("GEOMETRY_CONTAINER")
def proxy_that_is_no_mesh(entries: Entries) -> bytes:
    return with_proxy(entries, b"no mesh")


@case("FIELD_VALUE")
def proxies_that_ascend(entries: Entries) -> bytes:
    levels = [{"geometry": PROXY, "height": height} for height in (32, 64)]
    return with_proxy(entries, entries[MESH], *levels)


@case("FIELD_VALUE")
def proxy_of_no_part(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: used(m, "RNA_proxy", {"parts": [None]}))


@case("FIELD_VALUE")
def lobes_of_no_part(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: used(m, "RNA_environment", {"parts": [None]}))


@case("FIELD_VALUE")
def lobes_that_cannot_be_halved(entries: Entries) -> bytes:
    return with_record(entries, lobes=3)


@case("FIELD_VALUE")
def lobes_beyond_the_most(entries: Entries) -> bytes:
    return with_record(entries, lobes=34)


@case("PARTS_DIFFER")
def lobes_of_two_parts(entries: Entries) -> bytes:
    data = {"parts": [lobes_record(decoder=DECODER), None]}
    return with_manifest(entries, lambda m: used(m, "RNA_environment", data))


@case("REFERENCE_MISSING")
def lobes_on_planes_that_are_not_there(entries: Entries) -> bytes:
    return with_record(entries, planes="features/none.safetensors")


@case("PLANES_SHAPE")
def lobes_on_planes_of_another_size(entries: Entries) -> bytes:
    data = {"parts": [lobes_record(resolution=7)]}
    decoder = make_decoder("float32", 18, outputs=18, output="environment")
    return with_entry(entries, LOBES, decoder, lambda m: used(m, "RNA_environment", data))


@case("INPUT_KIND")
def lobes_of_a_surface_with_a_block_of_fibers(entries: Entries) -> bytes:
    return with_record(entries, inputs=["wo", "h"])


@case("DECODER_PROFILE")
def lobes_with_the_output_of_transport(entries: Entries) -> bytes:
    return with_record(entries)


@case("DECODER_PROFILE")
def lobes_without_the_columns_of_their_visibility(entries: Entries) -> bytes:
    file = tensors_to_bytes({"harmonics": np.zeros((12, 16), np.int8)})
    data = {"parts": [lobes_record(decoder=DECODER, visibility=VISIBILITY)]}
    return with_entry(entries, VISIBILITY, file, lambda m: used(m, "RNA_environment", data))


@case("ENVIRONMENT_VISIBILITY")
def visibility_with_a_vertex_missing(entries: Entries) -> bytes:
    return with_visibility(entries, np.zeros((11, 16), np.int8))


@case("ENVIRONMENT_VISIBILITY")
def visibility_up_to_degree_two(entries: Entries) -> bytes:
    return with_visibility(entries, np.zeros((12, 9), np.int8))


@case("FIELD_VALUE")
def proxy_of_a_part_with_base_colour(entries: Entries) -> bytes:
    def edit(manifest: dict[str, Any]) -> None:
        manifest["parts"][0]["baseColor"] = [{"triangles": [0, 1], "factor": [1, 0, 0]}]
        data = {"parts": [[{"geometry": PROXY, "height": 64}]]}
        used(manifest, "RNA_proxy", data)

    return with_entry(entries, PROXY, entries[MESH], edit)


def with_variants(entries: Entries, *variants: dict[str, Any], records: int = 1) -> bytes:
    """The package with these prints in the place of so many records of base colour."""
    colors = [{"triangles": [k, 1], "factor": [0.5, 0.5, 0.5]} for k in range(records)]

    def edit(manifest: dict[str, Any]) -> None:
        manifest["parts"][0]["baseColor"] = colors
        used(manifest, "RNA_variants", {"variants": list(variants)})

    return with_manifest(entries, edit)


@case("FIELD_VALUE")
def two_variants_of_one_name(entries: Entries) -> bytes:
    red = {"name": "red", "parts": [[{"factor": [1, 0, 0]}]]}
    return with_variants(entries, red, red)


@case("FIELD_VALUE")
def variant_without_a_name(entries: Entries) -> bytes:
    return with_variants(entries, {"name": "", "parts": [None]})


@case("FIELD_VALUE")
def variant_of_one_record_where_there_are_two(entries: Entries) -> bytes:
    variant = {"name": "red", "parts": [[{"factor": [1, 0, 0]}]]}
    return with_variants(entries, variant, records=2)


@case("FIELD_UNKNOWN")
def variant_with_triangles_of_its_own(entries: Entries) -> bytes:
    return with_variants(entries, {"name": "red", "parts": [[{"triangles": [0, 2]}]]})


@case("PARTS_DIFFER")
def variant_of_two_parts(entries: Entries) -> bytes:
    return with_variants(entries, {"name": "red", "parts": [None, None]})


@case("REFERENCE_MISSING")
def variant_whose_image_is_not_there(entries: Entries) -> bytes:
    return with_variants(entries, {"name": "red", "parts": [[{"image": RED}]]})


@case("BASE_COLOR_IMAGE")
def variant_whose_image_is_none(entries: Entries) -> bytes:
    def edit(manifest: dict[str, Any]) -> None:
        manifest["parts"][0]["baseColor"] = [{"triangles": [0, 1]}]
        variants = [{"name": "red", "parts": [[{"image": RED}]]}]
        used(manifest, "RNA_variants", {"variants": variants})

    return with_entry(entries, RED, b"none", edit)
