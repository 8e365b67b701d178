"""Rays against round cones, exactly: a slow float64 twin of Embree's round linear curves.

A round cone is the convex hull of two spheres. Its surface is a cone that touches both, and a cap
of each; a ray enters it once at most.
"""

import numpy as np

from rna_sdk.package import Curves


def entries(curves: Curves, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
    """Where each ray enters each segment: (n, m) float64, infinity where it does not.

    origins, directions: (n, 3); directions are unit. A ray that starts inside enters nothing.
    """
    first = curves.segments().astype(int)
    ends = [curves.points[first + k].astype(np.float64) for k in (0, 1)]
    radii = [curves.radii[first + k].astype(np.float64) for k in (0, 1)]
    o, d = origins.astype(np.float64)[:, None], directions.astype(np.float64)[:, None]
    d = d / np.linalg.norm(d, axis=2, keepdims=True)
    axis = ends[1] - ends[0]
    taper = radii[0] - radii[1]
    # Where a sphere's centre is s of the way along the axis, it touches the surface in a circle
    # that lies (s * along + shift) along the axis, in units where the axis's square is `along`.
    squared = np.sum(axis * axis, axis=1)
    hull = squared - taper * taper
    relative = o - ends[0]
    m1, m2 = np.sum(relative * axis, axis=2), np.sum(d * axis, axis=2)
    m3, m5 = np.sum(relative * d, axis=2), np.sum(relative * relative, axis=2)
    result = np.full(m1.shape, np.inf)
    # I. Quilez, Round Cone (https://iquilezles.org/articles/intersectors), with both roots.
    k2 = hull - m2 * m2
    k1 = hull * m3 - m1 * m2 + m2 * taper * radii[0]
    k0 = hull * m5 - m1 * m1 + 2.0 * m1 * taper * radii[0] - squared * radii[0] ** 2
    with np.errstate(divide="ignore", invalid="ignore"):
        root = np.sqrt(k1 * k1 - k0 * k2)
        for t in ((-k1 - root) / k2, (-k1 + root) / k2):
            along = m1 - radii[0] * taper + t * m2
            s = along / hull
            centre = ends[0] + s[..., None] * axis
            outward = np.sum((o + t[..., None] * d - centre) * d, axis=2)
            on_cone = (hull > 0) & (s > 0) & (s < 1) & (t >= 0) & (outward < 0)
            result = np.where(on_cone, np.minimum(result, t), result)
        for end, (centre, radius) in enumerate(zip(ends, radii, strict=True)):
            to_centre = o - centre
            b = np.sum(to_centre * d, axis=2)
            c = np.sum(to_centre * to_centre, axis=2) - radius**2
            t = -b - np.sqrt(b * b - c)
            s = (m1 - radii[0] * taper + t * m2) / hull
            larger = taper >= 0 if end == 0 else taper < 0
            on_cap = np.where(hull > 0, s <= 0 if end == 0 else s >= 1, larger) & (t >= 0)
            result = np.where(on_cap, np.minimum(result, t), result)
    return result


def depths(curves: Curves, points: np.ndarray) -> np.ndarray:
    """How deep each point lies in each segment: (n, m) float64, metres; negative outside."""
    first = curves.segments().astype(int)
    ends = [curves.points[first + k].astype(np.float64) for k in (0, 1)]
    radii = [curves.radii[first + k].astype(np.float64) for k in (0, 1)]
    axis = ends[1] - ends[0]
    taper = radii[0] - radii[1]
    hull = np.sum(axis * axis, axis=1) - taper * taper
    relative = points.astype(np.float64)[:, None] - ends[0]
    along = np.sum(relative * axis, axis=2)
    length = np.linalg.norm(axis, axis=1)
    across = np.sqrt(np.maximum(np.sum(relative**2, axis=2) - (along / length) ** 2, 0.0))
    # The sphere nearest to the point stands where the line to it has the normal's slope.
    s = (along - taper * across * length / np.sqrt(hull)) / length**2
    s = np.clip(s, 0.0, 1.0)
    gap = np.linalg.norm(relative - s[..., None] * axis, axis=2)
    return radii[0] - s * taper - gap
