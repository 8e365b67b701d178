"""Validation images of an `rna-make` run: small ones in its rounds, larger ones at its end."""

from collections.abc import Collection
from time import monotonic

from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.dataset.completeness import forget
from rna_export.capture.time_plan import IMAGE_SHARE, with_smaller_images
from rna_export.make.capture_rounds import Rays
from rna_export.make.make_progress import Stage
from rna_export.make.state import State

_A_REST = IMAGE_SHARE / (1.0 - IMAGE_SHARE)  # time of images over the time of all else, at most
_ROUND = 1.5  # time of a first round over the time of its rays, at least
_FEW_PATHS = 64  # a pixel: of the toy their noise has 43 dB alone (docs/decisions/capture.md)
_WORTH = 2.0  # times as many paths, from which new images are worth their time
_CHANGED = "validation_resolution", "validation_samples", "validation_views"


class RoundImages:
    """Sizes of the images, so that they take at most 15% of the time of a run.

    given: settings of the capture, by name, that stay as they are.
    """

    def __init__(self, rays: Rays, state: State, given: Collection[str]) -> None:
        self._rays, self._state, self._given = rays, state, given

    @property
    def are_noisy(self) -> bool:
        """Whether they were shrunk to so few paths a pixel that their noise would rule a PSNR."""
        return "validation_samples" not in self._given and (
            self._settings().validation_samples < _FEW_PATHS
        )

    def shrink(self, lights: int) -> None:
        """Plan images that fit to a first round of so many lights, if those planned are larger."""
        settings = self._settings()
        round_ = _ROUND * lights * settings.rays * settings.samples
        small = with_smaller_images(settings, _A_REST * round_, self._given)
        if small != settings:
            self._state.images = tuple(getattr(settings, name) for name in _CHANGED)
            self._change(small)

    def capture(self, seconds: float | None, stage: Stage) -> None:
        """Render those that are missing, or as many as the time allows."""
        begun, dataset = monotonic(), self._rays.dataset
        missing = [task for task in self._rays.images() if not task.path(dataset).is_file()]
        paths = sum(task.paths_to_trace(dataset) for task in missing)
        self._rays.capture_images(seconds, stage)
        self._state.image_seconds += monotonic() - begun
        self._state.image_paths += paths

    def grow(self, spent: float) -> bool:
        """Plan images as large as the run was long, once; returns whether they are to be rendered.

        spent: seconds of the run so far.
        """
        state, now = self._state, self._settings()
        if state.images is None:
            return False
        usual, state.images = state.images, None
        rest = spent - state.image_seconds
        seconds = _A_REST * rest - state.image_seconds
        if seconds <= 0.0:  # the small ones took longer than planned
            return False
        paths = seconds * state.image_paths / max(state.image_seconds, 1e-3)
        full = now.model_copy(update=dict(zip(_CHANGED, usual, strict=True)))
        larger = with_smaller_images(full, paths, self._given)
        if larger.held_out_paths < _WORTH * now.held_out_paths:
            return False
        self._change(larger)
        return True

    def _settings(self) -> CaptureSettings:
        return self._rays.dataset.manifest.settings

    def _change(self, settings: CaptureSettings) -> None:
        """Plan images of other sizes; the rendered images are of no use any more."""
        dataset = self._rays.dataset
        paths = [task.path(dataset) for task in self._rays.images()]
        forget(dataset, paths)
        for path in paths:
            path.unlink(missing_ok=True)
        dataset.change_settings({name: getattr(settings, name) for name in _CHANGED})
