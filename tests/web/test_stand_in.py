"""The stand-in of a package: seen and turned before the network, and in its place."""

import io
import shutil

import numpy as np
import pytest
from PIL import Image

from rna_sdk.package.packing import Unpacked
from tests.conftest import REPOSITORY
from tests.package.builders import make_tiny_package
from tests.package.prints import image_bytes, make_print
from tests.render.chromium import NO_GPU, SOFTWARE_GPU, Page, open_page
from tests.web.element_pages import SMALL, line, loads, show
from tests.web.pages import TIMEOUT

pytestmark = pytest.mark.chromium

LOOKS = 'loading="eager" camera-controls style="width: 160px; height: 100px"'
BROWSERS = {"none": NO_GPU, "software": SOFTWARE_GPU}


@pytest.fixture
def browser(request):
    """The page with the flags that the test names."""
    with open_page(160, 100, BROWSERS[request.param]) as page:
        yield page


def stands(page: Page) -> None:
    """Until the stand-in is drawn."""
    page.wait_for("one.stage.standIn.shownCamera !== null", TIMEOUT)


def seen(page: Page) -> np.ndarray:
    """(100, 160, 3) uint8 of the page."""
    return np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("RGB"))


def drag(page: Page) -> None:
    """With the left button, from the middle to the right."""
    for kind, x in (("mousePressed", 80), ("mouseMoved", 100), ("mouseMoved", 130)):
        button = {"button": "left", "clickCount": 1, "buttons": 1}
        page.call("Input.dispatchMouseEvent", type=kind, x=x, y=50, **button)


def drop(page: Page) -> None:
    page.call("Input.dispatchMouseEvent", type="mouseReleased", x=130, y=50, button="left")


@pytest.mark.parametrize("browser", ["none"], indirect=True)
def test_without_webgpu_it_turns_and_nothing_alarms(browser, folder, url):
    make_print(folder / "print.rna")
    show(browser, folder, url, f'<rna-viewer id="one" src="print.rna" {LOOKS}></rna-viewer>')
    stands(browser)
    assert browser.evaluate("[one.notices.place.hidden, one.parts.poster.hidden]") == [True, True]
    assert (
        line(browser) == "WebGPU has no adapter here: no more than a stand-in or a poster is shown"
    )
    before = seen(browser)
    assert len(np.unique(before.reshape(-1, 3), axis=0)) > 20
    drag(browser)
    drop(browser)
    browser.wait_for("heard.some(({ source }) => source === 'user-interaction')", TIMEOUT)
    browser.evaluate("new Promise(requestAnimationFrame).then(() => 0)")
    assert (seen(browser) != before).any()
    # It is gone with its asset, and comes with another variant of the light.
    assert browser.evaluate("one.removeAttribute('src'), one.parts.view.childElementCount") == 0


@pytest.mark.parametrize("browser", ["none"], indirect=True)
@pytest.mark.parametrize(("roughness", "metallic"), [(1.0, 0.0), (0.5, 0.0), (0.4, 1.0)])
def test_white_surfaces_are_white_in_a_white_world(browser, folder, url, roughness, metallic):
    """The white furnace: as much light leaves as comes. Textures, and their constants."""
    levels = np.rint(255 * np.array([[[1.0, roughness, metallic]]])).astype(np.uint8)
    white, flat = np.full((1, 1, 3), 255, np.uint8), np.uint8([[[128, 128, 255]]])
    images = {"base_color": white, "metallic_roughness": levels, "normal": flat}
    textures = {member: image_bytes(pixels) for member, pixels in images.items()}
    package = make_tiny_package(folder / "plain.rna")
    Unpacked.read(package).with_standin_textures([textures]).write(folder / "white.rna")
    light = 'environment="white" style="background-color: black; width: 160px; height: 100px"'
    show(browser, folder, url, f'<rna-viewer id="one" src="white.rna" loading="eager" {light}>')
    stands(browser)
    image = seen(browser).astype(np.float32)
    asset = image[image.max(axis=2) > 128]
    linear = ((asset / 255 + 0.055) / 1.055) ** 2.4
    assert len(asset) > 500 and 0.9 < np.median(linear) <= 1.0
    # A stop less is half.
    browser.evaluate("one.exposure = -1, new Promise(requestAnimationFrame).then(() => 0)")
    darker = seen(browser).astype(np.float32)
    half = ((darker[image.max(axis=2) > 128] / 255 + 0.055) / 1.055) ** 2.4
    assert 0.45 < np.median(half) <= 0.55


