"""Where Cycles' image of the source and ours of the exported geometry differ."""

from dataclasses import dataclass

import numpy as np

from rna_export.capture.blender_process.exchanged_files import RenderedRays
from rna_export.capture.rays.asset_scene import AssetScene, ShadePoints
from rna_export.capture.rays.traced_rays import HIT
from rna_export.capture.rays.view_rays import ViewRays
from rna_trace import SurfacePoints

MISSING, EXTRA, ELSEWHERE, TURNED = "missing", "extra", "elsewhere", "turned"
KINDS = (MISSING, EXTRA, ELSEWHERE, TURNED)

APART = 1e-3  # of the asset's radius: quantised geometry moves hits by 1e-5
_TURN = np.cos(np.radians(30.0))  # normal maps of fewer texels than their images turn less
_REFLECTED = 0.01  # cosine of a mirrored ray: Cycles bends normals that give less
_EMPTY = 1.0 - HIT  # alpha of a ray that meets nothing
_SIGNIFICANT = 3.0  # standard errors
_FEWEST = 5  # rays: fewer are chance


@dataclass(frozen=True)
class Disagreement:
    """Rays that Cycles and our scene answer differently, (n,) bool a kind.

    missing: the exported geometry is hit, Cycles shows nothing, or less. extra: Cycles shows
    something, or more, where nothing is exported. elsewhere: both hit, at another point. turned:
    at the same point, with another normal. covered: what either shows. partly: what both show
    partly, which has noise; `excess` is the mean of our alpha less Cycles' there, 0 if noise
    explains it.
    """

    missing: np.ndarray
    extra: np.ndarray
    elsewhere: np.ndarray
    turned: np.ndarray
    covered: np.ndarray
    partly: np.ndarray
    excess: float

    @classmethod
    def of(
        cls,
        scene: AssetScene,
        rays: ViewRays,
        rendered: RenderedRays,
        samples: int,
        normals: bool,
        firm: np.ndarray | None = None,
    ) -> "Disagreement":
        """Compare Cycles' renders along rays from outside.

        samples: of each ray. normals: whether the exported ones are to be Cycles'. firm: (n,) bool,
        rays to compare; None for all.
        """
        ours, alpha = scene.coverage(rays.origins, rays.directions), rendered.alpha
        points = scene.shade_points(rays.origins, rays.directions)
        firm = np.ones(len(ours), bool) if firm is None else firm
        solid, empty = firm & (ours > HIT), firm & (ours < _EMPTY)
        partly = firm & ~solid & ~empty
        elsewhere, turned = other_hits(scene, rays, points, rendered, normals)
        return cls(
            missing=solid & (alpha < HIT),
            extra=empty & (alpha > _EMPTY),
            elsewhere=elsewhere & solid,
            turned=turned & solid,
            covered=firm & (~empty | (alpha > _EMPTY)),
            partly=partly,
            excess=_excess(ours[partly], alpha[partly], samples),
        )

    def shares(self) -> dict[str, float]:
        """Share of the covered rays of each kind."""
        counts = {kind: int(getattr(self, kind).sum()) for kind in KINDS}
        thin = abs(self.excess) * self.partly.sum()
        counts[MISSING if self.excess > 0.0 else EXTRA] += int(thin)
        covered = max(int(self.covered.sum()), 1)
        return {k: n / covered if n >= _FEWEST else 0.0 for k, n in counts.items()}

    @property
    def any(self) -> np.ndarray:
        """Rays of any kind, (n,) bool."""
        return np.asarray(self.missing | self.extra | self.elsewhere | self.turned)


def other_hits(
    scene: AssetScene, rays: ViewRays, points: ShadePoints, rendered: RenderedRays, normals: bool
) -> tuple[np.ndarray, np.ndarray]:
    """Rays that both hit, (n,) bool each: at different points; at one point with other normals."""
    both = points.hit & ~points.transmittance.any(axis=1) & (rendered.alpha > HIT)
    apart = np.linalg.norm(rendered.position - points.position, axis=1)
    elsewhere = both & ~(apart <= APART * scene.radius)
    turned = np.zeros(len(both), bool)
    if normals and rendered.normal is not None:
        turned = both & ~elsewhere & _turned(rays, points, rendered.normal)
    return elsewhere, turned


def _turned(rays: ViewRays, points: ShadePoints, normal: np.ndarray) -> np.ndarray:
    """(n,) bool: surfaces whose normals differ, where Cycles does not bend them."""
    result = np.zeros(len(rays), bool)
    for on in points.on:
        if not isinstance(on.points, SurfacePoints) or not len(on.rows):
            continue
        viewer = -rays.directions[on.rows]
        facing = np.sum(points.geometric_normal[on.rows] * viewer, axis=1)
        # Cycles turns normals of backs towards the viewer.
        side = np.sign(facing)[:, None]
        ours, flat = side * on.points.mapped, side * points.geometric_normal[on.rows]
        # Cycles' ensure_valid_specular_reflection: mirrored rays stay above the triangle.
        mirrored = 2.0 * np.sum(ours * viewer, axis=1, keepdims=True) * ours - viewer
        kept = np.sum(flat * mirrored, axis=1) >= np.minimum(0.9 * np.abs(facing), _REFLECTED)
        result[on.rows] = kept & (np.sum(ours * normal[on.rows], axis=1) < _TURN)
    return result


def _excess(ours: np.ndarray, alpha: np.ndarray, samples: int) -> float:
    """Mean of our alpha less Cycles', 0 where noise explains it: each sample passes or does not."""
    if not len(ours):
        return 0.0
    difference = float((ours - alpha).mean())
    noise = np.sqrt(float((ours * (1.0 - ours)).sum()) / samples) / len(ours)
    return difference if abs(difference) > _SIGNIFICANT * noise else 0.0
