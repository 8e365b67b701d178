"""Tasks of a capture: each renders one file of the dataset."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.blender_process.lighting import WhiteWorld
from rna_export.capture.capture_settings import WHITE_RAYS
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_manifest import emission_fields, white_fields
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.sample_files import joined, write_parts
from rna_export.capture.rays.asset_scene import AssetScene, PartRows, ShadePoints
from rna_export.capture.rays.capture_directions import light_direction
from rna_export.capture.rays.traced_rays import TracedRays
from rna_export.capture.rays.validation_camera import validation_light, validation_rays
from rna_export.capture.rays.view_rays import ViewRays, hitting_rays, sample_view_rays
from rna_sdk.runtime import in_region

_RAYS_A_RENDER = 65536  # of a validation image; keeps ray images small

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
        look = _Look.of(dataset, scene, worker, light)
        wi = light_direction(light, settings.seed, domain.wi)
        rng = np.random.default_rng([settings.seed, 1, light])
        rays = sample_view_rays(look.scene, wi, settings.rays, domain.wo, rng)
        return look.capture(rays, wi, settings.samples, int(rng.integers(2**31)), rng)


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
        # Close-ups are 12 and 4 views apart: they are in each pose and print at times.
        look = _Look.of(dataset, scene, worker, self.view + self.view // 4)
        rng = np.random.default_rng([settings.seed, 2, self.view])
        domain = dataset.manifest.domain
        rays, hit = validation_rays(look.scene, settings, domain.wo, self.view, rng)
        wi = None if self.emission else validation_light(settings.seed, domain.wi, self.view, rays)
        samples = settings.validation_samples // 2
        noise = np.random.default_rng([settings.seed, 3 + self.emission, self.view, self.half])
        seed = int(noise.integers(2**31))
        pieces = []
        for first in range(0, len(hit), _RAYS_A_RENDER):
            pixel = hit[first : first + _RAYS_A_RENDER]
            extra = {"pixel": pixel.astype(np.int32)}
            pieces.append(look.capture(rays[pixel], wi, samples, seed, rng, extra))
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
            look, wo = _Look.of(dataset, scene, worker, k), dataset.manifest.domain.wo
            rays = sample_view_rays(look.scene, None, settings.rays, wo, rng)
            seed = int(rng.integers(2**31))
            pieces.append(look.capture(rays, None, settings.samples, seed, rng))
        write_parts(self.path(dataset), _all_rows(pieces))


@dataclass(frozen=True)
class WhiteRays:
    """Rays from outside in a white world, with samples of its light: see `WhiteView`."""

    def __str__(self) -> str:
        return "rays in a white world"

    def path(self, dataset: Dataset) -> Path:
        return dataset.white_path

    def paths_to_trace(self, dataset: Dataset) -> int:
        return dataset.manifest.settings.white_paths

    def run(self, dataset: Dataset, scene: AssetScene, worker: BlenderWorker) -> None:
        manifest, pieces = dataset.manifest, []
        looks = manifest.pose_count * len(manifest.prints)
        for k in range(looks):
            rng = np.random.default_rng([manifest.settings.seed, 11, k])
            look = _Look.of(dataset, scene, worker, k)
            rays = hitting_rays(look.scene, -(-WHITE_RAYS // looks), manifest.domain.wo, rng)
            pieces += look.capture_white(rays, rng)
        write_parts(self.path(dataset), _all_rows(pieces))


Task = TrainingShard | ValidationHalf | EmissionShard | WhiteRays


def all_tasks(dataset: Dataset) -> list[Task]:
    """Every task of the dataset's plan, validation and emission first."""
    manifest = dataset.manifest
    views = range(manifest.settings.validation_views)
    glowing = range(manifest.emission_images)
    return [
        *(ValidationHalf(view, half) for view in views for half in (0, 1)),
        WhiteRays(),  # of as many paths: Blender starts anew for another number
        *(ValidationHalf(view, half, emission=True) for view in glowing for half in (0, 1)),
        *(EmissionShard(k) for k in range(manifest.emission_shards)),
        *(TrainingShard(k) for k in range(manifest.shards)),
    ]


def _by_look(turns: Iterable[int], dataset: Dataset) -> list[int]:
    """Numbers of lights, those of one pose and print together: they take turns at these."""
    manifest = dataset.manifest
    return sorted(turns, key=lambda turn: turn % (manifest.pose_count * len(manifest.prints)))


def _all_rows(pieces: list[Samples]) -> Samples:
    return {part: joined([piece[part] for piece in pieces]) for part in pieces[0]}


