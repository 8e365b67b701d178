"""Packages in .glb files in scenes: the same pixels as from the .rna."""

import json
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rna_render import load_world
from rna_render.command.rna_run import main
from rna_render.image.images import read_exr
from rna_render.materials.files.mesh_file import MeshFileWarning
from rna_render.scene import read_scene
from rna_render.scene.model_base import TransformModel
from rna_render.world import scene_sources
from rna_render.world.scene_sources import check_files
from rna_sdk.errors import SceneError
from rna_sdk.files.file_kinds import glass_of
from tests.package.carriers import Document, changed, make_carrier, opened, written
from tests.render.assets import merged, sphere
from tests.render.gltf_text import box_glb
from tests.render.packages import write_lambert_package, write_lamp_package

Change = Callable[[Document, bytearray], object]

SCENE = """
assets:
  - path: {name}
  - path: {name}
    transform: {{translation: [2.5, 0, 0], rotation_deg: [0, 40, 0]}}
camera: {{position: [1, 1, 9], look_at: [1, 0, 0]}}
lights: [{{type: directional, direction: [1, 1, 1], irradiance: 3}}]
resolution: [32, 20]
samples: 2
"""


def _rendered(scene: Path) -> dict[str, np.ndarray]:
    out = scene.with_suffix(".exr")
    assert main([str(scene), "--out", str(out)]) == 0
    return read_exr(out)[0]


def test_scenes_have_the_same_pixels(tmp_path):
    package = write_lambert_package(tmp_path / "ball.rna", sphere(2))
    carrier = make_carrier(package, tmp_path / "ball.glb")
    pixels = []
    for path in (package, carrier):
        scene = tmp_path / f"{path.suffix[1:]}.yaml"
        scene.write_text(SCENE.format(name=path.name))
        pixels.append(_rendered(scene))
    assert pixels[0].keys() == pixels[1].keys()
    for name, channel in pixels[0].items():
        assert channel.tobytes() == pixels[1][name].tobytes(), name


def test_a_carrier_alone_is_shown_as_a_package(tmp_path):
    package = write_lambert_package(tmp_path / "ball.rna", sphere(2))
    carrier = make_carrier(package, tmp_path / "ball.glb")
    one, other = read_scene(package).scene, read_scene(carrier).scene
    assert other.camera == one.camera and other.assets[0].path.name == "ball.glb"


def test_a_glb_without_a_package_says_what_makes_one(tmp_path):
    (tmp_path / "plain.glb").write_bytes(b"glTF")
    (tmp_path / "scene.yaml").write_text(SCENE.format(name="plain.glb"))
    with pytest.raises(SceneError, match=r"plain\.glb is a model, not a package; rna-make"):
        check_files(read_scene(tmp_path / "scene.yaml"))


IDENTITY = {"path": "ball.glb", "alone": True}


def _placed(**transform: Any) -> dict[str, Any]:
    return {**IDENTITY, "transform": transform}


def _again(**members: Any) -> Change:
    """Adds a second node with the package, which has a fallback of its own."""

    def change(document: Document, blob: bytearray) -> None:
        nodes = document["nodes"]
        fallback, carrier = ({**node} for node in nodes)
        nodes += [fallback, {**carrier, **members, "children": [len(nodes)]}]
        document["scenes"][0]["nodes"].append(len(nodes) - 1)

    return change


def _below(document: Document, blob: bytearray) -> None:
    """Turns the package by a node above it."""
    document["nodes"].append({**TURNED, "children": document["scenes"][0]["nodes"]})
    document["scenes"][0]["nodes"] = [len(document["nodes"]) - 1]


def _instanced(document: Document, blob: bytearray) -> None:
    """Two places for the node with the package, by EXT_mesh_gpu_instancing."""
    start, values = len(blob), [[0, 0, 0], [2, 0, 0], [0, 0, 0, 1], TURNED["rotation"], [1], [9]]
    blob += np.concatenate(values).astype("<f4").tobytes()
    document["buffers"][0]["byteLength"] = len(blob)
    attributes = {}
    kinds = ("TRANSLATION", "VEC3", 12), ("ROTATION", "VEC4", 16), ("_ID", "SCALAR", 4)
    for name, kind, size in kinds:
        view = {"buffer": 0, "byteOffset": start, "byteLength": 2 * size}
        document["bufferViews"].append(view)
        place = {"bufferView": len(document["bufferViews"]) - 1}
        document["accessors"].append({**place, "componentType": 5126, "count": 2, "type": kind})
        attributes[name] = len(document["accessors"]) - 1
        start += 2 * size
    record = {"attributes": attributes}
    document["nodes"][-1]["extensions"]["EXT_mesh_gpu_instancing"] = record


