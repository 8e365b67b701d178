"""Samples the view rays to capture; all of them hit the asset.

Three kinds are mixed. *Outside* rays are uniform chords of the bounding sphere: what cameras
around the asset see. *Close* rays start anywhere in the free space over a random point, down to
contact: crevices, grazing views, strong zoom. *Highlight* rays look at a visible point from where
the light makes a highlight on it: there glossy materials keep almost all of their error (a share of
3% of a surface's points under uniform views).

Half of each kind is divided among the parts of the asset as they are seen, half among all alike: a
thin part has to be learnt as well.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from rna_export.capture.rays.asset_scene import AssetScene, part_counts
from rna_export.capture.rays.capture_directions import directions_in, frame
from rna_sdk.package.manifest.manifest_fields import Region
from rna_sdk.runtime import in_region

CLOSE, HIGHLIGHT = 0.25, 0.25  # shares of the rays; the rest are outside ones
ALIKE = 0.5  # share of the rays that all parts get as many of, however little is seen of them

_CHORDS = 4096
_TRIES_WITHOUT_AIM, _TRIES_AIMED, _TRIES_OUTSIDE = 4, 16, 8


@dataclass(frozen=True)
class ViewRays:
    origins: np.ndarray  # (n, 3) float32, object space
    directions: np.ndarray  # (n, 3) float32, unit

    def __getitem__(self, index: np.ndarray) -> "ViewRays":
        return ViewRays(self.origins[index], self.directions[index])

    def __len__(self) -> int:
        return len(self.origins)


def _joined(rays: list[ViewRays]) -> ViewRays:
    return ViewRays(
        np.concatenate([r.origins for r in rays]), np.concatenate([r.directions for r in rays])
    )


Drawing = Callable[[int, "np.ndarray | None"], ViewRays]


def sample_view_rays(
    scene: AssetScene, wi: np.ndarray | None, n: int, wo: Region, rng: np.random.Generator
) -> ViewRays:
    """n rays towards the asset, whose views are in the region `wo`.

    wi: (3,) where the light comes from that makes highlights; None: no light, no highlights.
    """
    shares = _part_shares(scene, wo, rng)
    draw = _Draw(scene, wo, rng)

    light = np.zeros(3, np.float32) if wi is None else wi  # without one no highlight is drawn

    def highlight(k: int, among: np.ndarray | None) -> ViewRays:
        seen = draw.seen(2 * k, among)
        hits = scene.shade_points(seen.origins, seen.directions)
        rows, wo = scene.highlight_views(hits, light, rng)
        above = np.sum(wo * hits.geometric_normal[rows], axis=1) > 0.02
        rows, wo = rows[above][:k], wo[above][:k]
        points, ng = hits.position[rows], hits.geometric_normal[rows]
        free = scene.free_distance(points, ng, wo)
        open_enough = free > 0.01 * scene.radius
        distance = 0.95 * np.minimum(free, 2.0 * scene.radius)
        return ViewRays(points + distance[:, None] * wo, -wo)[open_enough]

    lit = 0 if wi is None else round(n * HIGHLIGHT)
    highlights = draw.both_ways(highlight, part_counts(lit, shares), tries=8)
    close = draw.hits(draw.close, part_counts(round(n * CLOSE), shares), tries=32)
    counts = highlights.of_parts + close.of_parts
    wanted = np.maximum(part_counts(n, shares) - counts, 0)
    outside = draw.both_ways(draw.seen, wanted, tries=200)
    kinds = [outside, close, highlights]
    lacking = n - sum(len(drawn.rays) for drawn in kinds)
    kinds.append(draw.hits(draw.seen, np.array([lacking]), tries=200))
    mixed = _joined([drawn.rays for drawn in kinds])
    return mixed[rng.permutation(len(mixed))]


def _part_shares(scene: AssetScene, wo: Region, rng: np.random.Generator) -> np.ndarray:
    """Fraction of the view rays for each part: half by visible area, half equally."""
    parts = len(scene.shapes)
    if parts == 1:
        return np.ones(1)
    chords = outside_rays(scene, _CHORDS, wo, rng)
    part = scene.part_hit(chords.origins, chords.directions)
    seen = np.bincount(part[part >= 0], minlength=parts) + 1e-6
    return np.asarray(ALIKE / parts + (1.0 - ALIKE) * seen / seen.sum())


@dataclass(frozen=True)
class _DrawnRays:
    """Rays that hit, and how many of them each part."""

    rays: ViewRays
    of_parts: np.ndarray  # (parts,) int


@dataclass(frozen=True)
class _Draw:
    """Draws rays until there are enough at each part.

    What draws them takes a number, and the shares of the parts (parts,) that they are to be aimed
    at, or None for no aim; not all need hit.
    """

    scene: AssetScene
    region: Region
    rng: np.random.Generator

    def seen(self, n: int, among: np.ndarray | None) -> ViewRays:
        """Outside rays, uniform over all chords, or over those that hit the given parts.

        Of parts, at points by area times the cosine; hidden points get none.
        """
        if among is None:
            return outside_rays(self.scene, n, self.region, self.rng)
        points, normals, wo = self._sent(n, among)
        free = np.isinf(self.scene.free_distance(points, normals, wo))
        away = np.float32(2.0 * self.scene.radius)
        return ViewRays(points[free] + away * wo[free], -wo[free])

    def close(self, n: int, among: np.ndarray | None) -> ViewRays:
        """Rays from the free space over points."""
        points, normals, wo = self._sent(n, among)
        n = len(points)
        free = self.scene.free_distance(points, normals, wo)
        open_enough = free > 0.01 * self.scene.radius  # skips what lies inside solids
        distance = self.rng.random(n).astype(np.float32) * np.minimum(free, 2.0 * self.scene.radius)
        distance = np.maximum(distance, 0.005 * self.scene.radius)
        origins = points + distance[:, None] * wo
        return ViewRays(origins, -wo)[open_enough]

    def _sent(self, n: int, among: np.ndarray | None) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Points, normals and directions, as a diffuse surface sends light: at most n of each."""
        points, normals = self.scene.sample_points(n, self.rng, among)
        wo = directions_in(self.region, self.rng.random((n, 2)))
        sent = self.rng.random(n) < np.sum(wo * normals, axis=1)
        return points[sent], normals[sent], wo[sent]

    def both_ways(self, draw: Drawing, wanted: np.ndarray, tries: int) -> _DrawnRays:
        """Without aim first, which is cheap; then at the parts of which rays are lacking."""
        if len(wanted) == 1:
            return self.hits(draw, wanted, tries)
        free = self.hits(draw, wanted, _TRIES_WITHOUT_AIM, aim=False)
        aimed = self.hits(draw, wanted - free.of_parts, _TRIES_AIMED)
        return _DrawnRays(_joined([free.rays, aimed.rays]), free.of_parts + aimed.of_parts)

    def hits(self, draw: Drawing, wanted: np.ndarray, tries: int, aim: bool = True) -> _DrawnRays:
        """Up to `wanted` (parts,) of the drawn rays that hit each part, seen from the region.

        wanted of one number: of all parts together.
        """
        batches = [ViewRays(np.zeros((0, 3), np.float32), np.zeros((0, 3), np.float32))]
        lacking = wanted.copy()
        for _ in range(tries):
            if not lacking.any():
                break
            among = lacking / lacking.sum() if aim and len(wanted) > 1 else None
            rays = draw(max(2 * int(lacking.sum()), 256), among)
            part = np.minimum(self.scene.part_hit(rays.origins, rays.directions), len(wanted) - 1)
            part = np.where(in_region(self.region, -rays.directions), part, -1)
            chosen = np.concatenate([np.flatnonzero(part == k)[:m] for k, m in enumerate(lacking)])
            chosen.sort()
            lacking = lacking - np.bincount(part[chosen], minlength=len(wanted))
            batches.append(rays[chosen])
        return _DrawnRays(_joined(batches), wanted - lacking)


