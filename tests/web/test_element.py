"""`<rna-viewer>` on pages of others: what it loads and when, its events, what goes wrong."""

import json
import re

import numpy as np
import pytest

from rna_view.rna_view_command import main as rna_view
from rna_view.site_files import ELEMENT, LIGHT, viewer_file
from tests.conftest import REPOSITORY
from tests.package.builders import make_tiny_package
from tests.web.element_pages import SMALL, Static, finished, line, loads, show, visit
from tests.web.in_node import ELEMENT_SOURCES, in_node
from tests.web.pages import TIMEOUT
from tests.web.test_page import write_image

AGAIN = "one.stage.engine && one.stage.engine !== before && one.stage.viewer?.stats.rounds"
TWO = f"""
<rna-viewer id="one" src="tiny.rna" alt="A tiny thing" camera-controls interpolation-decay="0"
  {SMALL}></rna-viewer>
<rna-viewer id="two" src="fibers.rna" sun="10deg 20deg 3" {SMALL}></rna-viewer>
"""


def test_attributes_are_read_and_written_as_model_viewers():
    given = {
        "camera-orbit": [
            "0deg 90deg 2m",
            "1rad auto 150cm",
            "auto auto 105%",
            "1deg 2deg",
            "x y z",
        ],
        "camera-target": ["1m auto -20cm"],
        "field-of-view": ["30deg", "auto", "30"],
        "sun": ["none", "10deg 20deg 1.5", "10deg 20deg -1"],
        "samples": ["16", "1.5"],
    }
    program = f"""
        import {{ READERS, cameraText }} from "{(ELEMENT_SOURCES / "attributes.js").as_uri()}";
        import {{ Orbit }} from "{(ELEMENT_SOURCES / "orbit.js").as_uri()}";
        const read = (name, text) => {{
            try {{ return READERS[name](text); }} catch (error) {{ return error.message; }}
        }};
        const found = {{}}, given = Object.entries({json.dumps(given)});
        for (const [name, texts] of given) found[name] = texts.map((text) => read(name, text));
        const orbit = new Orbit(), box = {{ min: [-1, 0, -1], max: [1, 1, 1] }};
        const said = {{ target: read("camera-target", "0m 1m 2m"), fov: 40 }};
        orbit.place([read("camera-orbit", "-30deg 60deg 2.5m"), said], box, 1.5);
        console.log(JSON.stringify({{ ...found, camera: cameraText(orbit) }}));
    """
    actual = in_node(program)
    orbits = actual["camera-orbit"]
    assert orbits[0] == {"azimuth": 0, "elevation": 0, "distance": 2, "share": None}
    assert orbits[1] == {"azimuth": 1, "elevation": None, "distance": 1.5, "share": None}
    assert orbits[2]["share"] == 1.05 and orbits[2]["distance"] is None
    assert all(text.startswith("expected THETA PHI RADIUS") for text in orbits[3:])
    assert actual["camera-target"] == [[1, None, -0.2]]
    assert actual["field-of-view"][:2] == [pytest.approx(30), None]
    assert actual["sun"][:2] == [{"sun": 0}, {"sunAzimuth": 10, "sunHeight": 20, "sun": 1.5}]
    wrong = (actual["field-of-view"][2], actual["sun"][2], actual["samples"][1])
    assert [text.startswith("expected") for text in wrong] == [True] * 3
    camera = {
        "cameraOrbit": "-30deg 60deg 2.5m",
        "cameraTarget": "0m 1m 2m",
        "fieldOfView": "40deg",
    }
    assert actual["camera"] == camera