HALF = np.radians(40) / 2
TURNED = {"rotation": [0, float(np.sin(HALF)), 0, float(np.cos(HALF))], "translation": [2, 0, 0]}
TWICE = [IDENTITY, _placed(translation=[2, 0, 0], rotation_deg=[0, 40, 0])]
SCENES: dict[str, tuple[Change, list[dict[str, Any]]]] = {
    "moved": (lambda d, _: d["nodes"][-1].update(TURNED), TWICE[1:]),
    "below": (_below, TWICE[1:]),
    "twice": (_again(**TURNED), TWICE),
    "instanced": (_instanced, TWICE),
    "mirrored": (
        _again(scale=[-0.5, 0.5, 0.5], translation=[2, 0, 0]),
        [IDENTITY, _placed(translation=[2, 0, 0], rotation_deg=[180, 0, 0], scale=-0.5)],
    ),
}
"""What makes a scene of a .glb, and the entries of a scene file that are the same scene."""


@pytest.fixture
def carrier(tmp_path):
    """A ball with a smaller one beside it, so that it has no symmetry."""
    small = sphere(1, radius=0.5)
    beside = replace(small, positions=small.positions + np.float32([0.9, 0.4, 0.5]))
    package = write_lambert_package(tmp_path / "ball.rna", merged(sphere(2), beside))
    return make_carrier(package, tmp_path / "ball.glb")


def _scene(path: Path, assets: list[dict[str, Any]], **more: Any) -> Path:
    scene = {"assets": assets, **more}
    scene["camera"] = {"position": [1, 1, 9], "look_at": [1, 0, 0]}
    scene["lights"] = [{"type": "directional", "direction": [1, 1, 1], "irradiance": 3}]
    path.write_text(json.dumps({**scene, "resolution": [32, 20], "samples": 2}))
    return path


def _is_same_picture(one: Path, other: Path) -> None:
    pixels, expected = _rendered(one), _rendered(other)
    assert pixels.keys() == expected.keys()
    for name, channel in pixels.items():
        np.testing.assert_allclose(channel, expected[name], atol=1e-5, err_msg=name)


@pytest.mark.parametrize("name", SCENES)
def test_a_scene_in_a_glb_is_that_of_a_scene_file(name, carrier):
    """At each node with the package, and moved by the entry's own transform."""
    change, places = SCENES[name]
    glb = carrier.with_name("scene.glb")
    document, blob = opened(carrier)
    data = bytearray(blob)
    change(document, data)
    written(document, bytes(data), glb)
    actual = _scene(glb.with_name("a.yaml"), [{"path": "scene.glb"}])
    expected = _scene(glb.with_name("b.yaml"), places)
    _is_same_picture(actual, expected)
    # Alone it is the package in its own space, as it is for readers of one asset.
    alone = _scene(glb.with_name("c.yaml"), [{"path": "scene.glb", "alone": True}])
    _is_same_picture(alone, _scene(glb.with_name("d.yaml"), [IDENTITY]))
    shown = read_scene(glb).scene
    assert len(shown.assets) == len(places)


@pytest.mark.filterwarnings("ignore:.*not shown. RNA_relightable_asset")
@pytest.mark.parametrize("kind", ["assets", "objects"])
def test_what_is_mirrored_is_seen_in_a_mirror(kind, carrier):
    """Its picture is the flipped one under mirrored light."""
    pixels = []
    for name, transform, x in (("a", {"scale": -1, "rotation_deg": [180, 0, 0]}, 1), ("b", {}, -1)):
        path = _scene(carrier.with_name(f"{name}.yaml"), [])
        shown = {"path": "ball.glb", "transform": transform}
        scene = json.loads(path.read_text()) | {kind: [shown]}
        scene["camera"] = {"position": [0, 1, 6], "look_at": [0, 0, 0]}
        scene["lights"][0]["direction"][0] = x
        path.write_text(json.dumps({**scene, "samples": 256}))
        channels = _rendered(path)
        pixels.append(np.stack([channels[c] for c in "RGB"], axis=-1))
    assert np.abs(pixels[0] - pixels[1]).max() > 0.2
    np.testing.assert_allclose(pixels[0], pixels[1][:, ::-1], atol=0.05)


