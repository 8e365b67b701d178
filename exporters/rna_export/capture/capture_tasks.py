"""Tasks of a capture: each renders one file of the dataset."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_manifest import emission_fields
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.sample_files import joined, write_parts
from rna_export.capture.rays.asset_scene import AssetScene, PartRows, ShadePoints
from rna_export.capture.rays.capture_directions import (
    direction_behind,
    directions_in,
    light_direction,
)
from rna_export.capture.rays.traced_rays import TracedRays
from rna_export.capture.rays.view_rays import ViewRays, sample_view_rays
from rna_render import Camera
from rna_render.scene import CameraModel
from rna_sdk.errors import CaptureError
from rna_sdk.package.manifest.manifest_fields import Region

_RAYS_A_RENDER = 65536  # of a validation image; keeps ray images small
_VALIDATION_FOV = np.radians(40.0)

LIT_FROM_BEHIND = (1, 3, 6)
"""Of eight validation images; the second of them is a close-up."""

_DIRECTIONS = ("wo", "wi")

Samples = dict[str, dict[str, np.ndarray]]
"""Part -> field -> rows."""


@dataclass(frozen=True)
class TrainingShard:
    """Samples of `lights_per_shard` light directions."""

    index: int

    def __str__(self) -> str:
        return f"training shard {self.index}"

    def path(self, dataset: Dataset) -> Path:
        return dataset.train_path(self.index)

    def paths_to_trace(self, dataset: Dataset) -> int:
        settings = dataset.manifest.settings
        return len(self._lights(dataset)) * settings.rays * settings.samples

    def run(self, dataset: Dataset, scene: AssetScene, worker: BlenderWorker) -> None:
        turns = _by_look(self._lights(dataset), dataset)
        lights = [self._light(dataset, scene, worker, light) for light in turns]
        write_parts(self.path(dataset), _all_rows(lights))

    def _lights(self, dataset: Dataset) -> range:
        settings = dataset.manifest.settings
        first = self.index * settings.lights_per_shard
        return range(first, min(first + settings.lights_per_shard, settings.lights))

    def _light(
        self, dataset: Dataset, scene: AssetScene, worker: BlenderWorker, light: int
    ) -> Samples:
        settings = dataset.manifest.settings
        domain = dataset.manifest.domain
        scene = _shown(dataset, scene, worker, light)
        wi = light_direction(light, settings.seed, domain.wi)
        rng = np.random.default_rng([settings.seed, 1, light])
        rays = sample_view_rays(scene, wi, settings.rays, domain.wo, rng)
        seed = int(rng.integers(2**31))
        return _capture(dataset, scene, worker, rays, wi, settings.samples, seed, rng)


@dataclass(frozen=True)
class ValidationHalf:
    """One of the two independent estimates of a validation image."""

    view: int
    half: int
    emission: bool = False  # of what the asset emits, instead of a light

    def __str__(self) -> str:
        return f"{'emission' if self.emission else 'validation'} image {self.view}-{self.half}"

    def path(self, dataset: Dataset) -> Path:
        path = dataset.emission_image_path if self.emission else dataset.validation_path
        return path(self.view, self.half)

    def paths_to_trace(self, dataset: Dataset) -> int:
        return dataset.manifest.settings.validation_paths // 2

    def run(self, dataset: Dataset, scene: AssetScene, worker: BlenderWorker) -> None:
        settings = dataset.manifest.settings
        # Every fourth view is a close-up: in each pose and print at times.
        scene = _shown(dataset, scene, worker, self.view + self.view // 4)
        rng = np.random.default_rng([settings.seed, 2, self.view])
        domain = dataset.manifest.domain
        wi = directions_in(domain.wi, rng.random((1, 2)))[0]
        rays, hit = _validation_rays(scene, settings, domain.wo, self.view, rng)
        if self.view % 8 in LIT_FROM_BEHIND:
            turns = np.random.default_rng([settings.seed, 8, self.view])
            wi = direction_behind(domain.wi, -rays.directions.mean(axis=0), turns)
        if self.emission:
            wi = None
        samples = settings.validation_samples // 2
        noise = np.random.default_rng([settings.seed, 3 + self.emission, self.view, self.half])
        seed = int(noise.integers(2**31))
        pieces = []
        for first in range(0, len(hit), _RAYS_A_RENDER):
            pixel = hit[first : first + _RAYS_A_RENDER]
            extra = {"pixel": pixel.astype(np.int32)}
            arguments = rays[pixel], wi, samples, seed, rng, extra
            pieces.append(_capture(dataset, scene, worker, *arguments))
        write_parts(self.path(dataset), _all_rows(pieces))


@dataclass(frozen=True)
class EmissionShard:
    """Samples of emission, as many as in a training shard."""

    index: int

    def __str__(self) -> str:
        return f"emission shard {self.index}"

    def path(self, dataset: Dataset) -> Path:
        return dataset.emission_path(self.index)

    def paths_to_trace(self, dataset: Dataset) -> int:
        settings = dataset.manifest.settings
        return settings.lights_per_shard * settings.rays * settings.samples

    def run(self, dataset: Dataset, scene: AssetScene, worker: BlenderWorker) -> None:
        settings, pieces = dataset.manifest.settings, []
        for k in _by_look(range(settings.lights_per_shard), dataset):
            rng = np.random.default_rng([settings.seed, 5, self.index, k])
            shown = _shown(dataset, scene, worker, k)
            rays = sample_view_rays(shown, None, settings.rays, dataset.manifest.domain.wo, rng)
            arguments = rays, None, settings.samples, int(rng.integers(2**31)), rng
            pieces.append(_capture(dataset, shown, worker, *arguments))
        write_parts(self.path(dataset), _all_rows(pieces))


Task = TrainingShard | ValidationHalf | EmissionShard


def all_tasks(dataset: Dataset) -> list[Task]:
    """Every task of the dataset's plan, validation and emission first."""
    manifest = dataset.manifest
    views = range(manifest.settings.validation_views)
    glowing = range(manifest.emission_images)
    return [
        *(ValidationHalf(view, half) for view in views for half in (0, 1)),
        *(ValidationHalf(view, half, emission=True) for view in glowing for half in (0, 1)),
        *(EmissionShard(k) for k in range(manifest.emission_shards)),
        *(TrainingShard(k) for k in range(manifest.shards)),
    ]


