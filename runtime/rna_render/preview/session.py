"""The scene as the page sees it: a thread that renders the view, and starts again when it changes.

A view is rendered first with few pixels, as many as should take FIRST_LOOK_MS, then with more,
then with all, of which samples are added up. Every change of camera or light makes a new revision;
once `change` has returned, `wait` hands out no picture of an older one.
"""

import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from rna_render.image.film import Film, Layers
from rna_render.paths.bands import SMALL_BAND, rendered_bands
from rna_render.paths.integrator import Integrator
from rna_render.paths.integrator_factory import make_integrator
from rna_render.paths.sampling import Sampler
from rna_render.preview.change import Change
from rna_render.preview.lighting import SCENE_LIGHTS, Lighting, lit
from rna_render.preview.orbit import Orbit
from rna_render.preview.picture import Label, Picture, rgba
from rna_render.preview.scene_text import scene_text
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import Scene
from rna_render.world.world import World
from rna_sdk.errors import QueryError, RnaError

# Short enough that turning looks smooth.
FIRST_LOOK_MS = 80.0
# Of an image's sides, for first looks.
COARSEST = 16


@dataclass(frozen=True)
class View:
    """The shown view: camera, lighting, exposure, view transform, denoising."""

    orbit: Orbit
    lighting: str
    light_rotation_deg: float
    exposure: float
    view: str
    denoise: bool


