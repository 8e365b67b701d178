"""Packages in .glb files in scenes: the same pixels as from the .rna."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rna_render import load_world
from rna_render.command.rna_run import main
from rna_render.command.terminal import tell_packages
from rna_render.image.images import read_exr
from rna_render.materials.files.mesh_file import MeshFileWarning
from rna_render.scene import read_scene
from rna_render.world.scene_sources import check_files
from rna_sdk.errors import SceneError
from rna_sdk.runtime import load
from tests.package.carriers import Document, changed, make_carrier
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


def _again(**members: Any) -> Callable[[Document], object]:
    """Adds a second node with the package."""
    return lambda d: d["nodes"].append({**d["nodes"][-1], "children": [], **members})


def _instanced(document: Document) -> None:
    """Seven places for the node with the package, by EXT_mesh_gpu_instancing."""
    document["accessors"].append({"componentType": 5126, "count": 7, "type": "VEC3"})
    attributes = {"attributes": {"TRANSLATION": len(document["accessors"]) - 1}}
    document["nodes"][-1]["extensions"]["EXT_mesh_gpu_instancing"] = attributes


SCENES: dict[str, Callable[[Document], object]] = {
    "beside.glb": lambda d: d["nodes"].append({"mesh": 0}),
    "twice.glb": _again(translation=[3, 0, 0]),
    "mirrored.glb": _again(scale=[-1, 1, 1]),
    "instanced.glb": _instanced,
}


@pytest.mark.parametrize("name", SCENES)
def test_a_scene_is_its_package_once_and_says_so(name, tmp_path, capsys):
    """Alone, and as an asset of a scene file; `load` takes the package."""
    package = write_lambert_package(tmp_path / "ball.rna", sphere(2))
    carrier = make_carrier(package, tmp_path / "ball.glb")
    path = changed(carrier, tmp_path / name, SCENES[name])
    scenes = tmp_path / "scene.yaml", tmp_path / "plain.yaml"
    for scene, of in zip(scenes, (path, carrier), strict=True):
        scene.write_text(SCENE.format(name=of.name))
    note = f"{name} is a scene; its package is shown once, and alone"
    for shown, expected in ((path, 1), (scenes[0], 1), (carrier, 0), (scenes[1], 0)):
        tell_packages(read_scene(shown))
        assert capsys.readouterr().err.count(note) == expected
    rows = np.random.default_rng(1).normal(size=(4, 50, 3)).astype(np.float32)
    for a, b in zip(load(path).evaluate(*rows), load(package).evaluate(*rows), strict=True):
        assert a.tobytes() == b.tobytes()
    as_object = SCENE.format(name=name).replace("assets:", "objects:")
    scenes[0].write_text(as_object)
    with pytest.warns(MeshFileWarning, match=r"not shown: .*RNA_relightable_asset"):
        load_world(read_scene(scenes[0]))
