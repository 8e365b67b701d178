"""Plan of a time-limited capture: reduced validation images, then lights and their rays."""

from collections.abc import Collection
from dataclasses import dataclass, field
from time import monotonic

from rna_export.capture.capture_settings import MAX_LIGHTS, CaptureSettings
from rna_sdk.errors import CaptureError

LEAST_LIGHTS, LEAST_IMAGES = 16, 2

IMAGE_SHARE = 0.15
"""Largest share of the time for validation images."""
_PLANNED_SHARE = 0.12  # so that a machine that slows down stays below
_LEAST_RESOLUTION, _LEAST_SAMPLES, _LEAST_VIEWS = 48, 16, 16
_LEAST_RAYS = 1024  # of a light, of surfaces
_DAY = 24 * 60  # minutes


@dataclass(frozen=True)
class TimeLimit:
    """Minutes from now on, of which a share is for a capture."""

    minutes: float
    begun: float = field(default_factory=monotonic)
    share: float = 1.0

    def left(self) -> float:
        """Seconds."""
        return 60.0 * self.minutes * self.share - (monotonic() - self.begun)


def planned(
    settings: CaptureSettings,
    kind: str,
    limit: TimeLimit,
    opening: float,
    rate: float,
    given: Collection[str],
) -> CaptureSettings:
    """The settings with as many lights as there is time for at `rate` paths a second.

    Validation images that took more than 12% of all minutes are made smaller, except what was
    `given`. Where there is time for fewer lights than `settings` have, those of surfaces have fewer
    rays (docs/decisions/capture.md).

    kind: "surface", "fiber" or "both". opening: seconds until a worker can render. Raises
    `CaptureError` when fewer than 16 lights are left.
    """
    left = limit.left()
    usual, images = settings, 60.0 * _PLANNED_SHARE * limit.minutes * rate
    settings, lights = _fitting(settings, (left - opening) * rate, images, given)
    if lights < LEAST_LIGHTS:
        start = 60.0 * limit.minutes * limit.share - left + opening  # seconds without rays
        enough = _enough_minutes(usual, start, limit.share, rate, given)
        do = "give more minutes" if enough is None else f"--minutes {enough} would do"
        raise CaptureError(
            f"--minutes {limit.minutes:g} leaves time for {max(lights, 0)} lights after the start "
            f"and the validation images, expected at least {LEAST_LIGHTS}: {do}"
        )
    rays = settings.rays
    if kind == "surface" and "rays" not in given and lights < settings.lights:
        rays = max(_LEAST_RAYS, rays * lights // settings.lights)
    lights = min(lights * settings.rays // rays, MAX_LIGHTS)
    return settings.model_copy(update={"lights": lights, "rays": rays}).shared_out()


def _fitting(
    settings: CaptureSettings, paths: float, images: float, given: Collection[str]
) -> tuple[CaptureSettings, int]:
    """Settings with validation images that fit, and the lights that the rest of the paths are for.

    images: paths of validation images at most.
    """
    settings = with_smaller_images(settings, images, given)
    left = max(paths, 0.0) - settings.held_out_paths
    return settings, min(int(left / (settings.rays * settings.samples)), MAX_LIGHTS)


def _enough_minutes(
    settings: CaptureSettings, start: float, share: float, rate: float, given: Collection[str]
) -> int | None:
    """The least whole minutes with time for enough lights; None for more than a day."""
    for minutes in range(1, _DAY):
        seconds = 60.0 * minutes
        paths, images = (seconds * share - start) * rate, seconds * _PLANNED_SHARE * rate
        if _fitting(settings, paths, images, given)[1] >= LEAST_LIGHTS:
            return minutes
    return None


def shrunk(before: CaptureSettings, after: CaptureSettings) -> str | None:
    """Note about reduced validation images; None if they are unchanged."""
    if before.held_out_paths == after.held_out_paths:
        return None
    return (
        f"{_images(after)} instead of {_images(before)}, "
        f"to leave {1.0 - IMAGE_SHARE:.0%} of the minutes to rays and training"
    )


def _images(settings: CaptureSettings) -> str:
    side = settings.validation_resolution
    return (
        f"{settings.validation_views} validation images of {side}x{side} with "
        f"{settings.validation_samples} paths a pixel"
    )


def with_smaller_images(
    settings: CaptureSettings, most_paths: float, given: Collection[str]
) -> CaptureSettings:
    """Settings with validation images of at most so many paths, all together.

    They have fewer pixels and fewer paths a pixel, each by the same factor as far as both may
    shrink. Where that is not enough, there are fewer of them: by fewer than 16 an error depends on
    their luck. Settings by name that were `given` stay.
    """

    def share() -> float:
        return most_paths / settings.held_out_paths

    def changed(name: str, value: int) -> CaptureSettings:
        return settings if name in given else settings.model_copy(update={name: value})

    if share() >= 1.0:
        return settings
    side, samples = settings.validation_resolution, settings.validation_samples
    smaller = side * share() ** (0.5 if "validation_samples" in given else 0.25)
    least = max(_LEAST_RESOLUTION, 8 * int(smaller / 8))
    settings = changed("validation_resolution", min(side, least))
    least = max(_LEAST_SAMPLES, 2 * int(samples * share() / 2))
    settings = changed("validation_samples", min(samples, least))
    views = settings.validation_views
    least = max(_LEAST_VIEWS, 8 * int(views * share() / 8))
    return changed("validation_views", min(views, least))
