"""The poster and the first view are one camera; the poster stays until a picture is as sharp."""

import io
import json

import numpy as np
import pytest
from PIL import Image

from rna_export.export.poster_rendering import first_view, render_poster
from tests.package.builders import make_tiny_package
from tests.web.element_pages import finished, loads, show
from tests.web.in_node import ELEMENT_SOURCES, in_node
from tests.web.pages import TIMEOUT

SLOPE = np.tan(np.radians(15))


@pytest.mark.parametrize("size", [[0.4, 0.8, 0.4], [10.0, 0.2, 0.2], [1.0, 1.0, 1.0]])
def test_the_poster_has_the_viewers_camera(size):
    box = {"min": [-x / 2 for x in size], "max": [x / 2 for x in size]}
    program = f"""
        import {{ Orbit }} from "{(ELEMENT_SOURCES / "orbit.js").as_uri()}";
        const orbit = new Orbit();
        orbit.place([], {json.dumps(box)}, 1.6);
        console.log(JSON.stringify([orbit.distance, orbit.azimuth, orbit.elevation, orbit.fov]));
    """
    distance, slopes = first_view(np.array(size))
    assert in_node(program) == pytest.approx([distance, 0.6, 0.35, 30])
    assert max(slopes[0] / 1.6, slopes[1]) == pytest.approx(SLOPE)


@pytest.mark.chromium
@pytest.mark.parametrize(("width", "height"), [(320, 200), (160, 200)])
def test_nothing_jumps_where_the_poster_gives_way(page, folder, url, width, height):
    package = make_tiny_package(folder / "posed.rna")
    (folder / "posed.png").write_bytes(render_poster(package))
    style = f'style="width: {width}px; height: {height}px" samples="1" pixel-ratio="1"'
    poster = 'src="posed.rna" poster="posed.png" loading="eager"'
    show(page, folder, url, f'<rna-viewer id="one" {poster} {style} sun="none"></rna-viewer>')
    loads(page, "one")
    finished(page)
    seen = {}
    for name, change in (("poster", "showPoster"), ("picture", "dismissPoster")):
        page.evaluate(f"one.{change}(), one.parts.image.decode()")
        image = Image.open(io.BytesIO(page.screenshot())).convert("L")
        seen[name] = np.asarray(image)[:height, :width] < 250
    both, either = (
        np.logical_and(*seen.values()).sum(),
        np.logical_or(*seen.values()).sum(),
    )
    assert either > 1000 and both > 0.95 * either


DRAWS = """
import {{ Viewer }} from "{address}";
let rows = 0;
const engine = {{
  bandPixels: 1e6, resize(width, height) {{ this.target = {{ width, height }}; }},
  trace(camera, sample, from, to) {{ rows += to - from; }},
  light() {{}}, show() {{}}, async done() {{}},
}};
const viewer = new Viewer(engine, {{ width: 64, height: 40 }}, {{ camera: () => ({{}}) }});
viewer.addEventListener("shown", () => console.log(rows), {{ once: true }});
viewer.start();
await viewer.converged(1);
await viewer.stop();
"""


def test_the_first_picture_is_drawn_once():
    program = DRAWS.format(address=(ELEMENT_SOURCES / "viewer.js").as_uri())
    assert in_node(program) == 40


LEFT = """
<rna-viewer id="one" src="tiny.rna" poster="poster.png" alt="Tiny" loading="eager" samples="2"
  pixel-ratio="1" style="width: 192px; height: 120px"></rna-viewer>
<script>
  globalThis.steps = [];
  customElements.whenDefined("rna-viewer").then(() => {
    one.stage.addEventListener("engine", () => { one.stage.viewer.msPerPixel = 1; });
    one.stage.addEventListener("shown", () => {
      const { scale, rounds } = one.stage.viewer.stats;
      steps.push([scale, rounds, one.parts.poster.hidden, one.loaded]);
    });
  });
</script>
"""


@pytest.mark.chromium
def test_the_poster_stays_until_a_picture_is_of_a_quarter_of_the_size(page, folder, url):
    Image.new("RGB", (32, 20), "red").save(folder / "poster.png")
    show(page, folder, url, LEFT)
    page.wait_for("steps.some(([scale, rounds]) => scale === 1 && rounds === 2)", TIMEOUT)
    steps = page.evaluate("steps")
    assert steps[0] == [4, 1, False, False] and steps[1][2:] == [True, True]
    # Turning by itself, too, it is no blur.
    page.evaluate("one.stage.viewer.msPerPixel = 1, steps.length = 0, one.stage.turnTable(1, true)")
    page.wait_for("steps.length", TIMEOUT)
    assert page.evaluate("steps[0][0]") == 4
    # People who move it get what is fast enough.
    page.evaluate(
        "one.stage.viewer.msPerPixel = 1, steps.length = 0, one.stage.viewer.restart(true)"
    )
    page.wait_for("steps.length", TIMEOUT)
    assert page.evaluate("steps[0][0]") == 16


@pytest.mark.chromium
def test_a_sharp_poster_stays_until_the_picture_is_as_sharp(page, folder, url):
    """Or until somebody sees another view than the poster's."""
    Image.new("RGB", (192, 120), "red").save(folder / "sharp.png")
    left = LEFT.replace("poster.png", "sharp.png")
    show(page, folder, url, left)
    page.wait_for("steps.some(([scale, rounds]) => scale === 1 && rounds === 2)", TIMEOUT)
    steps = page.evaluate("steps")
    assert steps[1][3] and all(hidden == (scale == 1) for scale, _, hidden, _ in steps[1:])
    assert page.evaluate("count('poster-dismissed', 'one')") == 1
    # A coarse picture does not show through a poster's holes.
    faded = "getComputedStyle(one.stage.canvas).filter"
    assert page.evaluate(f"one.showPoster(), {faded}") == "opacity(0)"
    page.evaluate("one.cameraOrbit = '10deg 60deg 4m', 0")
    page.wait_for("one.parts.poster.hidden", TIMEOUT)
    assert page.evaluate(faded) == "none"


@pytest.mark.chromium
def test_without_a_poster_any_picture_is_shown_and_load_waits(page, folder, url):
    show(page, folder, url, LEFT.replace('poster="poster.png"', ""))
    page.wait_for("steps.some(([scale, rounds]) => scale === 1 && rounds === 2)", TIMEOUT)
    steps = page.evaluate("steps")
    assert [scale for scale, *_ in steps[:3]] == [16, 16, 4]
    assert [step[3] for step in steps[:4]] == [False, False, False, True]
