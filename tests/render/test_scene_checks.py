"""Checks of a scene beside its file: the files that it names, and whether it has light."""

import warnings
from pathlib import Path

import numpy as np
import pytest

from rna_render.paths.world_in_time import load_world
from rna_render.scene.scene_file import read_scene
from rna_render.world.world_loading import DarkWarning, warn_of_darkness
from rna_sdk.errors import SceneError
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package, write_lamp_package

CAMERA = "camera: {position: [0, 1, 4], look_at: [0, 0, 0]}\n"


def scene(folder: Path, text: str):
    path = folder / "scene.yaml"
    path.write_text(CAMERA + text)
    return read_scene(path)


@pytest.mark.parametrize(
    ("text", "where"),
    [
        ("ground: {}\nlights:\n  - type: environment\n    path: no.hdr\n", "5: lights[0].path"),
        ("ground:\n  material: {type: diffuse, texture: no.png}\n", "3: ground.material.texture"),
        ("objects:\n  - path: no.obj\n", "3: objects[0].path"),
        ("assets:\n  - path: no.rna\n", "3: assets[0].path"),
    ],
)
def test_a_missing_file_is_named_with_its_line(tmp_path, text, where):
    with pytest.raises(SceneError) as caught:
        load_world(scene(tmp_path, text))
    missing = tmp_path / text[text.index("no.") :].split("}")[0].strip()
    assert str(caught.value) == f"{tmp_path / 'scene.yaml'}:{where}: no such file: {missing}"


def test_a_model_given_as_an_asset_is_named(tmp_path):
    (tmp_path / "my helmet.glb").write_bytes(b"glTF")
    with pytest.raises(SceneError) as caught:
        load_world(scene(tmp_path, "assets:\n  - path: my helmet.glb\n"))
    assert "scene.yaml:3: assets[0].path: my helmet.glb is a model, not a package" in str(
        caught.value
    )
    assert f"rna-make '{tmp_path}/my helmet.glb' --out 'my helmet.rna'" in str(caught.value)


@pytest.mark.parametrize(
    ("text", "is_dark"),
    [
        ("", True),
        ("lights: [{type: point, position: [0, 9, 0], intensity: [0, 0, 0]}]\n", True),
        ("lights: [{type: environment, radiance: [0, 0, 0]}]\n", True),
        ("lights: [{type: sphere, position: [0, 9, 0], radius: 1, radiance: [0, 0, 0]}]\n", True),
        ("lights: [{type: point, position: [0, 9, 0], intensity: [0, 0, 1]}]\n", False),
        ("ground: {material: {type: diffuse, emission: [1, 0, 0]}}\n", False),
        ("assets: [{path: lamp.rna}]\n", False),
        ("assets: [{path: lamp.rna, emission: 0}]\n", True),
    ],
)
def test_a_scene_without_light_is_said_to_be_black(tmp_path, text, is_dark):
    write_lamp_package(tmp_path / "lamp.rna", (1, 1, 1), np.full(3, 255, np.uint8))
    write_lambert_package(tmp_path / "ball.rna", sphere(2))
    read = scene(tmp_path, text if "assets" in text else "assets: [{path: ball.rna}]\n" + text)
    world = load_world(read)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        warn_of_darkness(read.path, read.scene.lights, world)
    assert [w.category for w in caught] == [DarkWarning] * is_dark


def test_the_ground_has_its_size_or_no_end(tmp_path):
    for given, low, high in (("{}", 1e6, np.inf), ("{size: 7}", 6.999, 7.001)):
        plane = load_world(scene(tmp_path, f"ground: {given}\n")).objects[0]
        assert low < np.ptp(plane.positions[:, 0]) < high