def _by_look(turns: Iterable[int], dataset: Dataset) -> list[int]:
    """Numbers of lights, those of one pose and print together: they take turns at these."""
    manifest = dataset.manifest
    return sorted(turns, key=lambda turn: turn % (manifest.pose_count * len(manifest.prints)))


def _shown(dataset: Dataset, scene: AssetScene, worker: BlenderWorker, turn: int) -> AssetScene:
    """The scene in the pose and the print whose turn it is, which Blender shows as well."""
    manifest = dataset.manifest
    turn, pose = divmod(turn, manifest.pose_count)
    if manifest.poses:
        worker.show_frame(manifest.poses[pose])
        scene = scene.in_pose(pose)
    if len(manifest.prints) > 1:
        number = turn % len(manifest.prints)
        variant = manifest.prints[number]
        worker.show_variant(None if variant is None else manifest.variants[variant])
        scene = scene.printed(number)
    return scene


def _all_rows(pieces: list[Samples]) -> Samples:
    return {part: joined([piece[part] for piece in pieces]) for part in pieces[0]}


def _capture(
    dataset: Dataset,
    scene: AssetScene,
    worker: BlenderWorker,
    rays: ViewRays,
    wi: np.ndarray | None,
    samples: int,
    seed: int,
    rng: np.random.Generator,
    extra: dict[str, np.ndarray] | None = None,
) -> Samples:
    """Samples of view rays under one light: geometry from our scene, radiance from Cycles.

    Those of a pose are recorded at rest: their points, and directions turned with these.

    wi: towards the light; None: of what the asset emits, without a light. rng: chooses which rays
    go on behind what lets light through.
    """
    cutouts = dataset.manifest.opaque_cutouts
    traced = TracedRays.of(scene, worker, rays, wi, samples, seed, rng, cutouts)
    points = traced.points
    of_ray = {
        "wo": -rays.directions,
        "radiance": traced.radiance,
        "direct": traced.rendered.direct,
        **_of_light(scene, points, wi),
        **(extra or {}),
    }
    return {
        part.name: _selected(on, traced.valid, of_ray, (*_fields(part, wi), *(extra or {})))
        for part, on in zip(dataset.parts, points.on, strict=True)
    }


def _fields(part: DatasetPart, wi: np.ndarray | None) -> Iterable[str]:
    return emission_fields(part.kind) if wi is None else part.fields


def _of_light(
    scene: AssetScene, points: ShadePoints, wi: np.ndarray | None
) -> dict[str, np.ndarray]:
    """Fields of samples that describe their light; none for the asset's emission."""
    if wi is None:
        return {}
    rows = np.ascontiguousarray(np.broadcast_to(wi.astype(np.float32), points.position.shape))
    visible = scene.visible(points, rows)
    scale = 255 if scene.transmits else 1
    return {"wi": rows, "visible": np.round(scale * visible.astype(np.float32)).astype(np.uint8)}


def _selected(
    on: PartRows, keep: np.ndarray, of_ray: dict[str, Any], fields: Iterable[str]
) -> dict[str, np.ndarray]:
    """The fields of the rows of one part to store."""
    selected, result = keep[on.rows], {}
    for name in fields:
        rows = on.fields[name] if name in on.fields else of_ray[name][on.rows]
        result[name] = (on.at_rest(rows) if name in _DIRECTIONS else rows)[selected]
    return result


def _validation_rays(
    scene: AssetScene, settings: CaptureSettings, wo: Region, view: int, rng: np.random.Generator
) -> tuple[ViewRays, np.ndarray]:
    """A view's rays and which of them hit; drawn again while, as through a ring, hardly any do."""
    best: tuple[ViewRays, np.ndarray] | None = None
    for _ in range(50):
        rays = _validation_camera(scene, settings, wo, view, rng)
        hit = np.flatnonzero(scene.part_hit(rays.origins, rays.directions) >= 0)
        if len(hit) > 0.01 * len(rays):
            return rays, hit
        if len(hit) and (best is None or len(hit) > len(best[1])):
            best = rays, hit
    if best is None:
        raise CaptureError(f"validation view {view}: found no camera position that sees the asset")
    return best  # of a wire, which is never more than a few pixels


def _validation_camera(
    scene: AssetScene, settings: CaptureSettings, wo: Region, view: int, rng: np.random.Generator
) -> ViewRays:
    """Rays through the pixel centres of a pinhole camera; every fourth view is a close-up."""
    region, fov = _camera_region(wo)
    axis = directions_in(region, rng.random((1, 2)))[0].astype(np.float64)
    zoom = 0.35 if view % 4 == 3 else 1.0
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
        return wo, _VALIDATION_FOV
    narrowest = min(cone.half_angle for cone in wo)
    fov = min(_VALIDATION_FOV, narrowest)
    inner = (c.model_copy(update={"half_angle": c.half_angle - fov / 2.0}) for c in wo)
    return tuple(inner), fov
