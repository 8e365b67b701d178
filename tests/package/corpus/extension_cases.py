"""Packages whose extensions of the specification's text are wrong."""

import hashlib
import struct
import zlib
from typing import Any

import numpy as np

from rna_sdk.package.container.tensor_file import tensors_to_bytes
from rna_sdk.package.geometry.glb_reader import mesh_from_glb
from rna_sdk.package.geometry.source_vertices import SourceVertices
from rna_sdk.package.manifest.deflate import encode
from tests.package.builders import INPUTS, make_decoder
from tests.package.corpus.registry import (
    DECODER,
    MESH,
    PLANES,
    Corpus,
    Entries,
    in_manifest,
    with_entry,
    with_manifest,
)

CASES = Corpus("surface")


POSTER = "extensions/RNA_poster/poster.png"
LOBES = "extensions/RNA_environment/asset.onnx"
VISIBILITY = "extensions/RNA_environment/asset-visibility.safetensors"
TEXTURE = "extensions/RNA_standin_textures/asset.png"
PROXY = "extensions/RNA_proxy/asset-64.glb"
SOURCE = "extensions/RNA_source/asset.safetensors"
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


def with_source(entries: Entries, numbers: np.ndarray, count: int) -> bytes:
    """The package with numbers of a source's vertices."""
    data, file = {"vertices": count, "parts": [SOURCE]}, SourceVertices(numbers, count).to_bytes()
    return with_entry(entries, SOURCE, file, lambda m: used(m, "RNA_source", data))


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


@CASES.case("DEFLATE_STREAM")
def coded_entry_of_no_stream(entries: Entries) -> bytes:
    return with_coded_mesh(entries, b"no zlib stream")


CASES.add(
    "DEFLATE_STREAM",
    coded_entry_cut_short=lambda e: with_coded_mesh(e, encode(e[MESH], 2, 3)[:-9]),
    coded_entry_that_goes_on_and_on=lambda e: with_coded_mesh(e, zlib.compress(bytes(2**26))),
    coded_entry_of_fewer_bytes=lambda e: with_coded_mesh(e, size=len(e[MESH]) + 1),
)


@CASES.case("DEFLATE_STREAM")
def coded_entry_with_bytes_behind(entries: Entries) -> bytes:
    return with_coded_mesh(entries, encode(entries[MESH], 2, 3) + b"more")


def with_sampling(*firsts: int, **lobes: Any) -> Any:
    """A breaker that adds lobes for rays of the one part, the same from each triangle on."""
    mixtures = [{"first": first, **lobes} for first in firsts or (0,)]
    return in_manifest(lambda m: used(m, "RNA_sampling", {"parts": [mixtures]}))


MIRROR = {"share": 0.5, "width": 0.1}
CASES.add(
    "FIELD_VALUE",
    sampling_that_leaves_no_share=with_sampling(cosine=0.5, mirror=[MIRROR]),
    sampling_of_a_cone_on_a_surface=with_sampling(cone=[MIRROR]),
    sampling_of_a_lobe_without_width=with_sampling(mirror=[MIRROR | {"width": 0.0}]),
    sampling_that_descends=with_sampling(0, 2, 1, cosine=0.5),
)
CASES.add("FIELD_VALUE", "fiber", sampling_of_ranges_of_strands=with_sampling(0, 1, cone=[MIRROR]))
CASES.add(
    "PARTS_DIFFER",
    sampling_of_two_parts=in_manifest(
        lambda m: used(m, "RNA_sampling", {"parts": [[{"first": 0, "cosine": 0.5}]] * 2})
    ),
)
CASES.add("ENTRY_HASH", coded_entry_of_other_bytes=lambda e: with_coded_mesh(e, distance=4))
CASES.add(
    "FIELD_VALUE",
    coded_entry_of_three_bytes_an_element=lambda e: with_coded_mesh(e, elementSize=3),
    coded_entry_beyond_a_file=lambda e: with_coded_mesh(e, size=2**32),
    proxies_that_ascend=lambda e: with_proxy(
        e, e[MESH], *[{"geometry": PROXY, "height": height} for height in (32, 64)]
    ),
    proxy_of_no_part=in_manifest(lambda m: used(m, "RNA_proxy", {"parts": [None]})),
    lobes_of_no_part=in_manifest(lambda m: used(m, "RNA_environment", {"parts": [None]})),
    lobes_that_cannot_be_halved=lambda e: with_record(e, lobes=3),
    lobes_beyond_the_most=lambda e: with_record(e, lobes=34),
    variant_without_a_name=lambda e: with_variants(e, {"name": "", "parts": [None]}),
    variant_of_one_record_where_there_are_two=lambda e: with_variants(
        e, {"name": "red", "parts": [[{"factor": [1, 0, 0]}]]}, records=2
    ),
)


@CASES.case("FIELD_VALUE")
def coded_entries_beyond_a_file_together(entries: Entries) -> bytes:
    codings = {name: coding_of(b"", size=2**31) for name in entries if name != "manifest.json"}
    data = {"entries": codings}
    return with_manifest(entries, lambda m: used(m, "RNA_deflate", data, True))


@CASES.case("DEFLATE_SIZE")
def coded_entry_of_zeros(entries: Entries) -> bytes:
    """An entry of 2 MiB in 2 KB: a small file would take much memory."""
    zeros = bytes(2**21)
    return with_coded_mesh(entries, zlib.compress(zeros), size=len(zeros), distance=0)


