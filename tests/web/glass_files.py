"""A ball of smooth glass, as rna-capture writes glass beside a package."""

from pathlib import Path

import numpy as np

from rna_export.capture.geometry.glass_mesh import glass_glb
from rna_export.capture.preflight.material_record import Glass
from tests.render.assets import sphere


def write_ball(path: Path, radius: float = 1.5, roughness: float = 0.0) -> Path:
    """A greenish ball about the origin that absorbs."""
    ball = sphere(3, radius)
    corners = {
        "positions": ball.positions[ball.triangles].reshape(-1, 3),
        "normals": ball.normals[ball.triangles].reshape(-1, 3),
        "material": np.full(len(ball.triangles), "green"),
    }
    glass = Glass(
        name="green",
        full_name="green",
        ior=1.4,
        tint=(0.8, 0.95, 0.85),
        roughness=roughness,
        absorption=(0.3, 0.05, 0.2),
    )
    written = glass_glb(corners, [glass])
    assert written is not None
    path.write_bytes(written)
    return path
