"""Error of scattered light at points of strands, each in several views and under several lights."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from rna_bench.accuracy.crossed_variance import crossed_parts
from rna_bench.accuracy.strand_light import strand_light
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.rays.asset_scene import AssetScene, ShadePoints
from rna_export.capture.rays.capture_directions import directions_in
from rna_export.capture.rays.view_rays import ViewRays, outside_rays
from rna_export.metrics import IRRADIANCE
from rna_export.training.model.neural_asset import NeuralAsset
from rna_sdk.errors import CaptureError

POINTS, VIEWS, LIGHTS = 1024, 8, 12
_DRAWS = 64  # of chords
_DIRECTIONS = 64  # from a point, of which those are taken that leave the asset
_FACING = 0.05  # least cosine between a view and the normal
_SAME = 1e-4  # of the asset's radius: how near to the point a ray must hit


class SeenPoints(NamedTuple):
    """Rays at points; those of one point follow each other, VIEWS each."""

    rays: ViewRays
    queries: dict[str, np.ndarray]  # but for wi
    shade: ShadePoints


def seen_points(scene: AssetScene, rng: np.random.Generator, points: int) -> SeenPoints:
    """Up to so many points of strands that are seen from outside in VIEWS random directions.

    Raises CaptureError where there is none.
    """
    found: list[tuple[np.ndarray, np.ndarray]] = []
    for _ in range(_DRAWS):
        chords = outside_rays(scene, points, "sphere", rng)
        hits = scene.shade_points(chords.origins, chords.directions)
        for row in np.flatnonzero(hits.hit).tolist():
            x, wo = hits.position[row], _open_directions(scene, hits, row, rng)
            if len(wo) == VIEWS:
                found.append((np.repeat(x[None], VIEWS, axis=0), wo))
        if len(found) >= points:
            break
    if not found:
        raise CaptureError(f"found no point that is seen from outside in {VIEWS} directions")
    x, wo = (np.concatenate(each) for each in zip(*found[:points], strict=True))
    rays = ViewRays(x + np.float32(2.0 * scene.radius) * wo, np.ascontiguousarray(-wo))
    shade = scene.shade_points(rays.origins, rays.directions)
    near = np.linalg.norm(shade.position - x, axis=1) < _SAME * scene.radius
    kept = np.repeat((shade.hit & near).reshape(-1, VIEWS).all(axis=1), VIEWS)
    rays = rays[kept]
    shade = scene.shade_points(rays.origins, rays.directions)
    return SeenPoints(rays, {**shade.on[0].fields, "wo": -rays.directions}, shade)


def _open_directions(
    scene: AssetScene, hits: ShadePoints, row: int, rng: np.random.Generator
) -> np.ndarray:
    """Up to VIEWS directions (k, 3) in which a hit is seen from outside."""
    x, n = hits.position[row], hits.geometric_normal[row]
    wo = directions_in("sphere", rng.random((_DIRECTIONS, 2))).astype(np.float32)
    wo = wo[wo @ n > _FACING]
    at, normals = (np.repeat(v[None], len(wo), axis=0) for v in (x, n))
    return np.asarray(wo[np.isinf(scene.free_distance(at, normals, wo))][:VIEWS])


def point_parts(
    model: NeuralAsset,
    scene: AssetScene,
    worker: BlenderWorker,
    samples: int,
    points: int = POINTS,
    seed: int = 5,
) -> dict[str, Any]:
    """What the error of scattered light depends on, of the mean of RGB as displayed.

    samples: paths a ray, in two halves.
    """
    rng = np.random.default_rng(seed)
    seen = seen_points(scene, rng, points)
    ours: list[np.ndarray] = []
    cycles: list[np.ndarray] = []
    for light, wi in enumerate(directions_in("sphere", rng.random((LIGHTS, 2)))):
        rows = np.repeat(wi.astype(np.float32)[None], len(seen.rays), axis=0)
        visible = scene.visible(seen.shade, rows)
        ours.append(strand_light(model, {**seen.queries, "wi": rows}, visible).scattered)
        cycles.append(_scattered(worker, seen.rays, rows[0], samples, 2 * light))
    truth = _by_point(np.stack(cycles, axis=1))  # (2, points, VIEWS, LIGHTS)
    error = _by_point(np.stack(ours)[None]) - truth
    parts = crossed_parts(*error)
    return {
        "points": truth.shape[1],
        "views": VIEWS,
        "lights": LIGHTS,
        "scattered": round(float(truth.mean()), 5),
        "relative_rmse": round(float(np.sqrt(parts.total)) / float(truth.mean()), 3),
        "shares": {k: round(v / parts.total, 3) for k, v in parts._asdict().items()},
    }


def _scattered(
    worker: BlenderWorker, rays: ViewRays, wi: np.ndarray, samples: int, seed: int
) -> np.ndarray:
    """(2, n, 3) scattered light along rays, by Cycles, in halves."""
    halves = []
    for half in (seed, seed + 1):
        found = worker.render_rays(rays.origins, rays.directions, wi, samples // 2, half)
        assert found.direct is not None  # of strands
        halves.append(found.radiance - found.direct)
    return np.stack(halves)


def _by_point(radiance: np.ndarray) -> np.ndarray:
    """(halves, lights, rays, 3) as (halves, points, VIEWS, lights), displayed but not clamped."""
    shown = IRRADIANCE * radiance.mean(axis=-1, dtype=np.float64)
    halves, lights, _ = shown.shape
    return np.moveaxis(shown.reshape(halves, lights, -1, VIEWS), 1, -1)
