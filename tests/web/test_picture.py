"""The viewer's picture is rna-run's, of the same camera and light."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from rna_render.preview.picture import rgba
from rna_render.render import load_world, make_integrator, render
from rna_render.scene_file import read_scene
from rna_view.site_files import site_for
from tests.web.pages import APIS, picture, viewer, wait_for_picture

pytestmark = pytest.mark.chromium

EXAMPLES = Path(__file__).parents[2] / "examples"
WIDTH, HEIGHT, SAMPLES = 96, 60, 64
LEAST_PSNR = 40.0

SCENE = """
assets: [{{path: {asset}}}]
camera: {{position: {position}, look_at: {look_at}, vertical_fov_deg: 28}}
lights: [{lights}]
resolution: [{width}, {height}]
samples: {samples}
"""
SUNS = """
  {type: directional, direction: [0.55, 0.75, 0.65], irradiance: [2.5, 2.35, 2.1]},
  {type: directional, direction: [-0.7, 0.35, -0.65], irradiance: [1.1, 1.3, 1.7]}
"""
ENVIRONMENT = "{type: environment, radiance: [0.5, 0.6, 0.8], visible_to_camera: false}"
TOY = EXAMPLES / "quickstart" / "toy.rna", [1.42, 0.8, 0.78], [0.38, 0.17, -0.16]
CURLS = EXAMPLES / "fibers" / "curly_ball.rna", [0.75, 0.45, 1.1], [0.0, 0.0, 0.0]


def write_scene(folder: Path, asset, lights: str, samples: int = SAMPLES) -> Path:
    path, position, look_at = asset
    text = SCENE.format(
        asset=path, position=position, look_at=look_at, lights=lights,
        width=WIDTH, height=HEIGHT, samples=samples,
    )  # fmt: skip
    (folder / "scene.yaml").write_text(text)
    return folder / "scene.yaml"


def by_rna_run(path: Path) -> np.ndarray:
    scene_file = read_scene(path)
    integrator = make_integrator(scene_file.scene, load_world(scene_file))
    return rgba(render(scene_file.scene, integrator))


def by_viewer(path: Path, api: str, rounds: int) -> np.ndarray:
    query = f"api={api}&rounds={rounds}&dpr=1&ui=0"
    with viewer(site_for(path), query, WIDTH, HEIGHT) as page:
        wait_for_picture(page, rounds)
        return picture(page)


def psnr(found: np.ndarray, expected: np.ndarray) -> float:
    """dB of radiance clamped to [0, 1], over the pixels that show the asset."""
    seen = expected[..., 3] > 0
    error = (np.clip(found[..., :3], 0, 1) - np.clip(expected[..., :3], 0, 1))[seen]
    return float(-10 * np.log10(np.mean(error**2)))


@pytest.mark.parametrize("api", APIS)
@pytest.mark.parametrize("asset", [TOY, CURLS], ids=["toy", "curls"])
def test_suns(api, asset, tmp_path):
    path = write_scene(tmp_path, asset, SUNS)
    found, expected = by_viewer(path, api, SAMPLES), by_rna_run(path)
    assert np.abs(found[..., 3] - expected[..., 3]).mean() < 0.01
    assert psnr(found, expected) >= LEAST_PSNR


@pytest.mark.parametrize("api", APIS)
def test_environment(api, tmp_path):
    path = write_scene(tmp_path, TOY, ENVIRONMENT, 256)
    found, expected = by_viewer(path, api, 256), by_rna_run(path)
    assert psnr(found, expected) >= LEAST_PSNR
