"""The scene of a package that is shown without a scene file."""

import numpy as np
import pytest
import yaml

from rna_render.command.rna_run import main
from rna_render.image.images import read_exr
from rna_render.scene.scene_file import read_scene
from rna_render.scene.scene_model import Scene
from rna_render.scene.scene_of_package import (
    _NOTES,
    Shown,
    default_scene,
    scene_text,
    scene_values,
    shown,
)
from rna_sdk.commands.size_note import size_note
from rna_sdk.errors import PackageError, SceneError
from rna_sdk.files.file_kinds import glass_of
from rna_sdk.package import Cone, Package
from tests.render.assets import sphere, square
from tests.render.gltf_text import box_glb
from tests.render.packages import write_lambert_package, write_lamp_package

CUBE = np.array([-1.0, -1.0, -1.0]), np.array([1.0, 1.0, 1.0])
SLAB = np.array([-3.0, 0.0, -0.1]), np.array([3.0, 0.2, 0.1])
TOWER = np.array([-0.1, 0.0, -0.1]), np.array([0.1, 5.0, 0.1])


def scene_of(of: Shown) -> Scene:
    return Scene.model_validate(yaml.safe_load(scene_text(scene_values(of, "it.rna"))))


@pytest.mark.parametrize("scale", [1e-4, 1.0, 3e4])
@pytest.mark.parametrize("box", [CUBE, SLAB, TOWER], ids=["cube", "slab", "tower"])
@pytest.mark.parametrize("wo", [(), (Cone(axis=(0, 1, 0), half_angle=0.1),)], ids=["all", "top"])
def test_the_asset_fills_the_image_at_any_size(box, scale, wo):
    low, high = (scale * np.add(corner, [7.0, -2.0, 0.0]) for corner in box)
    corners = np.array(np.meshgrid(*zip(low, high, strict=True))).reshape(3, -1).T
    scene = scene_of(Shown(low, high, corners, wo=wo))
    origin, pixels = np.array(scene.camera.position), []
    for corner in corners:
        pixels.append(pixel_of(scene, corner - origin))
    reach = np.abs(2 * np.array(pixels) - 1)  # from the middle of the image to its edge: 0 to 1
    assert 0.75 < reach.max() < 0.9
    if not wo:
        assert scene.ground is not None
        assert low[1] - 0.01 * np.linalg.norm(high - low) < scene.ground.height < low[1]


def pixel_of(scene: Scene, ray: np.ndarray) -> tuple[float, float]:
    """Place of a ray from the eye, as shares of the image's width and height."""
    forward = np.subtract(scene.camera.look_at, scene.camera.position)
    forward /= np.linalg.norm(forward)
    side = np.cross(forward, scene.camera.up)
    side /= np.linalg.norm(side)
    half = np.tan(np.radians(scene.camera.vertical_fov_deg / 2)) * (ray @ forward)
    width, height = scene.resolution
    across = (ray @ side) / (half * width / height), (ray @ np.cross(side, forward)) / half
    return (across[0] + 1) / 2, (across[1] + 1) / 2


def test_directions_are_those_that_it_was_captured_for():
    axis = (0.6, 0.0, -0.8)
    cones = (Cone(axis=axis, half_angle=0.2),)
    scene = scene_of(Shown(*CUBE, np.array(CUBE), wo=cones, wi=cones))
    eye = np.array(scene.camera.position) / np.linalg.norm(scene.camera.position)
    np.testing.assert_allclose(eye, axis, atol=1e-3)
    assert {light.type for light in scene.lights} == {"directional"}
    for light in scene.lights:
        np.testing.assert_allclose(light.direction, axis, atol=1e-3)


def test_light_is_dimmed_beside_an_asset_of_its_own_light(tmp_path):
    dark = write_lambert_package(tmp_path / "dark.rna", sphere(2))
    glowing = write_lamp_package(tmp_path / "glowing.rna", (1, 1, 1), np.full(3, 255, np.uint8))
    assert (shown(dark).emits, shown(glowing).emits) == (False, True)
    key, dimmed = (read_scene(path).scene.lights[0].irradiance[0] for path in (dark, glowing))
    assert dimmed < 0.3 * key