class Session:
    """Renders one scene for any number of pages.

    world: the scene's, loaded. threads: to render with; all if None. choices: what the scene can
    be lit with. denoiser: what pages may switch off, from and to (h, w, 3) float32; None: there is
    none. It runs in threads of the server, one at a time.
    """

    def __init__(
        self,
        scene_file: SceneFile,
        world: World,
        choices: Mapping[str, Lighting],
        threads: int | None = None,
        denoiser: Callable[[np.ndarray], np.ndarray] | None = None,
    ) -> None:
        self._scene_file, self._world, self._choices = scene_file, world, choices
        self._threads, self._denoiser, self._denoising = threads, denoiser, threading.Lock()
        scene = scene_file.scene
        self._start = Orbit.of(scene.camera)
        self._ms_a_pixel: float | None = None  # of the last sample; the render thread's own
        self._thread = threading.Thread(target=self._run, name="preview", daemon=True)
        self._changed = threading.Condition()
        # All below is guarded by _changed.
        self._view = View(
            self._start, SCENE_LIGHTS, 0.0, scene.exposure, scene.view, denoiser is not None
        )
        self._revision = 1
        self._serial = 0
        self._picture: Picture | None = None  # of this revision
        self._stopping = False
        self._failure: BaseException | None = None

    def start(self) -> None:
        """Begin to render."""
        self._thread.start()

    def stop(self) -> None:
        """End the render thread, after the band of pixels under way."""
        with self._changed:
            self._stopping = True
            self._changed.notify_all()
        self._thread.join()

    def join(self) -> None:
        """Wait until the session ends. Raises the error that ended it, if that was not `stop`."""
        # Ctrl-C interrupts this wait, not Thread.join: Python 3.11 takes a thread whose join was
        # interrupted for ended, and `stop` would not wait for it.
        with self._changed:
            self._changed.wait_for(lambda: self._stopping)
        self._thread.join()
        if self._failure is not None:
            raise self._failure

    def change(self, change: Change) -> dict[str, object]:
        """Change the view, and return `state`. Raises QueryError for a lighting there is not."""
        if change.lighting is not None and change.lighting not in self._choices:
            raise QueryError(f"lighting: there is no {change.lighting!r}")
        with self._changed:
            before, self._view = self._view, _changed(self._view, change, self._start)
            view = self._view
            shown_alike = replace(
                before, exposure=view.exposure, view=view.view, denoise=view.denoise
            )
            if shown_alike != view:
                self._revision += 1
                self._picture = None
            elif self._picture is not None and before != self._view:
                label = replace(self._picture.label, serial=self._next_serial())
                self._picture = self._picture_of(label, self._picture.rgba)
            self._changed.notify_all()
            return self._state()

    def state(self) -> dict[str, object]:
        """State of the page's controls, as JSON."""
        with self._changed:
            return self._state()

    def newest(self) -> Picture | None:
        """The newest picture of the view, if there is one."""
        with self._changed:
            return self._picture

    def wait(self, after: int, timeout: float) -> Picture | None:
        """The newest picture, when its serial is above `after`; None after `timeout` seconds."""
        with self._changed:
            self._changed.wait_for(lambda: self._stopping or self._is_after(after), timeout)
            return self._picture if self._is_after(after) else None

    @property
    def ended(self) -> bool:
        """Whether no further picture will come."""
        with self._changed:
            return self._stopping

    def is_current(self, picture: Picture) -> bool:
        """Whether the view has not changed since."""
        with self._changed:
            return picture.label.revision == self._revision

    def _is_after(self, serial: int) -> bool:
        return self._picture is not None and self._picture.label.serial > serial

    def _state(self) -> dict[str, object]:
        scene, view, camera = self._scene_file.scene, self._view, self._view.orbit.camera()
        return {
            "scene": self._scene_file.path.name,
            "resolution": scene.resolution,
            "samples": scene.samples,
            "revision": self._revision,
            "choices": [{"key": k, "label": choice.label} for k, choice in self._choices.items()],
            "lighting": view.lighting,
            "light_rotation_deg": view.light_rotation_deg,
            "exposure": view.exposure,
            "view": view.view,
            "denoise": None if self._denoiser is None else view.denoise,
            "camera": camera.model_dump(mode="json"),
            "text": scene_text(self._seen(view), self._scene_file.path.parent),
        }

    def _picture_of(self, label: Label, picture: np.ndarray | None) -> Picture:
        """The picture with the view's exposure and denoiser, applied when it is encoded."""
        wanted = self._denoise if self._denoiser is not None and self._view.denoise else None
        return Picture(label, picture, self._view.exposure, self._view.view, wanted)

    def _denoise(self, rgb: np.ndarray) -> np.ndarray:
        assert self._denoiser is not None
        with self._denoising:
            return self._denoiser(rgb)

    def _next_serial(self) -> int:
        self._serial += 1
        return self._serial

    # What follows is run by the render thread.

    def _run(self) -> None:
        try:
            self._use_threads()
            done = 0
            while (revision := self._next_revision(done)) is not None:
                done = revision
                self._render(revision)
        except BaseException as error:
            self._failure = error
        finally:
            with self._changed:
                self._stopping = True
                self._changed.notify_all()

    def _use_threads(self) -> None:
        """Each thread has a number of its own."""
        from rna_sdk.machine.kernel_threads import limit_kernel_threads

        limit_kernel_threads(self._threads)

    def _next_revision(self, done: int) -> int | None:
        """Wait for a revision other than `done`; None when the session ends."""
        with self._changed:
            self._changed.wait_for(lambda: self._stopping or self._revision != done)
            return None if self._stopping else self._revision

    def _render(self, revision: int) -> None:
        """First looks, then samples, until all are there or the view has changed."""
        with self._changed:
            scene = self._seen(self._view)
        try:
            for divisor in self._divisors(scene.resolution):
                if self._is_old(revision):
                    return
                self._accumulate(revision, scene, divisor)
        except RnaError as error:
            self._publish(Label(0, revision, error=str(error)), None)

    def _seen(self, view: View) -> Scene:
        scene = lit(self._scene_file.scene, self._choices[view.lighting], view.light_rotation_deg)
        changes = {"camera": view.orbit.camera(), "exposure": view.exposure, "view": view.view}
        return scene.model_copy(update=changes)

    def _divisors(self, resolution: tuple[int, int]) -> Iterator[int]:
        """Divisors of the image's sides: from the first look's down to 1, by halves."""
        divisor = 1
        while divisor < COARSEST and self._expected_ms(resolution, divisor) > FIRST_LOOK_MS:
            divisor *= 2
        while divisor:
            yield divisor
            divisor //= 2

    def _expected_ms(self, resolution: tuple[int, int], divisor: int) -> float:
        if self._ms_a_pixel is None:
            return np.inf
        return self._ms_a_pixel * resolution[0] * resolution[1] / divisor**2

    def _accumulate(self, revision: int, scene: Scene, divisor: int) -> None:
        """All samples of the whole image, or one of a first look."""
        width, height = (max(1, round(side / divisor)) for side in scene.resolution)
        scene = scene.model_copy(update={"resolution": (width, height)})
        resolved = replace(self._scene_file, scene=scene).resolved
        integrator = make_integrator(resolved, self._world)
        film = Film(scene.resolution, integrator.groups)
        for number in range(scene.samples if divisor == 1 else 1):
            ms = self._add_sample(revision, integrator, film, Sampler(scene.seed, number))
            if ms is None:
                return
            self._ms_a_pixel = ms / (width * height)
            samples = film.samples if divisor == 1 else 0
            self._publish(Label(0, revision, samples, round(ms, 1)), rgba(film))

    def _add_sample(
        self, revision: int, integrator: Integrator, film: Film, sampler: Sampler
    ) -> float | None:
        """Add a sample to a film: the milliseconds that it took; None if the view has changed."""
        start = time.perf_counter()
        sample = self._sample(revision, integrator, film.width * film.height, sampler)
        if sample is None:
            return None
        film.add(sample)
        return 1e3 * (time.perf_counter() - start)

    def _sample(
        self, revision: int, integrator: Integrator, count: int, sampler: Sampler
    ) -> list[Layers] | None:
        """One sample of every pixel; None if the view has changed: small bands notice soon."""
        sample = []
        with closing(rendered_bands(integrator, count, [sampler], SMALL_BAND)) as bands:
            for band, _, _ in bands:
                if self._is_old(revision):
                    return None
                sample.append(band)
        return sample

    def _is_old(self, revision: int) -> bool:
        with self._changed:
            return self._stopping or self._revision != revision

    def _publish(self, label: Label, picture: np.ndarray | None) -> None:
        with self._changed:
            if label.revision == self._revision:
                label = replace(label, serial=self._next_serial())
                self._picture = self._picture_of(label, picture)
                self._changed.notify_all()


def _changed(view: View, change: Change, start: Orbit) -> View:
    """The view after a change."""
    orbit = start if change.reset else view.orbit
    if any(change.orbit_deg):
        orbit = orbit.turned(*np.radians(change.orbit_deg))
    if change.dolly != 1.0:
        orbit = orbit.dollied(change.dolly)
    if any(change.pan):
        orbit = orbit.panned(*change.pan)
    changes: dict[str, Any] = {
        "lighting": change.lighting,
        "light_rotation_deg": change.light_rotation_deg,
        "exposure": change.exposure,
        "view": change.view,
        "denoise": change.denoise,
    }
    return replace(view, orbit=orbit, **{k: v for k, v in changes.items() if v is not None})
