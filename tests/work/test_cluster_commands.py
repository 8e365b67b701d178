"""Commands on a cluster of three nodes: the same bits as on one machine."""

from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.rna_capture import main as capture
from rna_render.command.rna_run import main as render
from rna_sdk.motion import write_motion
from tests.exporters.scenes import write_scene
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package
from tests.render.test_sequence import SCENE

pytestmark = pytest.mark.filterwarnings("ignore")  # Ray's own, of its future versions

SETTINGS = (
    "--lights 128 --rays 64 --samples 1 --validation-views 1 --validation-resolution 24 "
    "--validation-samples 4 --seed 3"
).split()
TEXTURED = """
import bpy, os
here = os.path.dirname(__file__)
add(*BALL, principled(Roughness=float(open(os.path.join(here, "maps", "rough.txt")).read())))
"""


def contents(folder: Path) -> dict[str, bytes]:
    files = (path for path in sorted(folder.rglob("*")) if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


@pytest.mark.blender
def test_a_capture_has_the_same_bits(ray_address, tmp_path, monkeypatch):
    (tmp_path / "maps").mkdir()
    (tmp_path / "maps" / "rough.txt").write_text("0.3")
    source = write_scene(tmp_path, "ball", TEXTURED)
    here, there = tmp_path / "a" / "ball.rays", tmp_path / "b" / "ball.rays"
    for out in (here, there):
        out.parent.mkdir()
    assert capture([str(source), "--out", str(here), *SETTINGS]) == 0
    assert capture([str(source), "--out", str(there), *SETTINGS, "--cluster", ray_address]) == 0
    expected, actual = contents(here), contents(there)
    assert [name for name in actual if actual[name] != expected.get(name)] == []
    assert actual.keys() == expected.keys()
    assert len(list(there.glob("train/*"))) == 32


def test_frames_have_the_same_bits(ray_address, tmp_path):
    """Frames of a ball and of a ball in motion, whose file travels with the scene."""
    models, ball = tmp_path / "models", sphere(4)
    models.mkdir()
    write_lambert_package(models / "ball.rna", ball)
    moved = [[ball.positions * np.float32([1, 1 + k / 10, 1])] for k in range(4)]
    write_motion(models / "grow.rnam", [ball], moved, count=4, rate=24)
    scene = tmp_path / "scenes" / "scene.yaml"
    scene.parent.mkdir()
    still, name = "path: ../models/ball.rna", "motion: ../models/grow.rnam"
    where = "transform: {translation: [0.1, 0, 0], scale: 0.1}"
    both = f"{still}\n  - {still}\n    {name}\n    {where}"
    scene.write_text(SCENE.replace("path: ball.rna", both))
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
    common = [str(scene), "--frames", "all", "--out"]
    assert render([*common, str(tmp_path / "a" / "%d.exr")]) == 0
    assert render([*common, str(tmp_path / "b" / "%d.exr"), "--cluster", ray_address]) == 0
    assert len(contents(tmp_path / "b")) == 4
    assert contents(tmp_path / "b") == contents(tmp_path / "a")


def test_a_large_image_has_the_same_bits(ray_address, tmp_path):
    write_lambert_package(tmp_path / "ball.rna", sphere(4))
    scene = tmp_path / "scene.yaml"
    scene.write_text(SCENE.replace("[12, 8]", "[300, 200]"))
    one, other = tmp_path / "a.exr", tmp_path / "b.exr"
    assert render([str(scene), "--out", str(one)]) == 0
    assert render([str(scene), "--out", str(other), "--cluster", ray_address]) == 0
    assert one.read_bytes() == other.read_bytes()
