"""Packages each of whose manifests breaks one constraint of a schema: no member is unguarded."""

import hashlib
import json
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from rna_sdk.package.container.tensor_file import tensors_to_bytes
from rna_sdk.package.container.zip_container import MANIFEST_NAME
from rna_sdk.package.decoder.decoder_form import NEARBY_SETS
from rna_sdk.package.geometry.glb_reader import mesh_from_glb
from rna_sdk.package.geometry.source_vertices import SourceVertices
from rna_sdk.package.manifest.deflate import encode
from rna_sdk.package.manifest.extensions import HARMONICS
from tests.package.builders import make_decoder, make_tier, make_tiny_package, pack, read_entries
from tests.package.corpus.extension_cases import (
    LOBES,
    MIRROR,
    POSTER,
    PROXY,
    SOURCE,
    VISIBILITY,
    coding_of,
    lobes_record,
    png_of,
    used,
)
from tests.package.corpus.nearby_cases import GOOD
from tests.package.corpus.registry import DECODER, MESH, Base, Entries, tier_part
from tests.package.corpus.schema_walk import (
    Constraint,
    Json,
    Node,
    breaking,
    broken_constraints,
    constraints,
    nodes,
    replaced,
)

TEXTURE = "extensions/RNA_standin_textures/asset.png"

_MEASURED = {
    **{"psnr": 30.0, "flip": 0.1, "flipP95": 0.2, "relativeMse": 0.1, "images": 2},
    **{"definition": "-", "flipAtHeight": [{"height": 64, "flip": 0.1}]},
    "albedo": {"ratio": 1.0, "facing": 1.0, "at60": 1.0, "at80": 1.0},
}
_COST = {"multiplyAdds": 10, "nsPerQuery": 10.0, "threads": 2, "machine": "-"}
_AGREEMENT = {"maxAbsolute": 0.1, "maxRelative": 0.1}
_LOBES_MEASURED = {
    **{"environment": "sky", "psnr": 30.0, "psnrWithLights": 30.0, "flip": 0.1},
    "brightness": [1.0, 1.0, 1.0],
}
_WIDE = {"share": 0.25, "width": 0.5}
_CHANGE = {
    **{"colorSpace": "srgb", "factor": [1, 1, 1], "wrap": ["clamp", "clamp"]},
    "transform": [1, 0, 0, 0, 1, 0],
}

UNREACHED = {
    Constraint(("manifest",), "type"),
    *(Constraint(("manifest", "Domain", way, k), "type") for way in ("wo", "wi") for k in "01"),
    *(Constraint(("manifest", "Tier", "parts"), limit) for limit in ("minItems", "maxItems")),
}
"""Constraints without a case: the corpus has a manifest that is no object; a value of neither type
of two alternatives breaks none alone; a tier of too many parts has others than the package."""


def schema_cases(good: dict[Base, Entries], folder: Path) -> dict[str, tuple[bytes, Constraint]]:
    """By name: the bytes of a package, and the only constraint of the schemas that it breaks.

    folder: for files on the way.
    """
    tier = make_tier(inputs=("normal",), resolution=1, channels=1)
    least = read_entries(make_tiny_package(folder / "least.rna", tier))
    bases = [least, *good.values(), *_with_extensions(least), _with_prints(good["print"])]
    bases += [_with_nearby(least), _sampled(good["fiber"], forward=_WIDE, cone=[_WIDE])]
    bases.sort(key=_rank)
    found: dict[Constraint, bytes] = {}
    for entries in bases:
        manifest = json.loads(entries[MANIFEST_NAME])
        for node in nodes(manifest):
            for constraint, _ in constraints(node):
                is_new = constraint not in found and constraint not in UNREACHED
                broken = is_new and _broken(manifest, node, constraint)
                if broken:
                    found[constraint] = _packed(entries, broken)
    return {_name(constraint): (data, constraint) for constraint, data in sorted(found.items())}


def _rank(entries: Entries) -> tuple[bool, int]:
    """Small packages first; one that some readers may refuse for an extension last."""
    required = json.loads(entries[MANIFEST_NAME])["extensionsRequired"]
    return bool(required), sum(map(len, entries.values()))


def _broken(manifest: Json, node: Node, constraint: Constraint) -> Json | None:
    """The manifest with this constraint alone broken, if that can be."""
    for value in breaking(node, constraint):
        changed = replaced(manifest, node.path, value)
        if isinstance(changed, dict) and broken_constraints(changed) == {constraint}:
            return changed
    return None


