"""Packages in .glb files in scenes: the same pixels as from the .rna."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from rna_render.command.rna_run import main
from rna_render.command.terminal import tell_size
from rna_render.image.images import read_exr
from rna_render.scene import read_scene
from rna_render.world.scene_sources import check_files
from rna_sdk.errors import SceneError
from tests.package.carriers import changed, make_carrier
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package

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


def test_scenes_have_the_same_pixels(tmp_path: Path) -> None:
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


def test_a_carrier_alone_is_shown_as_a_package(tmp_path: Path) -> None:
    package = write_lambert_package(tmp_path / "ball.rna", sphere(2))
    carrier = make_carrier(package, tmp_path / "ball.glb")
    one, other = read_scene(package).scene, read_scene(carrier).scene
    assert other.camera == one.camera and other.assets[0].path.name == "ball.glb"


def test_a_glb_without_a_package_says_what_makes_one(tmp_path: Path) -> None:
    (tmp_path / "plain.glb").write_bytes(b"glTF")
    (tmp_path / "scene.yaml").write_text(SCENE.format(name="plain.glb"))
    with pytest.raises(SceneError, match=r"plain\.glb is a model, not a package; rna-make"):
        check_files(read_scene(tmp_path / "scene.yaml"))


def test_what_a_scene_shows_beside_its_package_is_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    package = write_lambert_package(tmp_path / "ball.rna", sphere(2))
    carrier = make_carrier(package, tmp_path / "ball.glb")
    forest = changed(carrier, tmp_path / "forest.glb", lambda d: d["nodes"].append({"mesh": 0}))
    note = "forest.glb is a scene; its package is shown once, and alone"
    for path in (carrier, forest):
        tell_size(path)
        assert (note in capsys.readouterr().err) == (path is forest)
