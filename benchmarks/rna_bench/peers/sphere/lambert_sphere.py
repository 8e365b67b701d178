"""A Lambertian sphere under a point light, in closed form: a scene that every method must fit."""

import math

import numpy as np

from rna_bench.peers.views import PeerCamera, Views
from rna_bench.peers.views_plan import FOV_X, INTENSITY, ViewsPlan

CENTRE, RADIUS = np.array([0.1, 0.05, -0.1]), 0.7  # as in sphere_asset.py
ALBEDO = np.array([0.45, 0.3, 0.2])

_SUBPIXELS = 4  # a side


def sphere_views(count: int, resolution: int, split: str = "train") -> Views:
    """Views as `rna-bench peers-data` renders them."""
    plan = ViewsPlan(count, count, count, resolution, 1, 1)
    frames = plan.frames(split)
    to_world = np.array([frame["transform_matrix"] for frame in frames])
    lights = np.array([frame["pl_pos"] for frame in frames])
    shown = [_image(m, light, resolution) for m, light in zip(to_world, lights, strict=True)]
    rgba = np.stack([image for image, _ in shown])
    depth = np.stack([distance for _, distance in shown])
    return Views(rgba, depth, to_world, lights, FOV_X, intensity=INTENSITY)


def _image(to_world: np.ndarray, light: np.ndarray, size: int) -> tuple[np.ndarray, np.ndarray]:
    """RGBA (size, size, 4), and depth (size, size) at the middles of pixels."""
    fine = PeerCamera(to_world, FOV_X, (size * _SUBPIXELS, size * _SUBPIXELS))
    rgba, _ = _shaded(*fine.rays(), light)
    blocks = rgba.reshape(size, _SUBPIXELS, size, _SUBPIXELS, 4).mean(axis=(1, 3))
    _, depth = _shaded(*PeerCamera(to_world, FOV_X, (size, size)).rays(), light)
    return blocks.astype(np.float32), depth.reshape(size, size).astype(np.float32)


def _shaded(
    origins: np.ndarray, directions: np.ndarray, light: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """RGBA (n, 4) and distance (n,), 0 for none, of rays."""
    from_centre = origins.astype(np.float64) - CENTRE
    half = (from_centre * directions).sum(axis=1)
    root = half**2 - (from_centre**2).sum(axis=1) + RADIUS**2
    hit = root > 0.0
    distance = np.where(hit, -half - np.sqrt(np.maximum(root, 0.0)), 0.0)
    normals = (from_centre + distance[:, None] * directions) / RADIUS
    way = light - (CENTRE + RADIUS * normals)
    squared = (way**2).sum(axis=1)
    cosine = np.maximum((normals * way).sum(axis=1), 0.0) / np.sqrt(squared)
    colour = ALBEDO / math.pi * (INTENSITY * cosine / squared)[:, None]
    return np.concatenate([colour, np.ones_like(colour[:, :1])], axis=1) * hit[:, None], distance