def _red_beside(document: Document, instancing: bool = False) -> None:
    """The fallback's mesh once more, in red, as an ordinary mesh with a parent."""
    red = {"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.1, 0.1, 1], "metallicFactor": 0}}
    document["materials"].append(red)
    primitive = {**document["meshes"][0]["primitives"][0], "material": 1}
    names = ("POSITION", "NORMAL")
    primitive["attributes"] = {name: primitive["attributes"][name] for name in names}
    document["meshes"].append({"primitives": [primitive]})
    count = len(document["nodes"])
    document["nodes"] += [
        {**document["nodes"][0], "mesh": 1},
        {"translation": [2, 0, 0], "children": [count]},
    ]
    document["scenes"][0]["nodes"].append(count + 1)


def test_meshes_beside_are_shown_with_their_materials(carrier):
    glb = changed(carrier, carrier.with_name("scene.glb"), _red_beside)
    move = {"translation": [-0.5, 0, 0], "rotation_deg": [0, 20, 0]}
    actual = _scene(glb.with_name("a.yaml"), [{"path": "scene.glb", "transform": move}])
    bare = changed(glb, glb.with_name("red.glb"), _without_package)
    objects = [{"path": bare.name, "transform": move}]
    expected = _scene(glb.with_name("b.yaml"), [_placed(**move)], objects=objects)
    _is_same_picture(actual, expected)
    (beside,) = read_scene(glb).scene.objects  # alone, and the camera sees both
    assert not beside.fallbacks and read_scene(glb).scene.camera.look_at[0] > 1


def _without_package(document: Document) -> None:
    document["scenes"][0]["nodes"].pop(0)
    for node in document["nodes"]:
        node.pop("extensions", None)


BROKEN: dict[str, tuple[Callable[[Document], object], str]] = {
    "uneven scale": (
        lambda d: d["nodes"][-1].update(scale=[1, 2, 1]),
        "a node with the package: found axes of 1, 2, 1; expected one scale, without shear",
    ),
    "flat": (lambda d: d["nodes"][-1].update(scale=[0, 0, 0]), "found axes of 0, 0, 0"),
    "in no scene": (lambda d: d["scenes"][0].update(nodes=[]), "no node of its scene carries"),
    "a ring of nodes": (lambda d: d["nodes"][0].update(children=[0]), ""),
    "children of text": (lambda d: d["scenes"][0].update(nodes="ab"), "cannot be read as .glb"),
    "a matrix of a camera": (
        lambda d: d["nodes"][-1].update(matrix=[1, 0, 0, 0.5, *np.eye(4)[1:].ravel()]),
        "a node's matrix ends with .0.5, 0.0, 0.0, 1.0.; expected",
    ),
    "a matrix of two": (lambda d: d["nodes"][-1].update(matrix=[1, 0]), "cannot reshape array"),
    "endless transform": (
        lambda d: d["nodes"][-1].update(translation=[1e30, 0, 0]),
        "transform has numbers that are not at most 1e[+]18",
    ),
    "far": (lambda d: d["nodes"][-1].update(scale=[1e9] * 3), r"found a scale of 1e\+09 and"),
    "a million instances": (
        lambda d: _instances(d, {"componentType": 5126, "count": 10**6, "type": "VEC3"}),
        "attributes of .1000000. items; expected one number, at most 100000",
    ),
    "no such node": (lambda d: d["scenes"][0].update(nodes=[1, -1]), "nodes has no item -1"),
    "no such scene": (lambda d: d.update(scene=-1), "scenes has no item -1"),
    "no instances": (
        lambda d: _instances(d, {"componentType": 5126, "count": 0, "type": "VEC3"}),
        "no node of its scene carries",
    ),
    "a list of instances": (
        lambda d: d["nodes"][-1]["extensions"].update(EXT_mesh_gpu_instancing={"attributes": [0]}),
        "a value has another type than it should",
    ),
    "instances without an accessor": (lambda d: _instances(d, None), "cannot be read as .glb"),
    "two counts": (
        lambda d: _instances(d, {"componentType": 5126, "count": 3, "type": "VEC3"}, _ID=0),
        "expected one number",
    ),
}
"""What breaks the nodes of a .glb, and the words of the line; no words: it is shown."""


def _instances(document: Document, accessor: dict[str, Any] | None, **more: int) -> None:
    if accessor is not None:
        document["accessors"].append(accessor)
    number = len(document["accessors"]) - (accessor is not None)
    record = {"attributes": {"TRANSLATION": number, **more}}
    document["nodes"][-1]["extensions"]["EXT_mesh_gpu_instancing"] = record


@pytest.mark.parametrize("name", BROKEN)
def test_nodes_that_cannot_be_placed_are_one_line(name, carrier, capsys):
    change, words = BROKEN[name]
    glb = changed(carrier, carrier.with_name("scene.glb"), change)
    scene = _scene(glb.with_name("scene.yaml"), [{"path": "scene.glb"}])
    status = main([str(scene), "--out", str(scene.with_suffix(".exr"))])
    lines = capsys.readouterr().err.splitlines()
    if words:
        assert status == 1 and len(lines) == 1
        assert re.search(rf"scene.yaml:1: assets\[0\].path: .*{words}", lines[0]), lines[0]
    else:
        assert status == 0


@pytest.mark.parametrize("name", ["flat", "uneven scale", "endless transform"])
def test_a_glb_that_cannot_be_placed_is_one_line(name, carrier, capsys):
    change, words = BROKEN[name]
    glb = changed(carrier, carrier.with_name("scene.glb"), change)
    assert main([str(glb), "--out", str(glb.with_suffix(".exr"))]) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert re.search(rf"scene.glb: .*{words}", line), line


def test_a_mesh_beside_that_is_endless_is_one_line(carrier, capsys):
    def change(document: Document) -> None:
        _red_beside(document)
        accessor = {**document["accessors"][0], "min": [-1e38] * 3, "max": [1e38] * 3}
        document["accessors"].append(accessor)
        attributes = document["meshes"][1]["primitives"][0]["attributes"]
        attributes["POSITION"] = len(document["accessors"]) - 1

    glb = changed(carrier, carrier.with_name("scene.glb"), change)
    assert main([str(glb), "--out", str(glb.with_suffix(".exr"))]) == 1
    for line in capsys.readouterr().err.splitlines():
        assert "scene.glb: camera." in line or "scene.glb: ground." in line


def test_glass_beside_a_glb_is_at_each_node(carrier):
    glb = carrier.with_name("scene.glb")
    document, blob = opened(carrier)
    _again(**TURNED)(document, bytearray())
    written(document, blob, glb)
    glass_of(glb).write_bytes(box_glb((3.0, 3.0, 3.0)))
    scene = read_scene(glb).scene
    assert [pane.path.name for pane in scene.objects] == ["scene.glass.glb"] * 2
    assert [pane.transform for pane in scene.objects] == [item.transform for item in scene.assets]
    glass_of(carrier).write_bytes(box_glb((3.0, 3.0, 3.0)))
    assert read_scene(carrier).scene.objects[0].transform == TransformModel()


def test_a_file_of_many_nodes_is_read_once(carrier, monkeypatch):
    def change(document: Document) -> None:
        document["nodes"] += [document["nodes"][-1] | {"children": []}] * 50
        document["scenes"][0]["nodes"] += range(2, 52)

    glb, read = changed(carrier, carrier.with_name("scene.glb"), change), []
    monkeypatch.setattr(scene_sources, "read_with", lambda path: read.append(path) or [])
    scene = read_scene(glb)
    assert len(scene.scene.assets) == 51
    assert scene_sources.files_of(scene) == [glb, glb] and read == [glb]


def test_the_fallback_is_shown_as_an_object(carrier):
    scene = _scene(carrier.with_name("scene.yaml"), [], objects=[{"path": "ball.glb"}])
    with pytest.warns(MeshFileWarning, match=r"not shown: .*RNA_relightable_asset"):
        load_world(read_scene(scene))


@pytest.mark.filterwarnings("ignore:.*not shown. RNA_relightable_asset")
@pytest.mark.parametrize("glow", [(6.0, 2.0, 0.5), (0.3, 0.4, 0.5)], ids=["strong", "weak"])
def test_the_fallback_shines_as_the_asset(glow, tmp_path):
    """In the dark, from above, where no pane is before the bulb; each channel within 2%."""
    package = write_lamp_package(tmp_path / "lamp.rna", glow, np.full(3, 128, np.uint8))
    carrier = make_carrier(package, tmp_path / "lamp.glb")
    document, _ = opened(carrier)
    strengths = [
        material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"]
        for material in document["materials"]
        if "extensions" in material
    ]
    assert strengths == ([pytest.approx(6.0)] if glow[0] > 1 else [])
    pictures = []
    for kind in ("assets", "objects"):
        scene = _scene(tmp_path / f"{kind}.yaml", [])
        values = json.loads(scene.read_text()) | {kind: [{"path": "lamp.glb"}], "lights": []}
        values["camera"] = {"position": [0.01, 1.5, 0], "look_at": [0, 0, 0]}
        scene.write_text(json.dumps({**values, "samples": 16, "max_depth": 1}))
        channels = _rendered(scene)
        pictures.append(np.stack([channels[name] for name in "RGB"], axis=-1))
    bulb = pictures[0].max(axis=2) > 0.99 * max(glow)
    assert bulb.sum() > 5
    np.testing.assert_allclose(pictures[1][bulb], pictures[0][bulb], rtol=0.02)
