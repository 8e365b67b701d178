"""The same rays through our Embree scene and through Cycles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rna_export.capture.asset_scene import AssetScene
from rna_export.capture.view_rays import ViewRays, sample_view_rays
from rna_export.capture.weld import weld
from rna_export.capture.worker import BlenderWorker
from rna_render.bodies.surface import SurfacePoints


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
    scene = AssetScene([weld(worker.export_corners())])
    drawn = sample_view_rays(scene, wi, rays, "sphere", np.random.default_rng(5))
    points = scene.shade_points(drawn.origins, drawn.directions)
    rendered = worker.render_rays(drawn.origins, drawn.directions, wi, samples, seed=1)
    visible = scene.visible(points, np.ascontiguousarray(np.broadcast_to(wi, (rays, 3))))
    both = points.hit & (rendered.alpha > 0.999)
    kept = points.on[0].points.take(np.flatnonzero(both[points.hit]))
    missed = 1.0 - both.sum() / points.hit.sum()
    return Traced(
        drawn[both],
        kept,
        rendered.radiance[both],
        rendered.position[both],
        visible[both],
        float(missed),
    )
