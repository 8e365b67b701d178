"""Assets with a known transport, and meshes to put them on."""

from dataclasses import dataclass

import numpy as np
import trimesh

from rna_sdk.package import Curves, Mesh, Mixture
from rna_sdk.package.manifest.extensions import USUAL_SAMPLING

EMBREE_ROUNDING = 4 * np.finfo(np.float32).eps
"""How far distances of hits on triangles may differ, relatively, between Embree's kernels for
AVX-512, AVX2, AVX and SSE: test_embree_processors.py."""

UP, RIGHT, TOWARDS_US = (0.0, 1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)


@dataclass(frozen=True)
class LambertAsset:
    """Transport of a diffuse surface: albedo / pi * max(n.wi, 0) where wi is free.

    Where the asset blocks wi it answers `shadowed`, another colour, to tell the two apart.
    """

    mesh: Mesh
    albedo: tuple[float, float, float] = (0.8, 0.5, 0.2)
    shadowed: tuple[float, float, float] = (0.0, 0.0, 0.0)
    kind: str = "surface"
    emits: bool = False
    nearby_lengths: None = None
    sampling: tuple[Mixture, ...] = (USUAL_SAMPLING["surface"],)
    transmittance_records: tuple = ()
    normal_maps: tuple = ()
    uses_base_color: bool = False

    @property
    def parts(self):
        return (self,)

    def transport(self, positions, normals, wo, wi, visibility, base_color=None):
        return blended(self.evaluate(positions, normals, wo, wi), visibility)

    def evaluate(self, positions, normals, wo, wi, base_color=None):
        cosine = np.maximum(np.sum(normals * wi, axis=1, keepdims=True), 0.0)
        visible = np.asarray(self.albedo) / np.pi * cosine
        shadowed = np.broadcast_to(np.asarray(self.shadowed), visible.shape)
        return visible.astype(np.float32), shadowed.astype(np.float32)


@dataclass(frozen=True)
class FiberProbe:
    """Fibers whose transport tells what was asked: the sine from tangent to wi, h, and 1 / 4 pi.

    h comes as (1 + h) / 2. Where the asset blocks wi it answers `shadowed`.
    """

    curves: Curves
    shadowed: tuple[float, float, float] = (0.0, 0.0, 0.0)
    kind: str = "fiber"
    emits: bool = False
    nearby_lengths: None = None
    sampling: tuple[Mixture, ...] = (USUAL_SAMPLING["fiber"],)

    @property
    def parts(self):
        return (self,)

    def transport(self, positions, tangents, h, wo, wi, visibility):
        return blended(self.evaluate(positions, tangents, h, wo, wi), visibility)

    def evaluate(self, positions, tangents, h, wo, wi):
        sine = np.linalg.norm(np.cross(tangents, wi), axis=1)
        visible = np.stack([sine, (1 + h) / 2, np.full_like(h, 1 / (4 * np.pi))], axis=1)
        shadowed = np.broadcast_to(np.asarray(self.shadowed), visible.shape)
        return visible.astype(np.float32), shadowed.astype(np.float32)


def blended(both, visibility):
    """What `transport` gives of visible and shadowed light."""
    visible, shadowed = both
    v = np.float32(visibility).reshape(len(visible), -1)
    return v * visible + (1 - v) * shadowed


def sphere(subdivisions: int = 4, radius: float = 1.0) -> Mesh:
    """An icosphere about the origin with smooth normals."""
    ball = trimesh.creation.icosphere(subdivisions=subdivisions)
    unit = np.asarray(ball.vertices, np.float32)
    unit /= np.linalg.norm(unit, axis=1, keepdims=True)
    faces = np.asarray(ball.faces, np.uint32)
    return Mesh(positions=radius * unit, normals=unit, uvs=None, triangles=faces)


def square(size: float = 1.0, height: float = 0.0) -> Mesh:
    """A square of half-side `size` at y = `height` that faces +Y."""
    corners = [[-size, height, size], [size, height, size], [size, height, -size]]
    positions = np.array([*corners, [-size, height, -size]], np.float32)
    return Mesh(
        positions=positions,
        normals=np.tile(np.float32(UP), (4, 1)),
        uvs=None,
        triangles=np.array([[0, 1, 2], [0, 2, 3]], np.uint32),
    )


def merged(*meshes: Mesh) -> Mesh:
    """All meshes as one."""
    starts = np.cumsum([0] + [len(mesh.positions) for mesh in meshes])
    return Mesh(
        positions=np.concatenate([mesh.positions for mesh in meshes]),
        normals=np.concatenate([mesh.normals for mesh in meshes]),
        uvs=None,
        triangles=np.concatenate(
            [mesh.triangles + np.uint32(s) for mesh, s in zip(meshes, starts[:-1], strict=True)]
        ),
    )
