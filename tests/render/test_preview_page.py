"""`rna-run --preview` from the command to the page, in headless Chromium."""

import re
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import urlsplit

import numpy as np
import pytest

from rna_render.command.rna_run import main
from tests.render.assets import sphere
from tests.render.chromium import Page, open_page
from tests.render.packages import write_lambert_package
from tests.render.test_preview_session import SCENE

PICTURE = "document.getElementById('picture')"


@pytest.fixture(scope="module")
def scene_path(tmp_path_factory):
    """A ball lit from the side, so that its look changes with the camera."""
    folder = tmp_path_factory.mktemp("preview")
    write_lambert_package(folder / "ball.rna", sphere(4))
    text = SCENE.replace("direction: [0, 0, 1]", "direction: [1, 0, 0.2]")
    (folder / "scene.yaml").write_text(text.replace("vertical_fov_deg: 5", "vertical_fov_deg: 40"))
    return folder / "scene.yaml"


@contextmanager
def rna_run(scene_path: Path) -> Iterator[tuple[subprocess.Popen, str]]:
    """rna-run --preview, and the address that it prints."""
    arguments = [sys.executable, "-m", "rna_render.command.rna_run", scene_path, "--preview"]
    pipe = subprocess.PIPE
    with subprocess.Popen(arguments, stdout=pipe, stderr=pipe, text=True) as started:
        try:
            line = started.stdout.readline()
            actual = re.fullmatch(rf"preview of {scene_path} at (http://127\.0\.0\.1:\d+/)\n", line)
            if actual is None:
                started.kill()
                pytest.fail(line + started.stderr.read())
            assert started.stdout.readline() == "Ctrl-C ends it\n"
            yield started, actual[1]
        finally:
            started.kill()


@pytest.fixture(scope="module")
def url(scene_path):
    with rna_run(scene_path) as (_, url):
        yield url


@pytest.fixture
def page(url):
    with open_page() as page:
        page.call("Page.navigate", url=url)
        page.wait_for(f"{PICTURE}?.dataset.samples == 4")
        yield page


def pixels(page: Page) -> np.ndarray:
    """The picture on the page: (24, 32, 3) uint8."""
    script = f"[...{PICTURE}.getContext('2d').getImageData(0, 0, 32, 24).data]"
    return np.array(page.evaluate(script), np.uint8).reshape(24, 32, 4)[..., :3]


def finish(page: Page) -> np.ndarray:
    """The finished picture of what was asked for last."""
    idle = (
        "!rnaPreview.changes.sending && !rnaPreview.changes.pending"
        " && rnaPreview.shown === rnaPreview.state.revision"
    )
    page.wait_for(f"{idle} && {PICTURE}.dataset.samples == 4")
    return pixels(page)


def drag(page: Page, dx: float, **more: object) -> None:
    """A drag to the right from the picture's middle, in five steps."""
    box = "(({left, top, width, height}) => [left + width / 2, top + height / 2])"
    x, y = page.evaluate(f"{box}({PICTURE}.getBoundingClientRect())")
    button = {"button": "left", "clickCount": 1, **more}
    page.mouse("mousePressed", x, y, buttons=1, **button)
    for step in range(1, 6):
        page.mouse("mouseMoved", x + step * dx / 5, y, buttons=1, **button)
    page.mouse("mouseReleased", x + dx, y, **button)


def press(page: Page, key: str) -> None:
    for kind in ("keyDown", "keyUp"):
        page.call("Input.dispatchKeyEvent", type=kind, key=key)


@pytest.mark.chromium
def test_a_picture_is_there_and_orbits(page):
    first = pixels(page)
    # The ball is lit on the right, and has the scene's backdrop around it.
    assert first[12, 21, 0] > first[12, 10, 0] + 60  # red, which has no light from behind
    assert (first[0, 0] == first[-1, -1]).all()
    drag(page, 300)
    page.wait_for("rnaPreview.state.revision > 1")
    orbited = finish(page)
    assert np.abs(orbited.astype(int) - first).mean() > 5
    camera = page.evaluate("rnaPreview.state.camera")
    # The ball turns with the pointer, so the camera goes the other way: by 120 degrees.
    np.testing.assert_allclose(camera["position"], (-4 * np.sqrt(0.75), 0, -2), atol=1e-9)
    page.evaluate(f"{PICTURE}.focus()")
    press(page, "Home")
    page.wait_for("Math.abs(rnaPreview.state.camera.position[0]) < 1e-9")
    np.testing.assert_array_equal(finish(page), first)