@CASES.case("EXTENSION_UNDECLARED")
def coded_entry_that_is_not_required(entries: Entries) -> bytes:
    data = {"entries": {MESH: coding_of(entries[MESH])}}
    coded = encode(entries[MESH], 2, 3)
    return with_entry(entries, MESH, coded, lambda m: used(m, "RNA_deflate", data))


CASES.add(
    "REFERENCE_MISSING",
    coded_entry_that_is_not_there=in_manifest(
        lambda m: used(m, "RNA_deflate", {"entries": {"manifest.json": coding_of(b"")}}, True)
    ),
    lobes_on_planes_that_are_not_there=lambda e: with_record(e, planes="features/none.safetensors"),
    variant_whose_image_is_not_there=lambda e: with_variants(
        e, {"name": "red", "parts": [[{"image": RED}]]}
    ),
)
CASES.add(
    "FIELD_MISSING",
    known_extension_without_data=in_manifest(lambda m: m.update(extensionsUsed=["RNA_standin"])),
)
CASES.add(
    "POSTER_IMAGE",
    poster_that_is_no_png=lambda e: with_poster(e, b"JFIF"),
    poster_of_another_size=lambda e: with_poster(e, png_of(2, 2)),
)
CASES.add(
    "FIELD_UNKNOWN",
    poster_with_a_title=lambda e: with_poster(e, png_of(2, 1), title="toy"),
    variant_with_triangles_of_its_own=lambda e: with_variants(
        e, {"name": "red", "parts": [[{"triangles": [0, 2]}]]}
    ),
)


@CASES.case("PARTS_DIFFER")
def standin_of_two_parts(entries: Entries) -> bytes:
    material = {"baseColor": [1, 1, 1], "roughness": 1, "metallic": 0}
    data = {"parts": [material, material]}
    return with_manifest(entries, lambda m: used(m, "RNA_standin", data))


@CASES.case("FIELD_VALUE")
def standin_brighter_than_white(entries: Entries) -> bytes:
    material = {"baseColor": [1, 1, 1.5], "roughness": 1, "metallic": 0}
    return with_manifest(entries, lambda m: used(m, "RNA_standin", {"parts": [material]}))


@CASES.case("STANDIN_TEXTURE")
def standin_texture_that_is_no_png(entries: Entries) -> bytes:
    """64 KB keep it out of the conformance kit, since other readers have no such textures."""
    members = dict.fromkeys(("baseColor", "metallicRoughness", "normal"), TEXTURE)
    data = {"parts": [members]}
    png = b"JFIF" * 16_384
    return with_entry(entries, TEXTURE, png, lambda m: used(m, "RNA_standin_textures", data))


@CASES.case("GEOMETRY_INDEX")
def source_vertex_that_is_not_there(entries: Entries) -> bytes:
    count = len(mesh_from_glb(memoryview(entries[MESH]), MESH).positions)
    return with_source(entries, np.arange(count, dtype=np.uint32), count - 1)


@CASES.case("FIELD_VALUE", "fiber")
def source_vertices_of_strands(entries: Entries) -> bytes:
    return with_source(entries, np.zeros(1, np.uint32), 1)


@CASES.case("GEOMETRY_CONTAINER")
def proxy_that_is_no_mesh(entries: Entries) -> bytes:
    return with_proxy(entries, b"no mesh")


CASES.add(
    "PARTS_DIFFER",
    lobes_of_two_parts=in_manifest(
        lambda m: used(m, "RNA_environment", {"parts": [lobes_record(decoder=DECODER), None]})
    ),
    variant_of_two_parts=lambda e: with_variants(e, {"name": "red", "parts": [None, None]}),
)


@CASES.case("PLANES_SHAPE")
def lobes_on_planes_of_another_size(entries: Entries) -> bytes:
    data = {"parts": [lobes_record(resolution=7)]}
    decoder = make_decoder("float32", 18, outputs=18, output="environment")
    return with_entry(entries, LOBES, decoder, lambda m: used(m, "RNA_environment", data))


CASES.add(
    "INPUT_KIND",
    lobes_of_a_surface_with_a_block_of_fibers=lambda e: with_record(e, inputs=["wo", "h"]),
)
CASES.add("DECODER_PROFILE", lobes_with_the_output_of_transport=lambda e: with_record(e))


@CASES.case("DECODER_PROFILE")
def lobes_without_the_columns_of_their_visibility(entries: Entries) -> bytes:
    file = tensors_to_bytes({"harmonics": np.zeros((12, 16), np.int8)})
    data = {"parts": [lobes_record(decoder=DECODER, visibility=VISIBILITY)]}
    return with_entry(entries, VISIBILITY, file, lambda m: used(m, "RNA_environment", data))


CASES.add(
    "ENVIRONMENT_VISIBILITY",
    visibility_with_a_vertex_missing=lambda e: with_visibility(e, np.zeros((11, 16), np.int8)),
    visibility_up_to_degree_two=lambda e: with_visibility(e, np.zeros((12, 9), np.int8)),
)


@CASES.case("FIELD_VALUE")
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


@CASES.case("FIELD_VALUE")
def two_variants_of_one_name(entries: Entries) -> bytes:
    red = {"name": "red", "parts": [[{"factor": [1, 0, 0]}]]}
    return with_variants(entries, red, red)


@CASES.case("BASE_COLOR_IMAGE")
def variant_whose_image_is_none(entries: Entries) -> bytes:
    def edit(manifest: dict[str, Any]) -> None:
        manifest["parts"][0]["baseColor"] = [{"triangles": [0, 1]}]
        variants = [{"name": "red", "parts": [[{"image": RED}]]}]
        used(manifest, "RNA_variants", {"variants": variants})

    return with_entry(entries, RED, b"none", edit)
