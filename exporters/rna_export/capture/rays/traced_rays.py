"""View rays answered twice: geometry by our scene, radiance by Cycles."""

from dataclasses import dataclass

import numpy as np

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.blender_process.exchanged_files import RenderedRays
from rna_export.capture.blender_process.lighting import Light
from rna_export.capture.rays.asset_scene import AssetScene, ShadePoints
from rna_export.capture.rays.view_rays import ViewRays

HIT = 0.999  # least alpha of an opaque hit
_STEP = 1e-4  # of the asset's radius, before and behind a point
_LEAST_OPACITY = 0.05  # of what is seen at a point: of less, the noise would be too much


@dataclass(frozen=True)
class TracedRays:
    """Rays, one row each.

    points: where they hit our scene. rendered: Cycles' answer along them. radiance: (n, 3) float32
    of the points' own: without what lies behind a point that transmits. valid: (n,) bool, which are
    samples.
    """

    rays: ViewRays
    points: ShadePoints
    rendered: RenderedRays
    radiance: np.ndarray
    valid: np.ndarray

    @classmethod
    def of(
        cls,
        scene: AssetScene,
        worker: BlenderWorker,
        rays: ViewRays,
        wi: Light,
        samples: int,
        seed: int,
        rng: np.random.Generator,
        opaque_cutouts: bool,
        normals: bool = False,
    ) -> "TracedRays":
        """Trace rays under one light.

        wi: towards the light, or another kind of it. rng: chooses which rays go on behind what lets
        light through. opaque_cutouts: whether rays are kept where Cycles' alpha is below 1.
        normals: whether Cycles answers them.
        """
        points = scene.shade_points(rays.origins, rays.directions, rng)
        origins, reach = _starts(scene, points, rays)
        rendered = worker.render_rays(origins, rays.directions, wi, samples, seed, reach, normals)
        # A ray along a silhouette may hit here and miss there; such a sample would be black.
        # What lets light through has an alpha that is as noisy as its radiance.
        thin = points.transmittance.any(axis=1)
        seen = opaque_cutouts | thin | (rendered.alpha > HIT)
        valid = points.hit & seen & np.isfinite(rendered.radiance).all(axis=1)
        radiance = rendered.radiance
        if scene.transmits:  # of what Cycles shows, the share that is the point's own
            opacity = 1.0 - points.transmittance
            valid &= opacity.max(axis=1) > _LEAST_OPACITY
            radiance = radiance / np.maximum(opacity, _LEAST_OPACITY)
        return cls(rays, points, rendered, radiance, valid)


def _starts(
    scene: AssetScene, points: ShadePoints, rays: ViewRays
) -> tuple[np.ndarray, float | None]:
    """Origins of Cycles' rays, and their length.

    At assets that transmit, close before the points and close behind them: what lies before a point
    on its ray has let the ray pass, and what lies behind it is not seen.
    """
    if not scene.transmits:
        return rays.origins, None
    step = np.float32(_STEP * scene.radius)
    points_or_origins = np.where(points.hit[:, None], points.position, rays.origins)
    return points_or_origins - step * rays.directions, float(2.0 * step)
