"""Elements as pages of others treat them: made early, hidden, moved."""

import base64
import io
import re
import zlib

import numpy as np
import pytest
from PIL import Image

from tests.package.builders import make_tiny_package
from tests.web.element_pages import SMALL, finished, loads, show
from tests.web.pages import TIMEOUT

pytestmark = pytest.mark.chromium

EARLY = """<dialog id="place"></dialog><div id="other"></div><script>
  globalThis.said = [];
  console.warn = (text) => said.push(text);
  const made = globalThis.viewer = document.createElement("rna-viewer");
  Object.assign(made, { id: "one", src: "tiny.rna", samples: 1, cameraControls: true });
  made.setAttribute("camera-orbot", "0deg 90deg 2m");
  made.setAttribute("dir", "ltr");
  made.setAttribute("data-scr", "x");
  made.style.display = "none";
  place.append(made);
</script>"""


def test_an_element_that_was_made_before_its_script(page, folder, url):
    """In a dialog that is opened later, without a size at first; then in a shadow tree."""
    show(page, folder, url, EARLY)
    page.wait_for("one.getAttribute('src') === 'tiny.rna'", TIMEOUT)
    values = page.evaluate("[one.samples, one.cameraControls, Object.hasOwn(one, 'src')]")
    assert values == [1, True, False]
    said = "rna-viewer has no attribute camera-orbot: did you mean camera-orbit?"
    assert page.evaluate("said") == [said]
    assert page.evaluate("count('load', 'one')") == 0
    page.evaluate("one.style.display = '', place.showModal(), 0")
    loads(page, "one")
    assert page.evaluate("[viewer.stage.canvas.width, viewer.stage.canvas.height]") == [64, 40]
    page.evaluate(
        """(() => {
            globalThis.engine = viewer.stage.engine;
            place.close();
            other.attachShadow({ mode: "closed" }).append(viewer);
            return 0;
        })()"""
    )
    page.evaluate("viewer.style.width = '0', viewer.style.height = '0', 0")
    page.wait_for("viewer.stage.canvas.width === 1", TIMEOUT)
    page.evaluate("viewer.style.width = '64px', viewer.style.height = '40px', 0")
    page.wait_for("viewer.stage.canvas.width === 64 && viewer.stage.viewer.stats.scale", TIMEOUT)
    assert page.evaluate("viewer.stage.engine === engine && viewer.notices.whole === null")


def test_two_elements_of_one_asset_in_a_folder(page, folder, url):
    (folder / "assets").mkdir()
    make_tiny_package(folder / "assets" / "tiny.rna")
    element = f'<rna-viewer id="{{}}" src="assets/tiny.rna" {SMALL}></rna-viewer>'
    show(page, folder, url, element.format("one") + element.format("two"))
    loads(page, "one")
    loads(page, "two")
    page.evaluate("one.remove(), two.cameraOrbit = '90deg 60deg 4m', 0")
    finished(page, "two")
    assert page.evaluate("two.notices.whole === null && two.stage.engine !== null")


SCREEN = """<script>
  const real = matchMedia;
  const pixels = (value) =>
    Object.defineProperty(globalThis, "devicePixelRatio", { value, configurable: true });
  globalThis.asked = [];
  globalThis.matchMedia = (query) => {
    if (!query.endsWith("dppx)")) return real.call(globalThis, query);
    return { addEventListener: (_, changed) => asked.push({ query, changed }) };
  };
  globalThis.move = (ratio) => (pixels(ratio), asked.at(-1).changed());
  pixels(2);
</script><rna-viewer id="one" src="tiny.rna" samples="1"></rna-viewer>"""


def test_pixels_of_another_screen(page, folder, url):
    """The screen of a phone, then of two desktops; nothing else of the page changes."""
    show(page, folder, url, SCREEN)
    loads(page, "one")
    widths = [page.evaluate(f"{move}one.stage.canvas.width") for move in ("", "move(1), ")]
    assert [*widths, page.evaluate("move(1.5), one.stage.canvas.width")] == [128, 64, 96]
    queries = [f"(resolution: {ratio}dppx)" for ratio in (2, 1, 1.5)]
    assert page.evaluate("asked.map(({ query }) => query)") == queries


def test_the_picture_is_on_paper(page, folder, url):
    """Chromium leaves canvases of WebGPU out of what it prints."""
    show(page, folder, url, f'<rna-viewer id="one" src="tiny.rna" {SMALL}></rna-viewer>')
    loads(page, "one")
    finished(page)
    shown = np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("RGB"), int)[:40, :64]
    document = base64.b64decode(page.call("Page.printToPDF")["data"])
    streams = re.findall(rb"/Subtype /Image.*?stream\r?\n(.*?)endstream", document, re.S)
    images = [zlib.decompress(data) for data in streams]
    (pixels,) = (image for image in images if len(image) == 3 * 40 * 64)
    printed = np.frombuffer(pixels, np.uint8).reshape(40, 64, 3).astype(int)
    assert np.ptp(shown) > 50 and np.abs(printed - shown).max() <= 2
    assert page.evaluate("one.stage.place.children.length") == 1
