"""Places of the asset under the pointer, and children of the element that stay at such places."""

from typing import Any

import numpy as np
import pytest

from tests.package.builders import make_mesh, make_tiny_package
from tests.web.element_pages import SMALL, finished, line, loads, show
from tests.web.pages import TIMEOUT

pytestmark = pytest.mark.chromium

MESH = make_mesh()
CORNERS = MESH.positions[MESH.triangles].astype(np.float64)
JUMPS = 'interpolation-decay="0"'
BOXES = """Object.fromEntries([...one.children].map((own) => {
    const { left, top, width, height } = own.getBoundingClientRect();
    const isSeen = getComputedStyle(own).visibility === "visible" && width > 0;
    return [own.id, [left + width / 2, top + height / 2, isSeen, "visible" in own.dataset]];
}))"""


@pytest.fixture(scope="module")
def shown(page, folder, url):
    """A tetrahedron from the front, with a button on its front and one on its back."""
    make_tiny_package(folder / "spots.rna")
    view = 'camera-orbit="0deg 90deg 4m" camera-target="0m 0m 0m"'
    spots = "".join(
        f'<button id="{name}" slot="hotspot-{name}" data-position="{position}"'
        f' data-visibility-attribute="visible" style="width: 6px; height: 4px">{name}</button>'
        for name, position in (("front", "0m 0m 0.386m"), ("back", "0m -0.2m -0.708m"))
    )
    element = f'<rna-viewer id="one" src="spots.rna" camera-controls {view} {SMALL} {JUMPS}>'
    show(page, folder, url, f"{element}{spots}</rna-viewer>")
    loads(page, "one")


def nearest(origin: np.ndarray, direction: np.ndarray) -> tuple[float, np.ndarray] | None:
    """Distance and normal of the first triangle that a ray meets."""
    best = None
    for a, b, c in CORNERS:
        t, u, v = np.linalg.solve(np.transpose([-direction, b - a, c - a]), origin - a)
        if t > 0 and u >= 0 and v >= 0 and u + v <= 1 and (best is None or t < best[0]):
            best = t, np.cross(b - a, c - a)
    return best


@pytest.mark.usefixtures("shown")
def test_the_point_under_the_pointer(page):
    page.evaluate("one.cameraOrbit = '25deg 70deg 4m', 0")
    finished(page)
    camera: dict[str, Any] = page.evaluate("one.stage.viewer.shownCamera")
    seen = 0
    for x, y in ((32, 20), (28, 24), (38, 18), (30, 10), (40, 27), (2, 2)):
        name = f"one.positionAndNormalFromPoint({x}, {y})"
        actual = page.evaluate(f"(({{ position, normal }}) => [position, normal])({name} ?? {{}})")
        across, down = x * camera["width"] / 64, y * camera["height"] / 40
        direction = np.array(camera["corner"]) + across * np.array(camera["stepX"])
        direction += down * np.array(camera["stepY"])
        direction /= np.linalg.norm(direction)
        expected = nearest(np.array(camera["position"]), direction)
        if expected is None:
            assert actual == [None, None]
            continue
        seen += 1
        position = np.array(camera["position"]) + expected[0] * direction
        normal = expected[1] / np.linalg.norm(expected[1])
        assert list(actual[0].values()) == pytest.approx(position, abs=1e-5)
        assert list(actual[1].values()) == pytest.approx(normal, abs=1e-5)
    assert seen >= 3
    text = page.evaluate("String(one.positionAndNormalFromPoint(32, 20).position)")
    assert [word[-1] for word in text.split()] == ["m"] * 3


@pytest.mark.usefixtures("shown")
def test_spots_follow_and_are_hidden_by_the_asset(page):
    page.evaluate("one.cameraOrbit = '0deg 90deg 4m', 0")
    finished(page)
    front, back = (page.evaluate(BOXES)[name] for name in ("front", "back"))
    assert front == [pytest.approx(32, abs=0.6), pytest.approx(20, abs=0.6), True, True]
    assert back[2:] == [False, False]
    page.evaluate("one.cameraOrbit = '180deg 90deg 4m', 0")
    finished(page)
    front, back = (page.evaluate(BOXES)[name] for name in ("front", "back"))
    assert front[2:] == [False, False] and back[2:] == [True, True]
    y = 20 + 20 * 0.2 / ((4 - 0.708) * np.tan(np.radians(15)))
    assert back[:2] == [pytest.approx(32, abs=0.6), pytest.approx(y, abs=0.6)]
    # One that faces away is hidden, wherever it is; one that cannot be read is named.
    page.evaluate("back.dataset.normal = '0m 0m 1m', 0")
    page.wait_for("!('visible' in back.dataset)", TIMEOUT)
    page.evaluate("back.dataset.position = 'there', 0")
    page.wait_for("one.notices.whole", TIMEOUT)
    assert line(page).startswith("hotspot-back: expected X Y Z")
    page.evaluate("back.remove(), 0")
    page.wait_for("one.notices.whole === null", TIMEOUT)


TOUCHES = "touchStart", "touchMove", "touchMove", "touchEnd"


