"""The preview's render thread: it accumulates, starts again, and shows nothing that is over."""

import io
import signal
import threading
import time

import numba
import numpy as np
import pytest
from PIL import Image

from rna_render.paths.bands import render
from rna_render.paths.integrator_factory import make_integrator
from rna_render.paths.world_in_time import load_world
from rna_render.preview.change import Change
from rna_render.preview.lighting import Lighting, lighting_choices
from rna_render.preview.session import Session
from rna_render.scene.scene_file import read_scene
from rna_sdk.errors import QueryError, SceneError
from tests.render.assets import sphere
from tests.render.packages import ALBEDO, write_lambert_package

SCENE = """\
assets: [{path: ball.rna}]
camera: {position: [0, 0, 4], look_at: [0, 0, 0], vertical_fov_deg: 5}
lights: [{type: directional, direction: [0, 0, 1], irradiance: [1, 1, 1]}]
resolution: [32, 24]
samples: 4
"""


@pytest.fixture(scope="module")
def scene_file(tmp_path_factory):
    folder = tmp_path_factory.mktemp("preview")
    write_lambert_package(folder / "ball.rna", sphere(4))
    (folder / "scene.yaml").write_text(SCENE)
    return read_scene(folder / "scene.yaml")


@pytest.fixture(scope="module")
def world(scene_file):
    return load_world(scene_file)


@pytest.fixture
def session(scene_file, world):
    session = Session(scene_file, world, lighting_choices(scene_file.path))
    session.start()
    yield session
    session.stop()


def finished(session: Session, revision: int = 1):
    """The picture of all samples of a revision."""
    after = 0
    while (picture := session.wait(after, 30.0)) is not None:
        after = picture.label.serial
        if picture.label.revision == revision and picture.label.samples == 4:
            return picture
    raise AssertionError("no picture")


def test_it_accumulates_what_rna_run_renders(session, scene_file, world):
    seen, after = [], 0
    while not seen or seen[-1].label.samples < 4:
        picture = session.wait(after, 30.0)
        seen.append(picture)
        after = picture.label.serial
    samples = [picture.label.samples for picture in seen]
    assert samples == sorted(samples) and set(samples) <= {0, 1, 2, 3, 4}
    film = render(scene_file.scene, make_integrator(scene_file.scene, world))
    expected = np.stack([film.channels()[name] for name in "RGBA"], axis=-1)
    np.testing.assert_array_equal(seen[-1].rgba, expected)
    assert seen[-1].jpeg.startswith(b"\xff\xd8")
    # Then it rests.
    assert session.wait(after, 0.2) is None


def test_a_first_look_has_fewer_pixels(scene_file, world):
    session = Session(scene_file, world, lighting_choices(scene_file.path))
    sizes = []
    publish = session._publish
    session._publish = lambda label, rgba: (sizes.append(rgba.shape[:2]), publish(label, rgba))
    session.start()
    try:
        finished(session)
    finally:
        session.stop()
    assert sizes == [(2, 2), (3, 4), (6, 8), (12, 16)] + 4 * [(24, 32)]


@pytest.mark.parametrize(
    ("change", "red"),
    [
        # The camera sees the ball where the sun is low, then high, then where all light is even.
        ({"orbit_deg": (60, 0)}, 0.5 * ALBEDO[0] / np.pi),
        ({"orbit_deg": (60, 0), "light_rotation_deg": 60}, ALBEDO[0] / np.pi),
        ({"light_rotation_deg": -60}, 0.5 * ALBEDO[0] / np.pi),
        ({"lighting": "white"}, ALBEDO[0]),
    ],
)
def test_a_change_of_view_starts_again(session, change, red):
    finished(session)
    assert session.change(Change(**change))["revision"] == 2
    picture = finished(session, 2)
    assert np.median(picture.rgba[..., 0]) == pytest.approx(red, rel=0.1)


def test_denoising_is_switched_and_renders_nothing_again(scene_file, world):
    def white(rgb):
        return np.ones_like(rgb)

    session = Session(scene_file, world, lighting_choices(scene_file.path), denoiser=white)
    session.start()
    try:
        denoised = finished(session)
        assert session.state()["denoise"] is True and pixels(denoised).min() > 250
        assert session.change(Change(denoise=False))["revision"] == 1
        plain = session.wait(denoised.label.serial, 1.0)
        assert plain.label.samples == 4 and pixels(plain).min() < 200
    finally:
        session.stop()


def pixels(picture) -> np.ndarray:
    """What its JPEG shows."""
    return np.asarray(Image.open(io.BytesIO(picture.jpeg)))


def test_without_a_denoiser_there_is_none_to_switch(session):
    assert session.change(Change(denoise=True))["denoise"] is None
    assert finished(session).denoise is None


def test_exposure_renders_nothing_again(session):
    before = finished(session)
    assert session.change(Change(exposure=-3.0))["revision"] == 1
    after = session.wait(before.label.serial, 1.0)
    assert after.rgba is before.rgba and after.label.samples == 4
    assert len(after.jpeg) and after.jpeg != before.jpeg


