"""What a scene can ask an asset about, and captures that keep to it."""

from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.capture_tasks import all_tasks
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.scene_domain import MARGIN, scene_domain
from rna_render.command.rna_run import main as render
from rna_render.scene.scene_file import read_scene
from rna_sdk.errors import CaptureError
from rna_sdk.package import Domain
from rna_sdk.package.manifest.manifest_fields import Region
from rna_sdk.runtime import in_region
from tests.exporters.meshes import ring, sphere
from tests.exporters.synthetic import manifest_of
from tests.exporters.two_parts import Teacher
from tests.render.packages import write_lambert_package

BALL = AssetScene([sphere(3)])
SCENE = """\
assets: [{path: packages/ball.rna, transform: {TRANSFORM}}]
camera: {position: [0, 0, 10], look_at: [0, 0, 0]}
lights: [LIGHT]
MORE
"""
SUN = "{type: directional, direction: [3, 0, 0], irradiance: [1, 1, 1]}"


def domain(folder: Path, light: str = SUN, transform: str = "", more: str = "") -> Domain:
    text = SCENE.replace("LIGHT", light).replace("TRANSFORM", transform).replace("MORE", more)
    (folder / "scene.yaml").write_text(text)
    return scene_domain(read_scene(folder / "scene.yaml"), "ball", BALL)


def cones(region: Region) -> list[tuple[list[float], float]]:
    """Axes, and half angles without the margin, degrees."""
    assert not isinstance(region, str)
    return [
        (list(np.round(c.axis, 6) + 0.0), round(float(np.degrees(c.half_angle - MARGIN)), 3))
        for c in region
    ]


def test_a_camera_and_a_sun(tmp_path):
    actual = domain(tmp_path)
    assert cones(actual.wo) == [([0, 0, 1], round(np.degrees(np.arcsin(0.1)), 3))]
    assert cones(actual.wi) == [([1, 0, 0], 0)]


@pytest.mark.parametrize(
    ("light", "axis", "half_angle"),
    [
        (SUN.replace("[1, 1, 1]", "[1, 1, 1], angular_diameter_deg: 4"), [1, 0, 0], 2.0),
        ("{type: point, position: [0, 4, 0], intensity: [1, 1, 1]}", [0, 1, 0], 14.478),
        (
            "{type: spot, position: [0, 4, 0], look_at: [0, 0, 0], intensity: [1, 1, 1]}",
            [0, 1, 0],
            14.478,
        ),
        ("{type: sphere, position: [0, 4, 0], radius: 1, radiance: [1, 1, 1]}", [0, 1, 0], 30.0),
        (
            "{type: disk, position: [0, 4, 0], look_at: [0, 0, 0], radius: 1, radiance: [1, 1, 1]}",
            [0, 1, 0],
            30.0,
        ),
        (
            "{type: rectangle, position: [0, 4, 0], look_at: [0, 0, 0], up: [1, 0, 0], "
            "size: [1.6, 1.2], radiance: [1, 1, 1]}",
            [0, 1, 0],
            30.0,
        ),
    ],
)
def test_each_kind_of_light(light, axis, half_angle, tmp_path):
    assert cones(domain(tmp_path, light).wi) == [(axis, half_angle)]


def test_a_sky_lights_from_everywhere(tmp_path):
    actual = domain(tmp_path, "{type: environment}")
    assert actual.wi == "sphere" and actual.wo != "sphere"


def test_cones_are_in_the_space_of_the_turned_and_scaled_asset(tmp_path):
    actual = domain(tmp_path, transform="rotation_deg: [0, 90, 0], scale: 2")
    # The turn takes the asset's +x to the world's -z, and its +z to the world's +x.
    assert cones(actual.wo) == [([-1, 0, 0], round(np.degrees(np.arcsin(0.2)), 3))]
    assert cones(actual.wi) == [([0, 0, 1], 0)]