@dataclass(frozen=True)
class _Look:
    """The asset in one pose and print, in our scene, and in Blender."""

    dataset: Dataset
    scene: AssetScene
    worker: BlenderWorker

    @classmethod
    def of(cls, dataset: Dataset, scene: AssetScene, worker: BlenderWorker, turn: int) -> "_Look":
        """The pose and the print whose turn it is; Blender shows them from now on."""
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
        return cls(dataset, scene, worker)

    def capture(
        self,
        rays: ViewRays,
        wi: np.ndarray | None,
        samples: int,
        seed: int,
        rng: np.random.Generator,
        extra: dict[str, np.ndarray] | None = None,
    ) -> Samples:
        """Samples of view rays under one light: geometry from our scene, radiance from Cycles.

        Those of a pose are recorded at rest: their points, and directions turned with these.

        wi: towards the light; None: of what the asset emits, without a light. rng: chooses which
        rays go on behind what lets light through.
        """
        cutouts = self.dataset.manifest.opaque_cutouts
        traced = TracedRays.of(self.scene, self.worker, rays, wi, samples, seed, rng, cutouts)
        points = traced.points
        of_ray = {
            "wo": -rays.directions,
            "radiance": traced.radiance,
            "direct": traced.rendered.direct,
            **_of_light(self.scene, points, wi),
            **(extra or {}),
        }
        return {
            part.name: _selected(on, traced.valid, of_ray, (*_fields(part, wi), *(extra or {})))
            for part, on in zip(self.dataset.parts, points.on, strict=True)
        }

    def capture_white(self, rays: ViewRays, rng: np.random.Generator) -> list[Samples]:
        """The rays' radiance in a white world, once with each of the `LIGHTS` directions of a ray.

        Light from outside of the domain is neither in the world nor, by a weight of 0, in the
        samples.
        """
        region, cutouts = self.dataset.manifest.domain.wi, self.dataset.manifest.opaque_cutouts
        seed, wo = int(rng.integers(2**31)), -rays.directions
        samples = self.dataset.manifest.settings.validation_samples // 2
        traced = TracedRays.of(
            self.scene, self.worker, rays, WhiteWorld(region), samples, seed, rng, cutouts
        )
        on_parts, pieces = traced.points.on, []
        lights = [
            shape.light_samples(on.points, wo[on.rows], rng)
            for shape, on in zip(self.scene.shapes, on_parts, strict=True)
        ]
        for of_parts in zip(*lights, strict=True):
            wi, weight = np.zeros_like(wo), np.zeros(len(wo), np.float32)
            for on, one in zip(on_parts, of_parts, strict=True):
                wi[on.rows] = one.wi
                weight[on.rows] = in_region(region, one.wi) / one.pdf
            of_ray = {"wo": wo, "radiance": traced.radiance, "weight": weight}
            of_ray |= {"wi": wi, "visible": _visibility(self.scene, traced.points, wi)}
            pieces.append(
                {
                    part.name: _selected(on, traced.valid, of_ray, white_fields(part.fields))
                    for part, on in zip(self.dataset.parts, on_parts, strict=True)
                }
            )
        return pieces


def _fields(part: DatasetPart, wi: np.ndarray | None) -> Iterable[str]:
    return emission_fields(part.kind) if wi is None else part.fields


def _of_light(
    scene: AssetScene, points: ShadePoints, wi: np.ndarray | None
) -> dict[str, np.ndarray]:
    """Fields of samples that describe their light; none for the asset's emission."""
    if wi is None:
        return {}
    rows = np.ascontiguousarray(np.broadcast_to(wi.astype(np.float32), points.position.shape))
    return {"wi": rows, "visible": _visibility(scene, points, rows)}


def _visibility(scene: AssetScene, points: ShadePoints, wi: np.ndarray) -> np.ndarray:
    """Visibility along wi (n, 3), as samples record it: uint8, 255 times one with colours."""
    visible = scene.visible(points, wi).astype(np.float32)
    return np.round((255 if scene.transmits else 1) * visible).astype(np.uint8)


def _selected(
    on: PartRows, keep: np.ndarray, of_ray: dict[str, Any], fields: Iterable[str]
) -> dict[str, np.ndarray]:
    """The fields of the rows of one part to store."""
    selected, result = keep[on.rows], {}
    for name in fields:
        rows = on.fields[name] if name in on.fields else of_ray[name][on.rows]
        result[name] = (on.at_rest(rows) if name in _DIRECTIONS else rows)[selected]
    return result