def test_a_package_is_rendered_alone(tmp_path, capsys):
    package = write_lambert_package(tmp_path / "a: 'ball'.rna", sphere(3))
    small = ["--resolution", "32x24", "--samples", "2"]
    assert main([str(package), "--png", str(tmp_path / "a.png"), *small]) == 0
    assert main([str(package), "--out", str(tmp_path / "b.png"), *small]) == 0
    assert main([str(package), "--out", str(tmp_path / "c.exr"), *small]) == 0
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        *("a.png", package.name, "b.png", "c.exr")
    ]
    channels, _ = read_exr(tmp_path / "c.exr")
    asset, ground = ((channels["assetId"] == n).mean() for n in (1, 2))
    assert 0.2 < asset < 0.6 and asset + ground == 1.0
    assert 0.05 < np.median(channels["G"]) < 1.0
    assert f"wrote {tmp_path / 'a.png'}" in capsys.readouterr().out


def test_it_is_what_the_text_says(tmp_path):
    package = write_lambert_package(tmp_path / "ball.rna", sphere(2))
    text = scene_text(default_scene(package))
    assert all(f"# {note}" in text for note in _NOTES.values())
    (tmp_path / "scene.yaml").write_text(text)
    assert read_scene(tmp_path / "scene.yaml").scene == read_scene(package).scene


def test_a_turntable_needs_no_scene_file(tmp_path):
    package = write_lambert_package(tmp_path / "ball.rna", sphere(2))
    out = ["--png", str(tmp_path / "f.%02d.png"), "--resolution", "16x12", "--samples", "1"]
    assert main([str(package), *out, "--frames", "0-1"]) == 0
    assert {"f.00.png", "f.01.png"} <= {path.name for path in tmp_path.iterdir()}


def test_a_model_and_a_broken_package_are_named(tmp_path, capsys):
    (tmp_path / "helmet.glb").write_bytes(b"glTF")
    (tmp_path / "broken.rna").write_bytes(b"PK")
    with pytest.raises(SceneError, match=r"a model, not a scene; rna-make .*helmet\.glb --out"):
        read_scene(tmp_path / "helmet.glb")
    with pytest.raises(PackageError):
        read_scene(tmp_path / "broken.rna")
    with pytest.raises(SceneError, match=r"none\.rna: No such file"):
        read_scene(tmp_path / "none.rna")


def test_an_error_has_no_line_of_a_file_that_nobody_wrote(tmp_path, capsys):
    package = write_lambert_package(tmp_path / "ball.rna", sphere(2))
    assert main([str(package), "--png", str(tmp_path / "a.png"), "--tier", "x"]) == 1
    assert capsys.readouterr().err.startswith(f"error: {package}: assets[0].tier: no tier 'x'")


def test_two_names_for_one_png_are_bad_usage(tmp_path, capsys):
    with pytest.raises(SystemExit):
        main(["a.rna", "--out", str(tmp_path / "a.png"), "--png", str(tmp_path / "b.png")])
    assert "--out and --png both name a PNG" in capsys.readouterr().err


@pytest.mark.parametrize(("size", "is_named"), [(0.3, False), (9.0, False), (180.0, True)])
def test_a_size_that_looks_like_centimetres_is_named(tmp_path, capsys, size, is_named):
    package = write_lambert_package(tmp_path / "floor.rna", square(size=size / 2))
    with Package.open(package) as opened:
        low, high = opened.box()
    assert float((high - low).max()) == pytest.approx(size)
    assert (size_note(low, high) is not None) is is_named
    out = ["--png", str(tmp_path / "a.png"), "--resolution", "4x4", "--samples", "1"]
    assert main([str(package), *out]) == 0
    assert ("note: the asset is 180 m in size, 1.8 m if" in capsys.readouterr().err) is is_named


def test_glass_beside_the_package_is_part_of_the_scene(tmp_path):
    package = write_lambert_package(tmp_path / "it.rna", sphere(3))
    alone = shown(package)
    glass_of(package).write_bytes(box_glb((1.0, 9.0, 1.0)))
    scene = read_scene(package).scene
    assert [item.path.name for item in scene.objects] == ["it.glass.glb"]
    of = shown(package)
    assert of.low.tolist() == pytest.approx([*np.minimum(alone.low, [-0.5, -4.5, -0.5])])
    assert scene.ground is not None and scene.ground.height < -4.5
    glass_of(package).write_bytes(b"no glb")
    with pytest.raises(SceneError, match=r"it.glass.glb: it cannot be read as .glb"):
        read_scene(package)
