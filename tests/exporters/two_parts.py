"""Datasets of two parts, a ball with strands on it, with a teacher in Blender's place."""

from pathlib import Path

import numpy as np

from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.blender_process.exchanged_files import RenderedRays
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.capture_tasks import all_tasks
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_manifest import CapturedPart
from rna_sdk.package import Curves, Mesh
from tests.exporters.meshes import sphere
from tests.exporters.synthetic import manifest_of
from tests.runtime.points import unit_vectors


def spikes(count: int, radius: float = 0.01) -> Curves:
    """Straight strands that stand on the unit ball."""
    out = unit_vectors(np.random.default_rng(5), count)
    points = (np.linspace(1.0, 1.5, 4)[:, None] * out[:, None]).reshape(-1, 3)
    radii = np.full(4 * count, radius, np.float32)
    return Curves(
        points.astype(np.float32), radii, np.arange(0, 4 * count + 1, 4).astype(np.uint32)
    )


class Teacher:
    """Answers rays with their direction as radiance."""

    def render_rays(self, origins, directions, wi, samples, seed, reach=None, normals=False):
        radiance = np.abs(directions) + np.float32(0.1)
        return RenderedRays(radiance, np.ones(len(origins)), origins, radiance / 2)


def hairy_ball(folder: Path) -> Dataset:
    """A ball with 60 thick strands: the parts `surface` and `hair`."""
    return make(folder, {"surface": sphere(4), "hair": spikes(60, radius=0.03)})


def make(folder: Path, geometries: dict[str, Mesh | Curves]) -> Dataset:
    parts = []
    for name, geometry in geometries.items():
        low, high = geometry.box()
        kind = "fiber" if isinstance(geometry, Curves) else "surface"
        bounds = tuple(low.tolist()), tuple(high.tolist())
        parts.append(CapturedPart(name=name, kind=kind, bounds=bounds))
    settings = CaptureSettings(
        rays=300, lights=4, lights_per_shard=2, validation_views=2, validation_resolution=48
    )
    manifest = manifest_of(settings, name="two", source="two.py", parts=tuple(parts))
    dataset = Dataset.create(folder, manifest, geometries)
    scene = scene_of(dataset)
    for task in all_tasks(dataset):
        task.run(dataset, scene, Teacher())
    return Dataset(folder)
