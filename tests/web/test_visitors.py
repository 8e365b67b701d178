"""What visitors without WebGPU see: a poster, and a calm line in their language."""

import pytest
from PIL import Image

from tests.render.chromium import NO_GPU, open_page
from tests.web.element_pages import Static, line, show
from tests.web.pages import TIMEOUT

pytestmark = pytest.mark.chromium

WITHOUT_GPU = """<div lang="de"><rna-viewer id="one" src="tiny.rna" poster="poster.png"
  loading="eager" data-labels="hero,car" alt="Ein Auto" camera-controls></rna-viewer></div>
<rna-viewer id="two" src="" poster=" " loading="eager" alt="None"></rna-viewer>
<rna-viewer id="three" src="model.glb" loading="eager" texts='{"unavailable": "Sorry"}'>
</rna-viewer>"""
SHOWN = "(({ place }) => place.hidden ? null : place.textContent)(%s.notices)"


@pytest.fixture(scope="module")
def page():
    with open_page(200, 200, NO_GPU) as page:
        yield page


def test_without_webgpu(page, folder, url):
    Image.new("RGB", (32, 20), "red").save(folder / "poster.png")
    (folder / "model.glb").write_bytes(b"glTF" + bytes(60))
    Static.requested.clear()
    show(page, folder, url, WITHOUT_GPU)
    page.wait_for("count('error', 'one') && count('error', 'three') > 1", TIMEOUT)
    unavailable = "Die interaktive Ansicht ist hier nicht verfügbar."
    page.wait_for(f"{SHOWN % 'one'} !== null", TIMEOUT)
    assert page.evaluate(SHOWN % "one") == unavailable
    assert page.evaluate("one.notices.place.role") == "status"
    assert line(page) == "WebGPU has no adapter here: no more than a stand-in or a poster is shown"
    assert page.evaluate("heard.find(({ id }) => id === 'one').message") == line(page)
    assert page.evaluate("getComputedStyle(one.parts.poster).display") != "none"
    # Nothing is asked for that has no address; no mistake of the page is shown.
    asked = [path for path in Static.requested if "page.html" in path]
    assert len(asked) == 1 and page.evaluate("count('error', 'two')") == 1
    assert page.evaluate("heard.findLast(({ id }) => id === 'three').message") == (
        "model.glb: expected a package, found a glTF file: rna-make makes a package of it, "
        "as rna-make model.glb --out model.rna [ZIP_NOT_ZIP]"
    )
    # Visitors are told nothing of an asset that the page does not want, until it does.
    assert page.evaluate(SHOWN % "two") is None
    page.evaluate("two.src = 'tiny.rna', 0")
    page.wait_for(f"{SHOWN % 'two'} !== null", TIMEOUT)
    # The line goes where there is a poster, and stays where there is nothing.
    page.wait_for(f"{SHOWN % 'one'} === null", TIMEOUT)
    assert page.evaluate(SHOWN % "three") == "Sorry"


def test_an_element_that_comes_into_an_iframe_keeps_its_style(page, folder, url):
    show(page, folder, url, '<rna-viewer id="one"></rna-viewer><iframe id="frame"></iframe>')
    position = page.evaluate(
        """(() => {
            const { view } = one.parts;
            frame.contentDocument.body.append(one);
            return frame.contentWindow.getComputedStyle(view).position;
        })()"""
    )
    assert position == "absolute"
