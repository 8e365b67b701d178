"""Smooth glass beside a package: the picture is rna-run's, and other files are named."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import OpenEXR
import pytest

from rna_sdk.package import ProfileLayer, decoder_to_bytes, write_package
from rna_view.site_source import site_for
from tests.package.builders import decoder_of, make_manifest, make_mesh, make_tier_data
from tests.web.element_pages import SMALL, line, loads, show
from tests.web.glass_files import write_ball
from tests.web.pages import TIMEOUT, picture, viewer, wait_for_picture
from tests.web.test_picture import by_rna_run, by_viewer, psnr

pytestmark = pytest.mark.chromium

SCENE = """
assets: [{path: tiny.rna}]
objects: [{path: tiny.glass.glb}]
camera: {position: [2, 2, 5], look_at: [0, 0, 0], vertical_fov_deg: 40}
lights: [{type: environment, path: sky.exr, rotation_deg: 30, visible_to_camera: false}]
resolution: [36, 24]
samples: 64
max_depth: 1
"""


def write_even_package(path: Path) -> None:
    """The tiny package, with the same transport from everywhere to everywhere."""
    manifest = make_manifest()
    (tier,) = manifest.tiers
    (data,) = make_tier_data(tier)
    columns = tier.parts[0].decoders[0].columns
    bias = np.log1p(np.repeat([0.06, 0.01], 3)).astype(np.float32)
    layer = ProfileLayer(np.zeros((columns, 6), np.float32), bias, 0.0, None, relu=False)
    even = replace(data, decoder=decoder_to_bytes(decoder_of([layer])))
    write_package(path, manifest, [make_mesh()], {tier.name: [even]})


@pytest.fixture
def scene(tmp_path):
    """A tetrahedron in a ball of glass under a sky with a window."""
    rows = np.linspace([0.3, 0.5, 1.0], [0.5, 0.4, 0.2], 16, dtype=np.float32)
    sky = np.repeat(rows[:, None], 32, axis=1)
    sky[3:6, 8:14] = 3.0
    OpenEXR.File({}, {"RGB": sky}).write(str(tmp_path / "sky.exr"))
    write_even_package(tmp_path / "tiny.rna")
    write_ball(tmp_path / "tiny.glass.glb")
    (tmp_path / "scene.yaml").write_text(SCENE)
    return tmp_path / "scene.yaml"


def test_the_picture_is_that_of_rna_run(scene):
    expected, actual = by_rna_run(scene), by_viewer(scene)
    assert psnr(actual, expected) > 30.0
    np.testing.assert_allclose(actual[..., 3], expected[..., 3], atol=0.02)
    np.testing.assert_allclose(np.mean(actual, (0, 1)), np.mean(expected, (0, 1)), rtol=0.01)
    scene.write_text(SCENE.replace("objects: [{path: tiny.glass.glb}]\n", ""))
    assert psnr(by_rna_run(scene), expected) < 20.0


def test_a_ground_is_seen_through_the_glass(scene):
    """As bright as the page where light and glass leave it, dark where the glass takes its sun."""
    site = site_for(scene.parent / "tiny.rna")
    light = (
        "sun=0deg 90deg 3&environment=white&environment-intensity=0.1&camera-orbit=0deg 60deg 9m"
    )
    with viewer(site, f"samples=8&pixel-ratio=1&ui=0&{light}", 48, 32) as page:
        wait_for_picture(page, 8)
        actual = picture(page)
    assert np.mean(actual[14:18, 22:26, 3]) == 1.0
    shadow, open_ground = actual[20:24, 22:26, :3].mean(), actual[26:, :6, :3].mean()
    assert shadow < 0.5 * open_ground


def test_what_is_no_smooth_glass_is_named(page, folder, url):
    write_ball(folder / "tiny.glass.glb")
    write_ball(folder / "frosted.glb", roughness=0.3)
    (folder / "page.glb").write_text("<!doctype html><title>404</title>")
    body = f'<rna-viewer id="one" src="tiny.rna" glass="frosted.glb" {SMALL}></rna-viewer>'
    show(page, folder, url, body)
    loads(page, "one")
    assert line(page).startswith("glass: frosted.glb: expected smooth glass, of KHR_materials_tr")
    page.evaluate("one.glass = 'page.glb', 0")
    page.wait_for("one.notices.whole?.includes('an HTML page')", TIMEOUT)
    page.evaluate("one.glass = 'none.glb', 0")
    page.wait_for("one.notices.whole?.includes('HTTP 404')", TIMEOUT)
    page.wait_for("one.loaded", TIMEOUT)
    assert not page.evaluate("!!one.stage.shown.glass")
    page.evaluate("one.glass = 'tiny.glass.glb', 0")
    page.wait_for("one.loaded && !!one.stage.shown.glass", TIMEOUT)
    assert line(page) is None
    page.evaluate("one.glass = null, 0")
    page.wait_for("one.loaded && !one.stage.shown.glass", TIMEOUT)
