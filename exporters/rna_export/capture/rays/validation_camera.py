"""Cameras and lights of validation images: evenly spread, so that few images stand for all.

Close-ups and other views, and images lit from behind and others, each have a sequence of their own,
so that each kind is spread over all directions at any number of images.
"""

import numpy as np

from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.capture_directions import (
    GOLDEN,
    direction_seen_from,
    directions_in,
    spread_point,
)
from rna_export.capture.rays.view_rays import ViewRays
from rna_render import Camera
from rna_render.scene import CameraModel
from rna_sdk.errors import CaptureError
from rna_sdk.package.manifest.manifest_fields import Region

LIT_FROM_BEHIND = (1, 3, 6)
"""Indices among eight validation images."""
CLOSE_UPS = (3, 15)
"""Indices among sixteen validation images; the first one is lit from behind."""

_FOV = np.radians(40.0)


def validation_light(seed: int, region: Region, view: int, rays: ViewRays) -> np.ndarray:
    """The light of a view that has these rays, (3,) float32, in the region.

    Angles to the eye are spread evenly over the views lit from behind, and over the others.
    """
    number, behind = _place(view, 8, LIT_FROM_BEHIND)
    rank = (np.random.default_rng([seed, 8, int(behind)]).random() + number * GOLDEN) % 1.0
    rng = np.random.default_rng([seed, 9, view])
    return direction_seen_from(region, -rays.directions.mean(axis=0), behind, rank, rng)


def validation_rays(
    scene: AssetScene, settings: CaptureSettings, wo: Region, view: int, rng: np.random.Generator
) -> tuple[ViewRays, np.ndarray]:
    """A view's rays and which of them hit; drawn again while, as through a ring, hardly any do."""
    best: tuple[ViewRays, np.ndarray] | None = None
    number, close_up = _place(view, 16, CLOSE_UPS)
    u = spread_point(number, [settings.seed, 10, int(close_up)])
    for _ in range(50):
        rays = _camera_rays(scene, settings, wo, close_up, u)
        hit = np.flatnonzero(scene.part_hit(rays.origins, rays.directions) >= 0)
        if len(hit) > 0.01 * len(rays):
            return rays, hit
        if len(hit) and (best is None or len(hit) > len(best[1])):
            best = rays, hit
        u = rng.random(2)
    if best is None:
        raise CaptureError(f"validation view {view}: found no camera position that sees the asset")
    return best  # of a wire, which is never more than a few pixels


def _place(view: int, turn: int, chosen: tuple[int, ...]) -> tuple[int, bool]:
    """Number of a view among those of its kind, and whether its place in a turn is a chosen one."""
    rounds, place = divmod(view, turn)
    if place in chosen:
        return rounds * len(chosen) + chosen.index(place), True
    return rounds * (turn - len(chosen)) + place - sum(k < place for k in chosen), False


def _camera_rays(
    scene: AssetScene, settings: CaptureSettings, wo: Region, close_up: bool, u: np.ndarray
) -> ViewRays:
    """Rays through the pixel centres of a pinhole camera; u: (2,), where it is in the region."""
    region, fov = _camera_region(wo)
    axis = directions_in(region, u[None])[0].astype(np.float64)
    zoom = 0.35 if close_up else 1.0
    model = CameraModel(
        position=tuple(scene.centre + axis * scene.radius / np.sin(fov / 2)),
        look_at=tuple(scene.centre.astype(np.float64)),
        vertical_fov_deg=np.degrees(2.0 * np.arctan(zoom * np.tan(fov / 2))),
    )
    n = settings.validation_resolution
    camera = Camera(model, (n, n))
    d = camera.directions(np.arange(n * n, dtype=np.uint32), np.full((n * n, 2), 0.5))
    return ViewRays(np.tile(camera.position, (n * n, 1)), d)


def _camera_region(wo: Region) -> tuple[Region, float]:
    """Region of the validation cameras' axes, and their field of view.

    Of cones, so that what the images see of the asset is seen from inside: half of a cone's angle
    is the axis's, the other half the image's.
    """
    if isinstance(wo, str):
        return wo, _FOV
    narrowest = min(cone.half_angle for cone in wo)
    fov = min(_FOV, narrowest)
    inner = (c.model_copy(update={"half_angle": c.half_angle - fov / 2.0}) for c in wo)
    return tuple(inner), fov