@pytest.mark.chromium
def test_two_elements_on_a_page(page, folder, url):
    show(page, folder, url, TWO)
    loads(page, "one")
    loads(page, "two")
    assert page.evaluate("[one.loaded, one.tier, one.availableTiers]") == [
        True,
        "small",
        ["small", "hq"],
    ]
    assert page.evaluate("[two.sun, one.sun]") == ["10deg 20deg 3", "none"]
    # A white page around it; nothing of the asset in the corner.
    pixel = """two.toBlob().then(createImageBitmap).then((image) => {
        const context = new OffscreenCanvas(64, 40).getContext("2d");
        context.drawImage(image, 0, 0);
        return [...context.getImageData(0, 0, 1, 1).data];
    })"""
    assert page.evaluate(pixel) == [255] * 4
    # What is shared shows the same again.
    page.evaluate(
        "Object.assign(one, { cameraOrbit: '-30deg 60deg 3m', lightRotation: '45deg' }), 0"
    )
    read = "[one.cameraOrbit, one.lightRotation]"
    assert page.evaluate(read) == ["-30deg 60deg 3m", "45deg"]
    assert page.evaluate("[heard.at(-1).name, heard.at(-1).source]") == ["light-change", "none"]
    page.evaluate("one.setAttribute('camera-orbit', 'far away'), 0")
    assert line(page).startswith("camera-orbit: expected THETA PHI RADIUS")
    page.evaluate("one.removeAttribute('camera-orbit'), 0")
    assert line(page) is None

    # The page keeps its scrolling, until somebody works with the element.
    def wheel() -> None:
        page.mouse("mouseWheel", 30, 20, deltaX=0, deltaY=100)

    distance = page.evaluate("one.stage.orbit.distance")
    wheel()
    page.wait_for("scrollY > 0", TIMEOUT)
    assert page.evaluate("one.stage.orbit.distance") == distance
    page.evaluate("scrollTo(0, 0), one.focus(), 0")
    page.wait_for("scrollY === 0", TIMEOUT)
    wheel()
    page.wait_for(f"one.stage.orbit.distance > {distance}", TIMEOUT)
    assert page.evaluate("[scrollY, getComputedStyle(one.stage.canvas).touchAction]") == [
        0,
        "pan-y",
    ]
    azimuth = page.evaluate("one.stage.orbit.azimuth")
    for _ in range(9):
        page.call("Input.dispatchKeyEvent", type="keyDown", key="ArrowLeft", code="ArrowLeft")
    assert page.evaluate("one.stage.orbit.azimuth") != azimuth
    page.wait_for("one.parts.status.textContent.startsWith('View from the')", TIMEOUT)
    assert page.evaluate("[heard.at(-1).name, heard.at(-1).source]") == [
        "camera-change",
        "user-interaction",
    ]
    named = "({ stage: { canvas } }) => [canvas.role, canvas.ariaLabel, canvas.tabIndex]"
    assert page.evaluate(f"[one, two].map({named})")[0] == ["application", "A tiny thing", 0]
    assert page.evaluate(f"[one, two].map({named})")[1][::2] == ["img", -1]

    # The GPU has no memory for a picture: a new engine shows the asset.
    page.evaluate("globalThis.before = one.stage.engine, before.error = new Error('no memory'), 0")
    page.evaluate("one.stage.viewer.restart()")
    page.wait_for(AGAIN, TIMEOUT)
    page.wait_for("one.notices.whole === null", TIMEOUT)


@pytest.mark.chromium
def test_the_page_of_the_documentation(page, folder, url):
    """With the export's script and a package, and nothing else, beside it."""
    text = (REPOSITORY / "docs" / "element.md").read_text()
    written = text.split("```html\n")[1].split("```")[0]
    assert set(re.findall(r'(?:src|poster|environment|scene)="([^"]+)"', written)) == {
        ELEMENT,
        "toy.rna",
    }
    make_tiny_package(folder / "toy.rna")
    write_image(folder / "studio.hdr", np.full((4, 8, 3), 0.25, np.float32))
    visit(page, folder, url, written)
    viewer = "document.querySelector('rna-viewer')"
    page.wait_for(f"{viewer}?.loaded", TIMEOUT)
    assert page.evaluate(f"{viewer}.stage.viewer.ground !== null")
    page.evaluate(f"{viewer}.environment = 'studio.hdr', 0")
    page.wait_for(f"{viewer}.stage.lighting.tables().floats[0] === 0.25", TIMEOUT)
    assert page.evaluate(f"{viewer}.notices.whole === null")


@pytest.mark.chromium
def test_the_line_that_export_prints(page, folder, url, capsys):
    """On a page of its own, with the light and the ground of the exported page."""
    package = make_tiny_package(folder / 'a "b".rna')
    assert rna_view([str(package), "--export", str(folder / "site")]) == 0
    printed = capsys.readouterr().out.split("or as an element: ")[1].splitlines()[0]
    written = printed.replace("https://example.org/site/", "site/")
    visit(page, folder, url, f"<!doctype html>{written}")
    viewer = "document.querySelector('rna-viewer')"
    page.wait_for(f"{viewer}?.loaded", TIMEOUT)
    assert page.evaluate(f"[{viewer}.alt, {viewer}.sun]") == [package.stem, "40deg 45deg 2"]
    assert page.evaluate(f"{viewer}.stage.viewer.ground !== null")
    assert f"{LIGHT}>" in viewer_file("index.html").decode()