@pytest.mark.usefixtures("shown")
def test_two_fingers_and_keys_pan_and_limits_hold(page):
    page.evaluate("one.cameraOrbit = '0deg 90deg 4m', one.stage.canvas.focus(), 0")
    for key, name in (("d", "KeyD"), ("w", "KeyW")):
        page.call("Input.dispatchKeyEvent", type="keyDown", key=key, code=name)
    height = 2 * 4 * np.tan(np.radians(15))
    expected = [0.05 * height, 0.05 * height, 0]
    target = [float(word[:-1]) for word in page.evaluate("one.cameraTarget").split()]
    assert target == pytest.approx(expected, abs=1e-4)
    page.evaluate("one.resetView(), 0")
    at = [[20, 34], [44, 34]]  # beside the spots
    # The first movement tells what the two mean.
    for kind, shift in zip(TOUCHES, (0, 12, 16, None), strict=True):
        moved = [] if shift is None else [(x + shift, y) for x, y in at]
        points = [{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(moved)]
        page.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)
    x, y, _ = (float(word[:-1]) for word in page.evaluate("one.cameraTarget").split())
    assert x == pytest.approx(-0.1 * height, rel=0.1) and abs(y) < 0.02
    page.evaluate("one.resetView(), 0")
    before = page.evaluate("one.cameraOrbit")
    page.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": 20, "y": 36}])
    for y in range(36, 4, -4):
        page.call("Input.dispatchTouchEvent", type="touchMove", touchPoints=[{"x": 20, "y": y}])
    page.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
    assert page.evaluate("one.cameraOrbit") == before  # the page scrolled
    page.evaluate("scrollTo(0, 0), one.maxCameraOrbit = 'auto auto 3m', 0")
    assert page.evaluate("one.cameraOrbit") == "0deg 90deg 3m"
    page.evaluate("one.maxCameraOrbit = null, 0")


@pytest.mark.usefixtures("shown")
def test_the_prompt_is_for_those_who_have_not_moved_it(page):
    prompt = "one.parts.prompt.hidden"
    page.evaluate("one.hasMoved = false, one._prompt(), 0")
    page.wait_for(f"!{prompt}", TIMEOUT)
    # The event of a browser comes with its next frame, which a busy machine may not draw.
    changed = "one.stillness.dispatchEvent(new Event('change')), one.stage.isStill"
    stillness = [{"name": "prefers-reduced-motion", "value": "reduce"}]
    page.call("Emulation.setEmulatedMedia", features=stillness)
    assert page.evaluate(changed) and page.evaluate(prompt)
    page.call("Emulation.setEmulatedMedia", features=[])
    assert not page.evaluate(changed)
    page.wait_for(f"!{prompt}", TIMEOUT)
    page.evaluate("one.focus(), 0")
    page.call("Input.dispatchKeyEvent", type="keyDown", key="ArrowLeft", code="ArrowLeft")
    page.wait_for(prompt, TIMEOUT)
    page.evaluate("one._prompt(), new Promise((resolve) => setTimeout(resolve, 3500))")
    assert page.evaluate(prompt)


@pytest.mark.usefixtures("shown")
def test_the_camera_glides_to_where_it_is_put(page):
    page.evaluate("one.interpolationDecay = 500, one.resetView(), 0")
    page.evaluate("globalThis.turns = [], one.cameraOrbit = '350deg 60deg 4m', 0")
    assert page.evaluate("one.cameraOrbit") == "-10deg 60deg 4m"
    tell = "() => turns.push((one.stage.orbit.azimuth * 180) / Math.PI)"
    page.evaluate(f"one.stage.addEventListener('shown', {tell}), 0")
    page.wait_for("!one.stage.glide.goal", TIMEOUT)
    page.wait_for("one.stage.viewer.stats.rounds === 1 && !one.stage.viewer.moving", TIMEOUT)
    turns = page.evaluate("turns")
    # The shorter way, nearer with each picture, then all samples of the last one.
    assert len(turns) > 3 and turns == sorted(turns, reverse=True)
    assert 350 < turns[0] <= 360.001 and turns[-1] == pytest.approx(350)
    page.evaluate("one.stage.isStill = true, one.cameraOrbit = '20deg 60deg 4m', 0")
    assert page.evaluate("one.stage.glide.goal === null")
    page.evaluate("one.stage.isStill = false, one.interpolationDecay = 0, 0")


@pytest.mark.usefixtures("shown")
def test_pictures_come_where_changes_come_faster(page):
    """A picture that takes longer than the next change is shown all the same."""
    page.evaluate(
        """(() => {
        const { viewer, engine, orbit } = one.stage, done = engine.done;
        globalThis.pictures = 0;
        one.stage.addEventListener("shown", () => { pictures += 1; });
        engine.done = async () => {
            await new Promise((resolve) => setTimeout(resolve, 100));
            return done.call(engine);
        };
        const changing = setInterval(() => { orbit.turn(0.01, 0), viewer.restart(true); }, 15);
        globalThis.rest = () => {
            clearInterval(changing);
            engine.done = done;
            viewer.restart();
        };
    })()"""
    )
    page.wait_for("pictures >= 3", TIMEOUT)
    page.evaluate("rest()")
