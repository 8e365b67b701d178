"""The viewer's picture is rna-run's, of the same camera, rays and light."""

from pathlib import Path

import numpy as np
import OpenEXR
import pytest

from rna_render.paths.bands import render
from rna_render.paths.integrator_factory import make_integrator
from rna_render.paths.world_in_time import load_world
from rna_render.preview.picture import rgba
from rna_render.scene.scene_file import read_scene
from rna_render.world.camera import Camera
from rna_view.site_source import site_for
from tests.render.specks import brightest_around
from tests.web.pages import picture, viewer, wait_for_picture

pytestmark = pytest.mark.chromium

REPOSITORY = Path(__file__).parents[2]
LEAST_PSNR = 40.0

SCENE = """
assets: [{{path: {path}}}]
camera: {{position: {position}, look_at: {look_at}, vertical_fov_deg: 28}}
lights: [{lights}]
resolution: {size}
samples: {samples}
"""
SUNS = """
  {type: directional, direction: [0.55, 0.75, 0.65], irradiance: [2.5, 2.35, 2.1]},
  {type: directional, direction: [-0.7, 0.35, -0.65], irradiance: [1.1, 1.3, 1.7]}
"""
ENVIRONMENT = "{type: environment, radiance: [0.5, 0.6, 0.8], visible_to_camera: false}"
SKY = "{type: environment, path: sky.exr, rotation_deg: 30, visible_to_camera: false}"
TOY = {
    "path": REPOSITORY / "examples" / "quickstart" / "toy.rna",
    "position": [1.42, 0.8, 0.78],
    "look_at": [0.38, 0.17, -0.16],
}
CURLS = {
    "path": REPOSITORY / "examples" / "fibers" / "curly_ball.rna",
    "position": [0.75, 0.45, 1.1],
    "look_at": [0.0, 0.0, 0.0],
}
KIT = REPOSITORY / "spec" / "conformance" / "packages"
LANTERN = {
    "path": KIT / "parts-lantern.rna",
    "position": [2.1, 1.2, 2.6],
    "look_at": [0.0, 0.0, 0.0],
}

DIM_SUN = "{type: directional, direction: [0.35, 0.6, 0.65], irradiance: [0.15, 0.15, 0.15]}"
"""For these, whose decoders are random."""
GLOWING = {
    "path": KIT / "surface-nearby.rna",
    "position": [1.4, 1.7, 3.4],
    "look_at": [0.0, -0.1, 0.0],
}
GLOWING_CURLS = {
    "path": KIT / "fiber-nearby.rna",
    "position": [0.9, 0.6, 1.4],
    "look_at": [0.0, 0.0, 0.0],
}


@pytest.fixture
def middles_of_pixels(monkeypatch):
    """rna-run's rays go through the middles of pixels, so that one sample has no noise."""
    directions = Camera.directions

    def centred(self: Camera, pixels: np.ndarray, u: np.ndarray) -> np.ndarray:
        return directions(self, pixels, np.full_like(u, 0.5))

    monkeypatch.setattr(Camera, "directions", centred)


def write_scene(folder: Path, asset: dict, lights: str, size: list[int], samples: int) -> Path:
    text = SCENE.format(**asset, lights=lights, size=size, samples=samples)
    (folder / "scene.yaml").write_text(text)
    return folder / "scene.yaml"


def by_rna_run(path: Path) -> np.ndarray:
    scene_file = read_scene(path)
    integrator = make_integrator(scene_file.resolved, load_world(scene_file))
    return rgba(render(scene_file.scene, integrator))


def by_viewer(path: Path, more: str = "") -> np.ndarray:
    """Without the first look, whose kernels would be compiled, too."""
    scene = read_scene(path).scene
    query = f"samples={scene.samples}&pixel-ratio=1&ui=0&first-look=off{more}"
    with viewer(site_for(path), query, *scene.resolution) as page:
        wait_for_picture(page, scene.samples)
        return picture(page)


def psnr(actual: np.ndarray, expected: np.ndarray) -> float:
    """dB of radiance clamped to [0, 1], over the pixels that show the asset."""
    seen = expected[..., 3] > 0
    error = (np.clip(actual[..., :3], 0, 1) - np.clip(expected[..., :3], 0, 1))[seen]
    return float(-10 * np.log10(np.mean(error**2)))


@pytest.mark.parametrize("asset", [TOY, CURLS], ids=["toy", "curls"])
@pytest.mark.usefixtures("middles_of_pixels")
def test_suns(asset, tmp_path):
    path = write_scene(tmp_path, asset, SUNS, [160, 100], 1)
    expected = by_rna_run(path)
    actual = by_viewer(path, "&jitter=0")
    assert np.mean(actual[..., 3] != expected[..., 3]) < 0.002
    assert psnr(actual, expected) >= LEAST_PSNR


@pytest.mark.parametrize(
    ("asset", "least"), [(GLOWING, LEAST_PSNR), (GLOWING_CURLS, 38.0)], ids=["surface", "strands"]
)
@pytest.mark.usefixtures("middles_of_pixels")
def test_nearby_light(asset, least, tmp_path):
    """By the same columns, of which the first sample of the first light has the same numbers.

    The sphere of a joint has the tangent of either segment (spec/RNA.md, 4.2).
    """
    path = write_scene(tmp_path, asset, DIM_SUN, [64, 40], 1)
    expected = by_rna_run(path)
    actual = by_viewer(path, "&jitter=0")
    assert psnr(actual, expected) >= least
    assert expected.max() < 1.5


def test_environment(tmp_path):
    path = write_scene(tmp_path, TOY, ENVIRONMENT, [24, 15], 64)
    expected = np.mean(by_rna_run(path)[..., :3])
    assert np.mean(by_viewer(path)[..., :3]) == pytest.approx(expected, rel=0.02)


def test_no_specks_in_highlights(tmp_path):
    """After few samples no pixel is far brighter than its 5 x 5 neighbourhood, converged."""
    size = [96, 60]
    expected = by_rna_run(write_scene(tmp_path, TOY, ENVIRONMENT, size, 256))
    inside = expected[..., 3] > 0.999
    around = brightest_around(expected[..., :3].mean(axis=-1))[inside]
    path = write_scene(tmp_path, TOY, ENVIRONMENT, size, 4)
    ratio = by_viewer(path)[..., :3].mean(axis=-1)[inside] / around
    assert ratio.max() < 6  # 12 without directions about the mirror direction


@pytest.mark.usefixtures("middles_of_pixels")
def test_sun_in_an_image(tmp_path):
    """A texel 400 times brighter than the sky: the same picture, no pixel too bright."""
    rows = np.linspace([0.25, 0.35, 0.6], [0.12, 0.1, 0.08], 32, dtype=np.float32)
    sky = np.repeat(rows[:, None], 64, axis=1)
    sky[9, 40] = [160.0, 140.0, 112.0]
    OpenEXR.File({}, {"RGB": sky}).write(str(tmp_path / "sky.exr"))
    path = write_scene(tmp_path, TOY, SKY, [16, 10], 320)
    expected = by_rna_run(path)
    actual = by_viewer(path, "&jitter=0")
    assert psnr(actual, expected) >= LEAST_PSNR
    assert actual[..., :3].max() < 1.2 * expected[..., :3].max()


def test_emission_holes_and_glass(tmp_path):
    """Parts of both kinds, that emit, behind cut-outs and panes."""
    path = write_scene(tmp_path, LANTERN, SUNS, [32, 20], 32)
    expected = np.mean(by_rna_run(path)[..., :3])
    assert np.mean(by_viewer(path)[..., :3]) == pytest.approx(expected, rel=0.03)