@pytest.mark.chromium
def test_what_is_below_the_fold_waits(page, folder, url):
    """Nothing is fetched for it; what leaves the page lets its GPU go, and comes back as it was."""
    late = f'<rna-viewer id="one" src="tiny.rna" {SMALL}></rna-viewer>'
    closed = f'<rna-viewer id="two" src="fibers.rna" reveal="manual" {SMALL}></rna-viewer>'
    Static.requested.clear()
    show(page, folder, url, f'{closed}<div style="height: 2000px"></div>{late}')
    page.evaluate("new Promise((resolve) => setTimeout(resolve, 200))")
    assert not any(path.endswith(".rna") for path in Static.requested)
    page.evaluate("one.scrollIntoView(), 0")
    loads(page, "one")
    assert next(path for path in Static.requested if path.endswith(".rna")) == "/tiny.rna"
    gone = """globalThis.kept = one, globalThis.before = one.stage.engine;
        kept.cameraOrbit = "50deg 60deg 3m";
        document.body.prepend(kept);
        const later = new Promise((resolve) => setTimeout(resolve, 0));
        later.then(() => { kept.remove(); return kept.stage.engine === before; })"""
    assert page.evaluate(gone), "an element that moves within its page keeps its GPU"
    page.wait_for("before.closed && kept.stage.engine === null", TIMEOUT)
    requests = len(Static.requested)
    page.evaluate("document.body.prepend(kept), scrollTo(0, 0)")
    page.wait_for("kept.stage.viewer?.stats.rounds >= 1", TIMEOUT)
    assert page.evaluate("kept.cameraOrbit") == "50deg 60deg 3m"
    assert len(Static.requested) == requests
    page.evaluate("two.dismissPoster(), 0")
    loads(page, "two")
    assert page.evaluate("count('poster-dismissed', 'two')") == 1
    assert len(Static.requested) > requests


@pytest.mark.chromium
def test_sources_that_are_bad_or_change(page, folder, url):
    show(page, folder, url, f'<rna-viewer id="one" src="none.rna" {SMALL}></rna-viewer>')
    page.wait_for("count('error', 'one') === 1", TIMEOUT)
    assert line(page).endswith("none.rna: HTTP 404")
    page.evaluate("one.src = 'bad.rna', 0")
    page.wait_for("count('error', 'one') === 2", TIMEOUT)
    assert page.evaluate("[heard.at(-1).type, heard.at(-1).code]") == ["asset", "ZIP_NOT_ZIP"]
    # The last of three is shown, and only that one loads.
    page.evaluate("one.src = 'tiny.rna', one.src = 'fibers.rna', one.src = 'tiny.rna', 0")
    loads(page, "one")
    page.evaluate("new Promise((resolve) => setTimeout(resolve, 300))")
    assert page.evaluate("count('load', 'one')") == 1 and line(page) is None
    assert page.evaluate("one.stage.shown.parts[0].kind") == "surface"
    page.evaluate("one.tier = 'hq', 0")
    page.wait_for("one.stage.shown.name === 'hq'", TIMEOUT)


@pytest.mark.chromium
def test_auto_rotate_stops_for_those_who_want_stillness(page, folder, url):
    turning = 'auto-rotate auto-rotate-delay="0"'
    show(page, folder, url, f'<rna-viewer id="one" src="tiny.rna" {turning} {SMALL}></rna-viewer>')
    page.wait_for("one.turntableRotation > 0.1", TIMEOUT)
    assert page.evaluate("one.cameraOrbit").startswith("34.3775deg")
    stillness = [{"name": "prefers-reduced-motion", "value": "reduce"}]
    page.call("Emulation.setEmulatedMedia", features=stillness)
    page.wait_for("!one.turntable.isTurning", TIMEOUT)
    page.call("Emulation.setEmulatedMedia", features=[])
    page.wait_for("one.turntable.isTurning", TIMEOUT)
    page.evaluate("one.autoRotate = false, 0")
    finished(page)


@pytest.mark.chromium
def test_an_asset_too_large_then_losses_then_the_poster(page, folder, url):
    """A GPU that is too small; then one that is lost again and again."""
    show(page, folder, url, f'<rna-viewer id="one" loading="eager" {SMALL}></rna-viewer>')
    page.wait_for("one.stage.engine", TIMEOUT)
    page.evaluate("one.stage.engine.compiled.then(() => 0)")
    small = "{ limits: { value: { maxStorageBufferBindingSize: 1000 }, configurable: true } }"
    page.evaluate(f"Object.defineProperties(one.stage.engine.device, {small}), 0")
    page.evaluate("one.src = 'tiny.rna', 0")
    page.wait_for("count('error', 'one') === 1", TIMEOUT)
    assert line(page).endswith("this GPU allows 1 kB")
    page.evaluate("delete one.stage.engine.device.limits, one.src = 'fibers.rna', 0")
    loads(page, "one")
    for loss in range(1, 5):
        page.evaluate("globalThis.before = one.stage.engine, before.device.destroy()")
        if loss < 4:
            page.wait_for(AGAIN, TIMEOUT)
    page.wait_for("!one.stage.engine", TIMEOUT)
    assert line(page).startswith("the GPU was lost") and line(page).endswith(", 4 times")
    assert page.evaluate("[one.parts.poster.hidden, heard.at(-1).type]") == [False, "engine"]
