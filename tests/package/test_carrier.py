"""RNA_relightable_asset: packages in .glb files, their bytes, fallbacks and refusals."""

import json
from pathlib import Path

import jsonschema
import numpy as np
import pytest

from rna_render.materials.files.mesh_file import MeshFileWarning, read_mesh_object
from rna_sdk.errors import PackageError, RnaError
from rna_sdk.files.file_kinds import kind_of, not_a
from rna_sdk.package import Package, validate
from rna_sdk.package.command import rna_info, rna_pack, rna_validate
from rna_sdk.package.gltf.carrier import EXTENSION
from rna_sdk.package.gltf.carrier_writer import with_package
from rna_sdk.package.gltf.fallback import VertexColors, glb_of
from rna_sdk.package.packing import Unpacked
from rna_sdk.runtime import load
from tests.conftest import REPOSITORY
from tests.package.carriers import (
    CHANGES,
    CUTS,
    HARMLESS,
    Document,
    changed,
    make_carrier,
    opened,
    written,
)

SCHEMA = REPOSITORY / "spec" / "schema" / f"node.{EXTENSION}.schema.json"
FOX = REPOSITORY / "examples" / "jade" / "fox.rna"
CURLS = REPOSITORY / "examples" / "fibers" / "curly_ball.rna"


@pytest.fixture(scope="module")
def carrier(tiny, tmp_path_factory):
    """A .glb with the good package; do not change it."""
    return make_carrier(tiny, tmp_path_factory.mktemp("carrier") / "tiny.glb")


def test_the_package_comes_back_bit_for_bit(carrier, tiny, tmp_path):
    with Package.open(carrier) as package:
        assert bytes(package.file_data) == tiny.read_bytes()
        assert package.file_bytes == tiny.stat().st_size
        address = np.frombuffer(package.file_data, np.uint8).ctypes.data
    assert address % 64 == 0 and carrier.read_bytes().index(tiny.read_bytes()) % 64 == 0
    assert validate(carrier) == []
    assert rna_pack.main([str(carrier), "--out", str(tmp_path / "again.rna")]) == 0
    assert (tmp_path / "again.rna").read_bytes() == tiny.read_bytes()


def test_answers_have_the_same_bits(carrier, tiny):
    rng = np.random.default_rng(1)
    rows = rng.normal(size=(4, 200, 3)).astype(np.float32)
    for a, b in zip(load(carrier).evaluate(*rows), load(tiny).evaluate(*rows), strict=True):
        assert a.tobytes() == b.tobytes()


def test_the_node_fits_the_schema(carrier):
    document, _ = opened(carrier)
    schema = json.loads(SCHEMA.read_bytes())
    record = document["nodes"][-1]["extensions"][EXTENSION]
    jsonschema.validate(record, schema)
    for wrong in ({**record, "package": -1}, {**record, "mimeType": "x"}, {"package": 0}):
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(wrong, schema)
    assert EXTENSION in document["extensionsUsed"]
    assert EXTENSION not in document.get("extensionsRequired", [])


def test_the_example_of_the_text_fits_the_schema():
    text = (REPOSITORY / "spec" / f"{EXTENSION}.md").read_text()
    example = json.loads(text.split("```json")[1].split("```")[0])
    records = [n["extensions"][EXTENSION] for n in example["nodes"] if "extensions" in n]
    assert len(records) == 2
    for record in records:
        jsonschema.validate(record, json.loads(SCHEMA.read_bytes()))


@pytest.mark.parametrize("package", [FOX, CURLS], ids=["fox", "curls"])
def test_the_fallback_takes_little(package):
    """Geometry of the package is not stored again; strands are fewer."""
    with Package.open(package) as of:
        colors = (
            {}
            if package is CURLS
            else {0: VertexColors(np.zeros((len(of.mesh().positions), 3), "f4"))}
        )
        assert len(glb_of(of, colors)) < 1.35 * package.stat().st_size


def test_the_fallback_is_geometry_of_the_package(carrier, tiny, tmp_path):
    """In place; beside the package, if that holds it in coded form."""
    coded = tmp_path / "coded.rna"
    Unpacked.read(tiny).deflated().write(coded)
    with Package.open(tiny) as package:
        mesh = package.mesh()
    for path in (carrier, make_carrier(coded, tmp_path / "coded.glb")):
        document, _ = opened(path)
        package_view, *views = document["bufferViews"]
        attributes = document["meshes"][0]["primitives"][0]["attributes"]
        place = views[document["accessors"][attributes["POSITION"]]["bufferView"] - 1]
        assert (place["byteOffset"] < package_view["byteLength"]) == (path is carrier)
        with pytest.warns(MeshFileWarning, match="RNA_relightable_asset"):
            shown = read_mesh_object(path)
        np.testing.assert_allclose(shown.positions, mesh.positions, atol=1e-6)
        np.testing.assert_array_equal(shown.triangles, mesh.triangles)


