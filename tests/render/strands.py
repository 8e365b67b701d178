"""Strands to trace rays against."""

import numpy as np

from rna_sdk.package import Curves


def straight(*strands: tuple[tuple[float, float, float], ...], radius: float = 0.1) -> Curves:
    """Strands through the given points, all of one radius."""
    points = np.float32([point for strand in strands for point in strand])
    offsets = np.cumsum([0] + [len(strand) for strand in strands]).astype(np.uint32)
    return Curves(points, np.full(len(points), radius, np.float32), offsets)


def curls(strands: int, seed: int = 0, radius: float = 0.02, spread: float = 0.5) -> Curves:
    """Random helices of 19 segments and 2 to 4 turns that taper to a fifth of their root radius.

    They start within a cube of half-side `spread`; a turn is 0.24 wide.
    """
    rng = np.random.default_rng(seed)

    def unit(vectors):
        return vectors / np.linalg.norm(vectors, axis=2, keepdims=True)

    root = rng.uniform(-spread, spread, (strands, 1, 3))
    axis = unit(rng.normal(size=(strands, 1, 3)))
    side = unit(np.cross(axis, rng.normal(size=(strands, 1, 3))))
    t = np.linspace(0, 1, 20)[None, :, None]
    turn = rng.uniform(2, 4, (strands, 1, 1)) * 2 * np.pi * t
    circle = np.cos(turn) * side + np.sin(turn) * np.cross(axis, side)
    points = root + 0.6 * t * axis + 0.12 * circle
    radii = radius * rng.uniform(0.5, 1.5, (strands, 1)) * (1.0 - 0.8 * t[:, :, 0])
    return Curves(
        points=points.reshape(-1, 3).astype(np.float32),
        radii=radii.reshape(-1).astype(np.float32),
        offsets=np.arange(0, (strands + 1) * 20, 20, dtype=np.uint32),
    )
