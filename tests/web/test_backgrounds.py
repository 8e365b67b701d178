"""What is behind the asset: any colour of CSS, when the page changes it, or the page."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image

from tests.render.chromium import Page
from tests.web.element_pages import SMALL, line, loads, show
from tests.web.pages import TIMEOUT

pytestmark = pytest.mark.chromium

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
    assert line(page, "three") == "ground: expected an opaque background-color"
    page.evaluate("three.style.background = 'white', 0")
    page.wait_for("three.stage.viewer.ground !== null", TIMEOUT)
    assert line(page, "three") is None