@pytest.mark.parametrize("name", CHANGES)
def test_a_broken_carrier_is_one_line(name, carrier, tmp_path, capsys):
    code, change = CHANGES[name]
    path = changed(carrier, tmp_path / "broken.glb", change)
    _is_refused(path, code, capsys)


@pytest.mark.parametrize("name", HARMLESS)
def test_an_odd_carrier_has_the_same_package(name, carrier, tmp_path):
    path = changed(carrier, tmp_path / "odd.glb", HARMLESS[name])
    with Package.open(path) as odd, Package.open(carrier) as good:
        assert bytes(odd.file_data) == bytes(good.file_data)


@pytest.mark.parametrize("name", CUTS)
def test_a_cut_carrier_is_one_line(name, carrier, tmp_path, capsys):
    path = tmp_path / "broken.glb"
    path.write_bytes(CUTS[name](carrier.read_bytes()))
    _is_refused(path, "GLB_CONTAINER", capsys)


def _is_refused(path: Path, code: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert [issue.code for issue in validate(path)] == [code]
    with pytest.raises(PackageError, match=code):
        load(path)
    assert rna_validate.main([str(path)]) == 1
    first, last = capsys.readouterr().out.splitlines()
    assert code in first and last.endswith("invalid")


def test_a_buffer_that_is_not_aligned_is_refused(carrier, tmp_path):
    document, blob = opened(carrier)
    text = json.dumps(document)
    padding = -(28 + len(text)) % 64 + 4
    (issue,) = validate(written(document, blob, tmp_path / "a.glb", padding))
    assert issue.code == "GLB_ALIGNMENT" and "of the file" in issue.found


@pytest.mark.parametrize(
    ("code", "change"),
    [
        ("GLB_DECLARATION", lambda d: d.pop("extensionsUsed")),
        ("GLB_DECLARATION", lambda d: d.update(extensionsUsed=5)),
        ("GLB_DECLARATION", lambda d: d.update(extensionsRequired=[EXTENSION])),
        ("GLB_FALLBACK", lambda d: d["nodes"][-1].pop("children")),
        ("GLB_FALLBACK", lambda d: d["nodes"].append({**d["nodes"][-1], "children": [0, 1]})),
    ],
)
def test_what_is_beside_the_package_is_a_warning(code, change, carrier, tmp_path):
    path = changed(carrier, tmp_path / "a.glb", change)
    assert [issue.code for issue in validate(path)] == [code]
    Package.open(path).close()


def test_several_nodes_of_one_package_are_instances(carrier, tmp_path, capsys):
    def change(document: Document) -> None:
        document["accessors"].append({"componentType": 5126, "count": 7, "type": "VEC3"})
        attributes = {"attributes": {"TRANSLATION": len(document["accessors"]) - 1}}
        again = {**document["nodes"][-1], "scale": [-1, 1, 1]}
        again["extensions"] = {**again["extensions"], "EXT_mesh_gpu_instancing": attributes}
        document["nodes"].append(again)

    path = changed(carrier, tmp_path / "many.glb", change)
    assert rna_info.main([str(path), "--json"]) == 0
    glb = json.loads(capsys.readouterr().out)["glb"]
    assert glb["instances"] == 8 and glb["fallback_meshes"] == 1


def test_info_says_what_carries_it(carrier, tiny, capsys):
    assert rna_info.main([str(carrier)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[1].startswith("carried by  a glTF of") and "1 mesh" in lines[1]
    assert rna_info.main([str(tiny)]) == 0
    assert "carried by" not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("flip", "shown"),
    [(0.274, ", FLIP 0.274"), (1, ", FLIP 1.000"), ("x", ""), (True, ""), (1e300, ""), (-1, "")],
)
def test_info_shows_the_error_of_the_fallback(flip, shown, carrier, tmp_path, capsys):
    def change(document: Document) -> None:
        document["nodes"][-1]["extensions"][EXTENSION]["fallbackFlip"] = flip

    assert rna_info.main([str(changed(carrier, tmp_path / "a.glb", change))]) == 0
    assert capsys.readouterr().out.splitlines()[1].endswith(f"its fallback: 1 mesh{shown}")


def test_a_package_is_put_back(carrier, tiny, tmp_path):
    """What a tool wrote again without the extension gets the package back; the rest stays."""
    document, blob = opened(carrier)
    document.pop("extensionsUsed")
    document["nodes"][-1].pop("extensions")
    document["nodes"][-1]["translation"] = [1, 2, 3]
    stripped = written(document, blob, tmp_path / "stripped.glb", 0)
    assert kind_of(stripped) == "model" and kind_of(carrier) == "package"
    out = tmp_path / "whole.glb"
    assert rna_info.main([str(tiny), "--glb", str(out), "--fallback", str(stripped)]) == 0
    assert validate(out) == []
    whole, _ = opened(out)
    assert whole["nodes"][:-1] == document["nodes"] and whole["meshes"] == document["meshes"]
    root = whole["nodes"][-1]
    assert root["children"] == document["scenes"][0]["nodes"] and "translation" not in root
    with Package.open(out) as package:
        assert bytes(package.file_data) == tiny.read_bytes()


@pytest.mark.parametrize("view", [0, 1, 999], ids=["gone", "other", "none"])
def test_an_extension_without_its_package_gets_it_back(view, carrier, tiny, tmp_path):
    """As after gltf-pipeline: the node keeps the extension, with the number of another view."""

    def drop(document: Document) -> None:
        document["bufferViews"][0]["byteLength"] = document["bufferViews"][0]["byteOffset"] = 64
        document["nodes"][-1]["extensions"][EXTENSION] |= {"package": view, "fallbackFlip": 0.1}

    left = changed(carrier, tmp_path / "left.glb", drop)
    assert [issue.code for issue in validate(left)] != []
    out = tmp_path / "whole.glb"
    assert rna_info.main([str(tiny), "--glb", str(out), "--fallback", str(left)]) == 0
    assert validate(out) == []
    whole, before = opened(out)[0], opened(left)[0]
    assert whole["extensionsUsed"] == before["extensionsUsed"]
    record = whole["nodes"][-1]["extensions"][EXTENSION]
    assert record["package"] == len(before["bufferViews"]) and "fallbackFlip" not in record
    assert len(whole["nodes"]) == len(before["nodes"])
    with Package.open(out) as package:
        assert bytes(package.file_data) == tiny.read_bytes()


def test_a_fallback_with_packages_is_refused(carrier, tiny, tmp_path):
    several = changed(carrier, tmp_path / "several.glb", CHANGES["two_packages"][1])
    cut = changed(carrier, tmp_path / "cut.glb", CHANGES["package_cut"][1])
    with Package.open(tiny) as package:
        for path in (several, cut):
            with pytest.raises(RnaError, match="carries a package; expected"):
                with_package(path, package)


def test_named_nodes_carry_the_package(carrier, tiny, tmp_path):
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0, 1, 2]}],
        "nodes": [{"name": "a", "scale": [-1, 1, 1]}, {"name": "a"}, {"name": "floor"}],
        "extensionsUsed": ["KHR_texture_basisu"],
    }
    path = written(document, b"", tmp_path / "scene.glb")
    with Package.open(tiny) as package:
        out = tmp_path / "out.glb"
        out.write_bytes(with_package(path, package, ["a"]))
        with pytest.raises(RnaError, match="no node 'b'; its nodes: a, a, floor"):
            with_package(path, package, ["b"])
        with pytest.raises(RnaError, match="carries a package"):
            with_package(carrier, package)
    whole, _ = opened(out)
    assert [EXTENSION in node.get("extensions", {}) for node in whole["nodes"]] == [
        True,
        True,
        False,
    ]
    assert whole["extensionsUsed"] == ["KHR_texture_basisu", EXTENSION]
    assert [issue.code for issue in validate(out)] == ["GLB_FALLBACK"] * 2


def test_files_that_cannot_be_a_fallback_are_one_line(tiny, tmp_path, capsys):
    for name, data in (("a.glb", b"no glTF"), ("b.gltf", b"{}")):
        (tmp_path / name).write_bytes(data)
    written({"scenes": [5], "bufferViews": []}, b"", tmp_path / "c.glb")
    written({"nodes": {}, "bufferViews": 7}, b"", tmp_path / "d.glb")
    for name in ("a.glb", "b.gltf", "c.glb", "d.glb", "none.glb"):
        arguments = [str(tiny), "--glb", str(tmp_path / "out.glb"), "--fallback"]
        assert rna_info.main([*arguments, str(tmp_path / name)]) == 1
        (line,) = [x for x in capsys.readouterr().err.splitlines() if x.startswith("error")]
        assert name in line
    assert not (tmp_path / "out.glb").exists()


def test_a_carrier_is_a_package_and_a_model(carrier):
    assert not_a("package", carrier) is None and not_a("model", carrier) is None
    assert "a package, not a scene" in str(not_a("scene", carrier))