def outside_rays(
    scene: AssetScene, n: int, region: Region, rng: np.random.Generator, wider: float = 1.0
) -> ViewRays:
    """n uniform chords of the bounding sphere whose views are in the region; not all hit.

    wider: radius of the sphere that is taken, in those of the bounding sphere.
    """
    wo = directions_in(region, rng.random((n, 2)))
    s, t = frame(wo)
    r, phi = wider * scene.radius * np.sqrt(rng.random(n)), 2.0 * np.pi * rng.random(n)
    disk = (r * np.cos(phi))[:, None] * s + (r * np.sin(phi))[:, None] * t
    origins = scene.centre + disk + 1.5 * wider * scene.radius * wo
    return ViewRays(origins.astype(np.float32), -wo)


def hitting_rays(scene: AssetScene, count: int, wo: Region, rng: np.random.Generator) -> ViewRays:
    """Uniform chords that hit the asset, `count` of them if they are found."""
    found: list[ViewRays] = []
    for _ in range(_TRIES_OUTSIDE):
        rays = outside_rays(scene, 4 * count, wo, rng)
        found.append(rays[scene.part_hit(rays.origins, rays.directions) >= 0])
        if sum(map(len, found)) >= count:
            break
    return _joined(found)[np.arange(min(count, sum(map(len, found))))]