@pytest.mark.parametrize("browser", ["software"], indirect=True)
def test_the_network_takes_over_at_full_size_and_after_a_loss(browser, folder, url):
    make_print(folder / "print.rna")
    show(
        browser, folder, url, f'<rna-viewer id="one" src="print.rna" {SMALL} {LOOKS}></rna-viewer>'
    )
    stands(browser)
    # What moves is the stand-in; the network's picture waits, and nothing of it is seen.
    drag(browser)
    assert browser.evaluate("getComputedStyle(one.stage.canvas).opacity") == "0"
    moved = browser.evaluate("one.cameraOrbit")
    drop(browser)
    loads(browser, "one")
    browser.wait_for("!one.stage.standIn.isShown", TIMEOUT)
    assert browser.evaluate("one.stage.viewer.stats.scale") == 1
    assert browser.evaluate("one.cameraOrbit") == moved
    browser.wait_for("one.parts.view.childElementCount === 1", TIMEOUT)
    browser.wait_for("getComputedStyle(one.stage.canvas).opacity === '1'", TIMEOUT)
    browser.evaluate("one.stage.engine.device.destroy()")
    browser.wait_for("one.stage.standIn.isShown", TIMEOUT)
    assert browser.evaluate("[one.notices.place.hidden, one.parts.poster.hidden]") == [True, True]
    browser.wait_for("one.stage.isWhole && !one.stage.standIn.isShown", TIMEOUT)


@pytest.mark.parametrize("browser", ["none"], indirect=True)
def test_a_package_without_colours_has_its_poster(browser, folder, url):
    Image.new("RGB", (32, 20), "red").save(folder / "poster.png")
    poster = f'<rna-viewer id="one" src="tiny.rna" poster="poster.png" {LOOKS}></rna-viewer>'
    show(browser, folder, url, poster)
    browser.wait_for("count('error', 'one') && !one.stage.loading", TIMEOUT)
    assert not browser.evaluate("one.stage.standIn.isShown")
    assert not browser.evaluate("one.parts.poster.hidden || one.notices.place.hidden")


@pytest.mark.parametrize("browser", ["none"], indirect=True)
def test_what_has_no_colours_by_place_turns_below_its_poster(browser, folder, url):
    """Strands, in the one colour that their package has for them: the poster until they move."""
    shutil.copy(REPOSITORY / "examples" / "fibers" / "curly_ball.rna", folder)
    turns = 'auto-rotate auto-rotate-delay="0"'
    show(browser, folder, url, f'<rna-viewer id="one" src="curly_ball.rna" {turns} {LOOKS}>')
    stands(browser)
    hidden = "[one.notices.place.hidden, one.parts.poster.hidden]"
    assert browser.evaluate(hidden) == [True, False]
    still = browser.evaluate("one.turntableRotation")
    browser.evaluate("new Promise((resolve) => setTimeout(resolve, 300)).then(() => 0)")
    assert browser.evaluate("one.turntableRotation") == still
    drag(browser)
    drop(browser)
    browser.wait_for("one.parts.poster.hidden", TIMEOUT)
    browser.wait_for(f"one.turntableRotation > {still}", TIMEOUT)
    red, green, blue = seen(browser).reshape(-1, 3).T.astype(int)
    brown = (red > green) & (green > blue) & (red < 200)
    assert 0.05 < brown.mean() < 0.4 and len(np.unique(red[brown])) > 20