@pytest.mark.chromium
def test_light_turns_by_drag_slider_and_keys(page):
    first = pixels(page)
    drag(page, 100, modifiers=8)  # with Shift
    page.wait_for("Math.abs(rnaPreview.state.light_rotation_deg - 40) < 1e-6")
    turned = finish(page)
    assert np.abs(turned.astype(int) - first).mean() > 2
    assert page.evaluate("rnaPreview.state.camera.position[2]") == pytest.approx(4.0)
    page.evaluate(f"{PICTURE}.focus()")
    press(page, "]")
    page.wait_for("Math.abs(rnaPreview.state.light_rotation_deg - 45) < 1e-6")
    page.evaluate("document.getElementById('rotation').focus()")
    assert page.evaluate("document.getElementById('rotation-value').textContent") == "+45°"
    page.evaluate("document.getElementById('reset').click()")
    page.wait_for("rnaPreview.state.light_rotation_deg === 0")
    np.testing.assert_array_equal(finish(page), first)


@pytest.mark.chromium
def test_environment_wheel_and_exposure(page):
    first = pixels(page)
    choose = "(e => { e.value = 'white'; e.dispatchEvent(new Event('change')); })"
    page.evaluate(f"{choose}(document.getElementById('lighting'))")
    page.wait_for("rnaPreview.state.lighting === 'white'")
    white = finish(page)
    assert white[12, 10, 0] > first[12, 10, 0] + 60
    slide = "(e => { e.value = -2; e.dispatchEvent(new Event('input')); })"
    page.evaluate(f"{slide}(document.getElementById('exposure'))")
    page.wait_for("rnaPreview.state.exposure === -2")
    page.wait_for(f"{PICTURE}.getContext('2d').getImageData(16, 12, 1, 1).data[0] < 180")
    page.mouse("mouseWheel", 300, 300, deltaX=0, deltaY=300)
    page.wait_for("rnaPreview.state.camera.position[2] > 5")
    assert finish(page)[12, 6].mean() < 60  # the ball has become smaller
    undo = '{"reset": true, "lighting": "scene", "exposure": 0}'
    page.evaluate(f"rnaPreview.request({undo})")
    page.wait_for("rnaPreview.state.lighting === 'scene'")


def end(started: subprocess.Popen) -> None:
    """Ctrl-C, and what comes of it."""
    started.send_signal(signal.SIGINT)
    assert started.wait(30) == 0
    assert started.stdout.read() == "\nthe preview has ended\n"
    assert started.stderr.read() == ""


@pytest.mark.chromium
def test_the_page_says_that_the_preview_has_ended(scene_path):
    with rna_run(scene_path) as (started, url), open_page() as page:
        page.call("Page.navigate", url=url)
        page.wait_for(f"{PICTURE}?.dataset.samples == 4")
        end(started)
        page.wait_for("!document.getElementById('notice').hidden")
        text = page.evaluate("document.getElementById('notice').textContent")
        assert "has ended" in text and f"--port {urlsplit(url).port}" in text


def test_ctrl_c_ends_it(scene_path):
    with rna_run(scene_path) as (started, _):
        end(started)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ([], "one of --png, --out and --preview is required"),
        (["--preview", "--out", "out.exr"], "--out is not for --preview"),
        (["--preview", "--png", "out.png"], "--png is not for --preview"),
        (["--out", "out.exr", "--port", "8000"], "--port is only for --preview"),
        (["--out", "out.exr", "--environments", "."], "--environments is only for --preview"),
        (["--preview", "--port", "0"], "from 1 to 65535"),
        (["--preview", "--environments", "no/such"], "no/such: no such folder"),
    ],
)
def test_bad_usage(scene_path, options, message, capsys):
    with pytest.raises(SystemExit) as caught:
        main([str(scene_path), *options])
    assert caught.value.code == 2 and message in capsys.readouterr().err


def test_a_port_that_is_taken_is_one_line(scene_path, capsys):
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        assert main([str(scene_path), "--preview", "--port", str(port)]) == 1
    error = capsys.readouterr().err
    assert error == f"error: cannot listen on 127.0.0.1:{port}: Address already in use\n"


def test_a_package_that_is_not_there_is_one_line(scene_path, tmp_path, capsys):
    (tmp_path / "scene.yaml").write_text(scene_path.read_text())
    assert main([str(tmp_path / "scene.yaml"), "--preview"]) == 1
    error = capsys.readouterr().err
    assert error.count("\n") == 1 and "assets[0].path: no such file" in error