def test_reset_is_the_scenes_own_camera(session, scene_file):
    session.change(Change(orbit_deg=(40.0, 20.0), dolly=2.0, pan=(0.1, 0.2)))
    state = session.change(Change(reset=True))
    camera = scene_file.scene.camera
    np.testing.assert_allclose(state["camera"]["position"], camera.position, atol=1e-12)
    assert state["camera"]["look_at"] == list(camera.look_at)


def test_nothing_old_is_handed_out_after_a_change(scene_file, world):
    """Many changes from one thread while another one waits for pictures all the time.

    On a busy machine there are more changes, until enough pictures were seen.
    """
    many = scene_file.with_changes(samples=100_000)
    session = Session(many, world, lighting_choices(scene_file.path))
    acknowledged, wrong, seen, over = 0, [], set(), threading.Event()

    def watch() -> None:
        while not over.is_set():
            known = acknowledged
            picture = session.wait(0, 1.0)
            if picture is not None:
                seen.add(picture.label.revision)
                if picture.label.revision < known:
                    wrong.append((picture.label, known))

    session.start()
    watcher = threading.Thread(target=watch)
    watcher.start()
    try:
        deadline = time.monotonic() + 60.0
        while acknowledged < 100 or (len(seen) <= 10 and time.monotonic() < deadline):
            acknowledged = session.change(Change(orbit_deg=(1.0, 0.0)))["revision"]
            time.sleep(0.01)
    finally:
        over.set()
        watcher.join()
        session.stop()
    assert not wrong and len(seen) > 10


def test_a_change_interrupts_a_sample_between_bands(scene_file, world, monkeypatch):
    monkeypatch.setattr("rna_render.preview.session.SMALL_BAND", 64)
    session = Session(scene_file, world, lighting_choices(scene_file.path))
    integrators = []

    class Counting:
        """An integrator whose view is changed while it renders its 34th band of 64 pixels."""

        def __init__(self, scene, world):
            self.groups, self.at_once, self.band, self.samples = (), None, 1 << 16, 1
            self._integrator, self.resolution = make_integrator(scene, world), scene.resolution
            self.bands, self._lock = 0, threading.Lock()
            integrators.append(self)

        def render(self, pixels, sampler):
            with self._lock:
                self.bands += 1
                number = self.bands
            if number == 34 and session.state()["revision"] == 1:
                session.change(Change(orbit_deg=(1.0, 0.0)))
            return self._integrator.render(pixels, sampler)

    monkeypatch.setattr("rna_render.preview.session.make_integrator", Counting)
    session.start()
    try:
        finished(session, 2)
    finally:
        session.stop()
    # A sample has 12 bands: the first view's third one is broken off after its tenth, or the bands
    # that threads had begun by then, the waiting one included.
    broken_off, whole = (i.bands for i in integrators if i.resolution == (32, 24))
    assert 34 <= broken_off <= 34 + numba.config.NUMBA_NUM_THREADS
    assert whole == 48


def test_lights_that_cannot_be_used_are_an_error_and_the_next_view_is_shown(
    scene_file, world, monkeypatch
):
    def refuse(scene, world):
        if not scene.lights:
            raise SceneError("no such image", file="sky.hdr")
        return make_integrator(scene, world)

    monkeypatch.setattr("rna_render.preview.session.make_integrator", refuse)
    choices = lighting_choices(scene_file.path) | {"bad": Lighting("bad", ())}
    session = Session(scene_file, world, choices)
    session.start()
    try:
        session.change(Change(lighting="bad"))
        picture = session.wait(0, 30.0)
        assert picture.label.error == "sky.hdr: no such image" and picture.jpeg == b""
        finished(session, session.change(Change(lighting="scene"))["revision"])
    finally:
        session.stop()


def test_an_unknown_choice_changes_nothing(session):
    with pytest.raises(QueryError, match="there is no 'moon'"):
        session.change(Change(lighting="moon"))
    assert session.state()["revision"] == 1


def test_what_ends_the_render_thread_ends_the_session(scene_file, world, monkeypatch):
    def fail(scene, world):
        raise MemoryError("too large")

    monkeypatch.setattr("rna_render.preview.session.make_integrator", fail)
    session = Session(scene_file, world, lighting_choices(scene_file.path))
    session.start()
    with pytest.raises(MemoryError, match="too large"):
        session.join()
    assert session.ended and session.wait(0, 10.0) is None


def test_stop_waits_for_the_render_thread_after_ctrl_c(scene_file, world, monkeypatch):
    """An interrupted Thread.join makes Python 3.11 believe that the thread has ended."""
    session = Session(scene_file, world, lighting_choices(scene_file.path))
    rendering, ended = threading.Event(), threading.Event()

    def slow(*_):
        rendering.set()
        time.sleep(1.0)
        ended.set()

    monkeypatch.setattr(session, "_render", slow)
    session.start()
    assert rendering.wait(30.0)
    ctrl_c = threading.main_thread().ident, signal.SIGINT
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # may be ignored so far
    try:
        threading.Timer(0.2, signal.pthread_kill, ctrl_c).start()
        with pytest.raises(KeyboardInterrupt):
            session.join()
    finally:
        signal.signal(signal.SIGINT, before)
    session.stop()
    assert ended.is_set()
