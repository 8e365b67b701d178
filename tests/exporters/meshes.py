"""Meshes whose surface is known in closed form."""

import numpy as np

from rna_sdk.package import Mesh
from tests.render.assets import merged, sphere, square

__all__ = ["merged", "moved", "ring", "sphere", "square"]


def moved(mesh: Mesh, by: tuple[float, float, float]) -> Mesh:
    """The mesh, translated."""
    return Mesh(mesh.positions + np.float32(by), mesh.normals, mesh.uvs, mesh.triangles)


def ring(major: float = 1.0, minor: float = 0.1, around: int = 48, across: int = 12) -> Mesh:
    """A torus about the y axis: a camera on the axis that looks at the middle sees nothing."""
    u, v = np.meshgrid(*(2.0 * np.pi * np.arange(k) / k for k in (around, across)), indexing="ij")
    out = np.stack([np.cos(u), np.zeros_like(u), np.sin(u)], axis=-1)
    normals = np.cos(v)[..., None] * out + np.sin(v)[..., None] * np.array([0.0, 1.0, 0.0])
    positions = major * out + minor * normals
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = i * across + j, (i + 1) % around * across + j
    c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
    triangles = np.concatenate([np.stack([a, d, c], -1), np.stack([a, c, b], -1)]).reshape(-1, 3)
    return Mesh(
        positions.reshape(-1, 3).astype(np.float32),
        normals.reshape(-1, 3).astype(np.float32),
        None,
        triangles.astype(np.uint32),
    )
