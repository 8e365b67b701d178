"""RNA_standin_textures: pictures of a stand-in material in a package and in its .glb."""

import io
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from rna_sdk.errors import PackageError
from rna_sdk.package import Package, validate
from rna_sdk.package.command.rna_info import main as info
from rna_sdk.package.manifest.extensions import PartTextures
from rna_sdk.package.packing import Unpacked
from tests.package.builders import read_entries
from tests.package.carriers import opened
from tests.package.corpus.registry import with_manifest

MEMBERS = tuple(PartTextures.model_fields)


def png(side: int, value: int) -> bytes:
    file = io.BytesIO()
    Image.fromarray(np.full((side, side, 3), value, np.uint8)).save(file, format="PNG")
    return file.getvalue()


PICTURES = {member: png(2 + k, 40 * k) for k, member in enumerate(MEMBERS)}


@pytest.fixture
def textured(tiny, tmp_path):
    out = tmp_path / "textured.rna"
    Unpacked.read(tiny).with_standin_textures([PICTURES]).write(out)
    return out


def test_they_come_back_and_go_into_the_glb(textured, tiny, tmp_path):
    with Package.open(textured) as package:
        assert package.standin_textures() == PICTURES
        has_uvs = package.mesh().uvs is not None
    with Package.open(tiny) as package:
        assert package.standin_textures() is None
    assert has_uvs and validate(textured) == []
    glb = tmp_path / "textured.glb"
    assert info([str(textured), "--glb", str(glb)]) == 0
    document, blob = opened(glb)
    (material,) = document["materials"]
    surface = material["pbrMetallicRoughness"]
    named = (surface["baseColorTexture"], surface["metallicRoughnessTexture"])
    for member, texture in zip(MEMBERS, (*named, material["normalTexture"]), strict=True):
        image = document["images"][document["textures"][texture["index"]]["source"]]
        view = document["bufferViews"][image["bufferView"]]
        assert blob[view["byteOffset"] :][: view["byteLength"]] == PICTURES[member]
    assert "COLOR_0" not in document["meshes"][0]["primitives"][0]["attributes"]
    assert "baseColorFactor" not in surface


def edited(path: Path, edit: Any) -> bytes:
    def change(manifest: dict[str, Any]) -> None:
        edit(manifest["extensions"]["RNA_standin_textures"], manifest)

    return with_manifest(read_entries(path), change)


@pytest.mark.parametrize(
    ("edit", "code"),
    [
        (lambda data, _: data["parts"].append(None), "PARTS_DIFFER"),
        (lambda data, _: data.update(parts=[None]), "FIELD_VALUE"),
        (lambda data, _: data["parts"][0].pop("normal"), "FIELD_MISSING"),
        (lambda data, _: data["parts"][0].update(occlusion="a.png"), "FIELD_UNKNOWN"),
        (lambda data, _: data["parts"][0].update(normal="none.png"), "REFERENCE_MISSING"),
        (lambda data, _: data["parts"][0].update(normal="manifest.json"), "REFERENCE_MISSING"),
    ],
    ids=["two parts", "no part", "no normal", "another", "no entry", "the manifest"],
)
def test_wrong_data_is_refused(textured, tmp_path, edit, code):
    bad = tmp_path / "bad.rna"
    bad.write_bytes(edited(textured, edit))
    actual = [issue.code for issue in validate(bad)]
    assert code in actual


def test_what_is_no_picture_gets_a_warning(tiny, tmp_path):
    out = tmp_path / "bad.rna"
    wrong = {**PICTURES, "normal": b"no PNG"}
    Unpacked.read(tiny).with_standin_textures([wrong]).write(out)
    (issue,) = validate(out)
    assert (issue.code, issue.found) == ("STANDIN_TEXTURE", "no PNG")


def test_strands_and_textured_parts_have_none(tuft, tmp_path):
    with pytest.raises(PackageError, match="RNA_standin_textures of a fiber"):
        Unpacked.read(tuft).with_standin_textures([PICTURES]).write(tmp_path / "a.rna")
