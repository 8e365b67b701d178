"""Rays through our Embree scene and through Cycles."""

from dataclasses import dataclass

import numpy as np

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.capture_settings import SHARPEST
from rna_export.capture.geometry.exported_parts import ExportedParts
from rna_export.capture.geometry.mesh_cleanup import welded
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.view_rays import ViewRays, outside_rays, sample_view_rays
from rna_trace.surface import SurfacePoints


@dataclass(frozen=True)
class Traced:
    """Rows where Cycles and we both hit the asset; `missed` is the share of our hits it missed."""

    rays: ViewRays
    points: SurfacePoints
    radiance: np.ndarray  # (n, 3)
    cycles_position: np.ndarray  # (n, 3)
    visible: np.ndarray  # (n,) bool
    missed: float

    @property
    def front(self) -> np.ndarray:
        """Rows seen from outside, (n,) bool; an open surface has a back."""
        return np.sum(self.points.ng * self.rays.directions, axis=1) < 0.0


def unit(*vector: float) -> np.ndarray:
    """The direction, (3,) float32."""
    return (np.array(vector) / np.linalg.norm(vector)).astype(np.float32)


def trace(worker: BlenderWorker, wi: np.ndarray, rays: int = 2048, samples: int = 1) -> Traced:
    """View rays as a capture draws them, lit from `wi`."""
    scene = AssetScene([welded(worker.export_corners())[0]])
    drawn = sample_view_rays(scene, wi, rays, "sphere", np.random.default_rng(5))
    points = scene.shade_points(drawn.origins, drawn.directions)
    rendered = worker.render_rays(drawn.origins, drawn.directions, wi, samples, seed=1)
    visible = scene.visible(points, np.ascontiguousarray(np.broadcast_to(wi, (rays, 3))))
    both = points.hit & (rendered.alpha > 0.999)
    points_hit = points.on[0].points.take(np.flatnonzero(both[points.hit]))
    missed = 1.0 - both.sum() / points.hit.sum()
    return Traced(
        drawn[both],
        points_hit,
        rendered.radiance[both],
        rendered.position[both],
        visible[both],
        float(missed),
    )


def assert_same_holes(worker: BlenderWorker, exported: ExportedParts) -> None:
    """Cycles' alpha and position along view rays are ours, except for 0.5% of the rays.

    The alpha is that of the first hit and all behind it.
    """
    scene = scene_of(exported)
    drawn = outside_rays(scene, 2048, "sphere", np.random.default_rng(2))
    alpha = 1.0 - through(scene, drawn)
    rendered = worker.render_rays(drawn.origins, drawn.directions, unit(0.2, 1.0, 0.4), 64, seed=1)
    # 64 samples of an alpha between 0 and 1 have a standard deviation of 0.06.
    differs = np.abs(rendered.alpha - alpha) > 0.3
    assert differs.mean() < 0.005, f"{differs.mean():.1%} of the rays have another alpha"
    solid = (alpha > 0.999) & (rendered.alpha > 0.999)
    points = scene.shade_points(drawn.origins, drawn.directions)
    away = np.linalg.norm(rendered.position - points.position, axis=1)[solid] / scene.radius
    assert (away > 1e-3).mean() < 0.005, f"{(away > 1e-3).mean():.1%} of the hits lie elsewhere"


def scene_of(exported: ExportedParts) -> AssetScene:
    """Embree's scene of exported parts."""
    materials = exported.transmittances(), exported.normal_maps()
    return AssetScene(tuple(exported.geometries.values()), SHARPEST, *materials)


def through(scene: AssetScene, rays: ViewRays) -> np.ndarray:
    """(n,) the share of the light that goes through the whole asset along each ray."""
    left, near = np.ones(len(rays)), np.zeros(len(rays), np.float32)
    parts = scene._scene
    for _ in range(16):
        hits = parts.intersect(rays.origins, rays.directions, near)
        left *= parts.hit_transmittance(hits, rays.directions).mean(axis=1)
        met = hits.geometry >= 0
        near = np.where(met, np.nextafter(hits.t, np.float32(np.inf)) * np.float32(1 + 1e-6), near)
        near = np.where(met & (left > 0.0), near, np.float32(1e30))
    return left


def assert_same_cards(worker: BlenderWorker, exported: ExportedParts, cards: int) -> None:
    """Rays from above through squares of side 0.6 at x = k meet as much in Cycles as in ours."""
    rng = np.random.default_rng(4)
    side, rays = 512, cards * 512
    place = rng.uniform(-0.297, 0.297, (rays, 2))
    place[:, 0] += np.repeat(np.arange(cards), side)
    origins = np.column_stack([place[:, 0], np.ones(rays), place[:, 1]]).astype(np.float32)
    drawn = ViewRays(origins, np.tile(np.float32([0, -1, 0]), (rays, 1)))
    alpha = 1.0 - through(scene_of(exported), drawn)
    rendered = worker.render_rays(drawn.origins, drawn.directions, unit(0.2, 1.0, 0.4), 1, seed=1)
    differs = (np.abs(rendered.alpha - alpha) > 0.5).reshape(cards, side).mean(axis=1)
    assert differs.max() < 0.01, f"of the rays at each card another hit: {differs}"
