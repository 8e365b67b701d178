"""Chooses the view rays that Cycles is asked about; every one of them hits the asset.

Three kinds are mixed. *Outside* rays are uniform chords of the bounding sphere: what cameras
around the asset see. *Close* rays start anywhere in the free space over a random point, down to
contact: crevices, grazing views, strong zoom. *Highlight* rays look at a visible point from where
the light makes a highlight on it: there glossy materials keep almost all of their error (a share of
3% of a surface's points under uniform views).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rna_export.capture.asset_scene import AssetScene
from rna_export.capture.directions import directions_in, frame
from rna_sdk.package.manifest_fields import Region
from rna_sdk.runtime import in_region

CLOSE, HIGHLIGHT = 0.25, 0.25  # shares of the rays; the rest are outside ones


@dataclass(frozen=True)
class ViewRays:
    origins: np.ndarray  # (n, 3) float32, object space
    directions: np.ndarray  # (n, 3) float32, unit

    def __getitem__(self, index: object) -> ViewRays:
        return ViewRays(self.origins[index], self.directions[index])

    def __len__(self) -> int:
        return len(self.origins)


def sample_view_rays(
    scene: AssetScene, wi: np.ndarray, n: int, wo: Region, rng: np.random.Generator
) -> ViewRays:
    """n rays towards the asset, lit from wi (3,), whose views are in the region `wo`."""
    highlight = _repeat(
        lambda k: _highlight(scene, wi, k, wo, rng), scene, round(n * HIGHLIGHT), wo, tries=8
    )
    close = _repeat(lambda k: _close(scene, k, wo, rng), scene, round(n * CLOSE), wo, tries=32)
    rest = n - len(highlight) - len(close)
    outside = _repeat(lambda k: _outside(scene, k, wo, rng), scene, rest, wo, tries=200)
    parts = (outside, close, highlight)
    mixed = ViewRays(
        np.concatenate([p.origins for p in parts]), np.concatenate([p.directions for p in parts])
    )
    return mixed[rng.permutation(len(mixed))]


def _repeat(draw, scene: AssetScene, n: int, wo: Region, tries: int) -> ViewRays:
    """Up to n of the drawn rays that hit the asset and look from in the region."""
    origins, directions, found = [], [], 0
    for _ in range(tries):
        if found >= n:
            break
        rays = draw(max(2 * (n - found), 256))
        keep = scene.hit_mask(rays.origins, rays.directions)
        keep &= in_region(wo, -rays.directions)
        origins.append(rays.origins[keep])
        directions.append(rays.directions[keep])
        found += int(keep.sum())
    empty = np.zeros((0, 3), np.float32)
    return ViewRays(np.concatenate([empty, *origins])[:n], np.concatenate([empty, *directions])[:n])


def _outside(scene: AssetScene, n: int, region: Region, rng: np.random.Generator) -> ViewRays:
    wo = directions_in(region, rng.random((n, 2)))
    s, t = frame(wo)
    r, phi = scene.radius * np.sqrt(rng.random(n)), 2.0 * np.pi * rng.random(n)
    disk = (r * np.cos(phi))[:, None] * s + (r * np.sin(phi))[:, None] * t
    origins = scene.centre + disk + 1.5 * scene.radius * wo
    return ViewRays(origins.astype(np.float32), -wo)


def _close(scene: AssetScene, n: int, region: Region, rng: np.random.Generator) -> ViewRays:
    points, normals = scene.sample_points(n, rng)
    wo = directions_in(region, rng.random((n, 2)))
    facing = rng.random(n) < np.sum(wo * normals, axis=1)  # as a diffuse surface sends light
    points, normals, wo = points[facing], normals[facing], wo[facing]
    n = len(points)
    free = scene.free_distance(points, normals, wo)
    open_enough = free > 0.01 * scene.radius  # skips what lies inside solids
    distance = rng.random(n).astype(np.float32) * np.minimum(free, 2.0 * scene.radius)
    distance = np.maximum(distance, 0.005 * scene.radius)
    origins = points + distance[:, None] * wo
    return ViewRays(origins, -wo)[open_enough]


def _highlight(
    scene: AssetScene, wi: np.ndarray, n: int, region: Region, rng: np.random.Generator
) -> ViewRays:
    seen = _outside(scene, 2 * n, region, rng)
    hits = scene.shade_points(seen.origins, seen.directions)
    rows, wo = scene.highlight_views(hits, wi, rng)
    above = np.sum(wo * hits.geometric_normal[rows], axis=1) > 0.02
    rows, wo = rows[above][:n], wo[above][:n]
    points, ng = hits.position[rows], hits.geometric_normal[rows]
    free = scene.free_distance(points, ng, wo)
    open_enough = free > 0.01 * scene.radius
    distance = 0.95 * np.minimum(free, 2.0 * scene.radius)
    return ViewRays(points + distance[:, None] * wo, -wo)[open_enough]