def _name(constraint: Constraint) -> str:
    words = "-".join([*constraint.place, constraint.keyword, constraint.member]).strip("-")
    return "schema-" + re.sub(r"[^a-z0-9-]", "x", words.replace("*", "each").lower())


def _packed(entries: Entries, manifest: Json) -> bytes:
    text = json.dumps(manifest, separators=(",", ":"))
    return pack({**entries, MANIFEST_NAME: text.encode()}.items())


def _changed(
    entries: Entries, more: dict[str, bytes], edit: Callable[[dict[str, Any]], object]
) -> Entries:
    """With more or other entries, declared as they are, and an edited manifest."""
    manifest = json.loads(entries[MANIFEST_NAME])
    for name, data in more.items():
        digest = hashlib.sha256(data).hexdigest()
        manifest["entries"][name] = {"size": len(data), "sha256": digest}
    edit(manifest)
    return {**entries, **more, MANIFEST_NAME: json.dumps(manifest).encode()}


def _with_extensions(entries: Entries) -> Iterator[Entries]:
    """The package with all members of a tier, then with each extension that a surface may have."""

    def measured(manifest: dict[str, Any]) -> None:
        tier, cone = manifest["tiers"][0], {"axis": [0, 0, 1], "halfAngle": 1.0}
        tier |= {"validation": _MEASURED, "cost": _COST}
        tier["parts"][0]["agreement"] = _AGREEMENT
        manifest["domain"] = {"wo": [cone], "wi": [cone]}

    yield _changed(entries, {}, measured)
    mesh = entries[MESH]
    vertices = np.arange(len(mesh_from_glb(memoryview(mesh), MESH).positions), dtype=np.uint32)
    coded = {"entries": {MESH: coding_of(mesh)}}
    yield _extended(entries, "RNA_deflate", coded, {MESH: encode(mesh, 2, 3)}, True)
    poster = {"image": POSTER, "width": 2, "height": 1}
    yield _extended(entries, "RNA_poster", poster, {POSTER: png_of(2, 1)})
    material = {"baseColor": [1, 1, 1], "roughness": 1, "metallic": 0}
    yield _extended(entries, "RNA_standin", {"parts": [material]}, {})
    proxy = {"parts": [[{"geometry": PROXY, "height": 64}]]}
    yield _extended(entries, "RNA_proxy", proxy, {PROXY: mesh})
    yield _sampled(entries, cosine=0.4, mirror=[MIRROR])
    source = {"vertices": len(vertices), "parts": [SOURCE]}
    file = SourceVertices(vertices, len(vertices)).to_bytes()
    yield _extended(entries, "RNA_source", source, {SOURCE: file})
    record = lobes_record(resolution=1, channels=1, inputs=["normal"], agreement=_AGREEMENT)
    lobes = {"parts": [record | {"visibility": VISIBILITY}], "validation": [_LOBES_MEASURED]}
    harmonics = np.zeros((len(vertices), HARMONICS), np.int8)
    yield _extended(
        entries,
        "RNA_environment",
        lobes,
        {
            LOBES: make_decoder("float32", 3 + HARMONICS, outputs=18, output="environment"),
            VISIBILITY: tensors_to_bytes({"harmonics": harmonics}),
        },
    )


def _extended(
    entries: Entries, name: str, data: Json, more: dict[str, bytes], required: bool = False
) -> Entries:
    return _changed(entries, more, lambda manifest: used(manifest, name, data, required))


def _sampled(entries: Entries, **lobes: Any) -> Entries:
    """With one mixture of lobes for rays."""
    return _extended(entries, "RNA_sampling", {"parts": [[{"first": 0, **lobes}]]}, {})


def _with_nearby(entries: Entries) -> Entries:
    decoder = make_decoder("float32", 3, outputs=6 * NEARBY_SETS)
    return _changed(entries, {DECODER: decoder}, lambda m: tier_part(m).update(nearby=GOOD))


def _with_prints(entries: Entries) -> Entries:
    """Variants and textures for viewports."""
    parts = [dict.fromkeys(("baseColor", "metallicRoughness", "normal"), TEXTURE)]

    def edit(manifest: dict[str, Any]) -> None:
        records = manifest["parts"][0]["baseColor"]
        image = next(record["image"] for record in records if "image" in record)
        changes = [{**_CHANGE, "image": image}] * len(records)
        data = {
            "RNA_standin_textures": {"parts": parts},
            "RNA_variants": {"variants": [{"name": "red", "parts": [changes]}]},
        }
        manifest |= {"extensionsUsed": list(data), "extensions": data}

    return _changed(entries, {TEXTURE: png_of(2, 2)}, edit)
