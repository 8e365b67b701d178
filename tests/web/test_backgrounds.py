"""The background of the asset: any colour of CSS, changes of it, or the page."""

import io

import numpy as np
import pytest
from PIL import Image

from rna_render.image.view_transform import to_display
from tests.render.chromium import Page
from tests.web.element_pages import SMALL, finished, line, loads, show
from tests.web.pages import TIMEOUT
from tests.web.test_first_light import sphere
from tests.web.test_page import write_image

pytestmark = pytest.mark.chromium

GROUND = "ground: expected an opaque background-color, and no skybox"
BODY = f"""<style>
  :root {{ color-scheme: light dark; background: red; }}
  body {{ margin: 0; }}
  #one {{ background: light-dark(white, black); }}
  #two {{ background: oklch(0.97 0.01 250); }}
  #three {{ background: transparent; }}
  #four {{ background: rgb(0 0 255 / 0.5); }}
</style>
<rna-viewer id="one" src="tiny.rna" {SMALL}></rna-viewer>
<rna-viewer id="two" src="tiny.rna" {SMALL}></rna-viewer>
<rna-viewer id="three" src="tiny.rna" {SMALL}></rna-viewer>
<rna-viewer id="four" src="tiny.rna" {SMALL}></rna-viewer>
"""


def corners(page: Page) -> list[list[int]]:
    """The colour at the lower left corner of each element, on the screen."""
    shot = np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("RGB"))
    return [shot[40 * k + 38, 1].tolist() for k in range(4)]


def test_any_colour_and_a_theme_that_changes(page, folder, url):
    page.call("Emulation.setEmulatedMedia", features=[])
    show(page, folder, url, BODY)
    for element in ("one", "two", "three", "four"):
        loads(page, element)
    white, pale, red, mixed = corners(page)
    assert white == [255] * 3 and red == [255, 0, 0]
    assert min(pale) > 235 and pale[2] > pale[0]
    assert mixed == pytest.approx([128, 0, 128], abs=2)
    dark = [{"name": "prefers-color-scheme", "value": "dark"}]
    page.call("Emulation.setEmulatedMedia", features=dark)
    page.wait_for("one.stage.look.backdrop[0] === 0", TIMEOUT)
    page.evaluate("new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve, 50)))")
    assert corners(page)[0] == [0, 0, 0]
    page.call("Emulation.setEmulatedMedia", features=[])


def test_ground_needs_an_opaque_background(page):
    page.evaluate("three.ground = true, 0")
    assert line(page, "three") == GROUND
    page.evaluate("three.style.background = 'white', 0")
    page.wait_for("three.stage.viewer.ground !== null", TIMEOUT)
    assert line(page, "three") is None


def test_the_environment_behind_the_asset(page, folder, url):
    """An environment whose colour tells the direction, turned with the light, and as bright."""
    d, _ = sphere(64, 128)
    write_image(folder / "sky.hdr", (0.3 * (d + 1)).astype(np.float32))
    view = 'camera-orbit="30deg 70deg 9m" interpolation-decay="0" skybox environment="sky.hdr"'
    body = f'<rna-viewer id="one" src="tiny.rna" {view} {SMALL}></rna-viewer>'
    show(page, folder, url, body.replace("pixel-ratio", 'exposure="0.5" pixel-ratio'))
    loads(page, "one")
    finished(page)
    for angle in (30.0, 90.0):
        page.evaluate(f"one.lightRotation = '{angle}deg', 0")
        finished(page)
        camera = page.evaluate("one.stage.viewer.shownCamera")
        shot = np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("RGB"), float)
        turn = np.radians(angle)
        for x, y in ((1, 1), (62, 3), (5, 37), (60, 36)):
            v = np.array(camera["corner"]) + (x + 0.5) * np.array(camera["stepX"])
            v += (y + 0.5) * np.array(camera["stepY"])
            v /= np.linalg.norm(v)
            local = np.array([v[0] * np.cos(turn) - v[2] * np.sin(turn), v[1], 0.0])
            local[2] = v[2] * np.cos(turn) + v[0] * np.sin(turn)
            expected = 255 * to_display(0.3 * (local + 1), "srgb", 0.5)
            np.testing.assert_allclose(shot[y, x], expected, atol=3)
    page.evaluate("one.ground = true, 0")
    assert line(page) == GROUND
    page.evaluate("one.skybox = false, 0")
    page.wait_for("one.stage.viewer.ground !== null", TIMEOUT)
    page.wait_for("one.notices.whole === null", TIMEOUT)