@pytest.mark.parametrize(
    ("more", "wo_limited", "wi_limited"),
    [
        ("ground: {height: -2}", False, False),
        ("ground: {height: -2, material: {type: shadow_catcher}}", True, True),
        ("ground: {height: -2}\nmax_depth: 1", True, True),
        (
            "ground: {height: -2, material: {type: diffuse, emission: [1, 1, 1]}}\nmax_depth: 1",
            True,
            False,
        ),
        ("objects: [{path: wall.ply}]\nmax_depth: 1", True, False),
        ("objects: [{path: wall.ply, material: {type: diffuse}}]\nmax_depth: 1", True, True),
    ],
)
def test_what_other_things_do(more, wo_limited, wi_limited, tmp_path):
    actual = domain(tmp_path, more=more)
    assert (actual.wo != "sphere", actual.wi != "sphere") == (wo_limited, wi_limited)


def test_all_frames_of_an_animation_count(tmp_path):
    actual = domain(tmp_path, more="animation: {frames: 30, turntable: {}, light_sweep: {}}")
    up = np.float32([[0, 1, 0], [0, -1, 0]])
    for region, first_deg in ((actual.wo, 0.0), (actual.wi, 90.0)):
        turn = np.radians(first_deg + np.arange(0.0, 360.0, 12.0))
        level = np.stack([np.sin(turn), 0.0 * turn, np.cos(turn)], axis=1).astype(np.float32)
        assert in_region(region, level).all() and not in_region(region, up).any()


def test_a_scene_without_the_asset_is_refused(tmp_path):
    more = "# two packages, neither of them the dataset's\n"
    text = SCENE.replace("LIGHT", SUN).replace("{TRANSFORM}", "{}").replace("MORE", more)
    text = text.replace("packages/ball.rna", "a.rna").replace("[{path", "[{path: b.rna}, {path")
    (tmp_path / "scene.yaml").write_text(text)
    with pytest.raises(CaptureError, match=r"found assets a.rna, b.rna; expected one of ball.rna"):
        scene_domain(read_scene(tmp_path / "scene.yaml"), "ball", BALL)


def test_every_sample_of_a_capture_is_in_the_domain(tmp_path):
    lamp = "{type: point, position: [4, 4, 0], intensity: [1, 1, 1]}"
    limited = domain(tmp_path, f"{SUN}, {lamp}")
    settings = CaptureSettings(rays=300, lights=12, validation_resolution=24)
    manifest = manifest_of(settings, scene_domain=limited)
    dataset = Dataset.create(tmp_path / "ring.rays", manifest, {"asset": ring()})
    assert dataset.manifest.domain == limited  # also after it went through the file
    scene = scene_of(dataset)
    for task in all_tasks(dataset):
        task.run(dataset, scene, Teacher())
    samples = dataset.only.training_samples()
    assert len(samples["wo"]) == 12 * 300
    views = [view.samples for view in dataset.only.validation_views()]
    for at in (samples, *views):
        assert in_region(limited.wo, at["wo"]).all()
        assert in_region(limited.wi, at["wi"]).all()
    lit = [in_region((cone,), samples["wi"]).mean() for cone in limited.wi]
    assert min(lit) > 0.2  # the sun has no size, and yet its share


def test_the_scene_that_it_was_made_for_stays_inside(tmp_path, capsys):
    lamp = "{type: rectangle, position: [2, 3, 1], look_at: [0, 0, 0], size: [1, 1], "
    actual = domain(tmp_path, lamp + "radiance: [1, 1, 1]}", "rotation_deg: [20, 30, 0]")
    (tmp_path / "packages").mkdir()
    write_lambert_package(tmp_path / "packages" / "ball.rna", sphere(3), domain=actual)
    command = [str(tmp_path / "scene.yaml"), "--out", str(tmp_path / "out.exr"), "--samples", "4"]
    assert render([*command, "--resolution", "48x48"]) == 0
    assert "warning" not in capsys.readouterr().err
