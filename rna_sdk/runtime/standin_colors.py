"""Colours of an asset for plain materials: reflectance under light from the side, and emission."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package import Mesh
from rna_sdk.package.geometry.curves import Curves
from rna_sdk.runtime.fiber_asset import FiberAsset
from rna_sdk.runtime.surface_asset import SurfaceAsset

_BRIGHT = 0.5  # of the brightest channel of hair, in a viewport

Array = NDArray[np.float32]


def surface_colors(part: SurfaceAsset) -> Array:
    """Albedo and clipped emission at the vertices of its mesh: (v, 3) float32."""
    colors = surface_albedo(part)
    if part.emits:
        colors += np.minimum(surface_emission(part), 1.0)
    return colors


def surface_albedo(part: SurfaceAsset) -> Array:
    """Albedo at the vertices of its mesh, as far as one direction tells: (v, 3) float32.

    Of base colour, the mean about each vertex.
    """
    positions, normals = part.mesh.positions, part.mesh.normals
    wi = _unit(normals + _across(normals))  # at 45 degrees, so that nothing is mirrored to the eye
    base_color = vertex_base_colors(part)
    visible, _ = part.evaluate(positions, normals, normals, wi, base_color)
    return _as_albedo(visible, np.sqrt(0.5))


def surface_emission(part: SurfaceAsset) -> Array:
    """Radiance that the vertices of its mesh send along their normals: (v, 3) float32."""
    return part.emission(part.mesh.positions, part.mesh.normals, part.mesh.normals)


def vertex_base_colors(part: SurfaceAsset) -> Array | None:
    """Mean base colour about the vertices of its mesh, (v, 3) float32; None where it has none."""
    return part.base_color_at(*_vertices(part.mesh)) if part.uses_base_color else None


def fiber_colors(part: FiberAsset, curves: Curves) -> Array:
    """Colours of the points of strands: (p, 3) float32.

    Brightened, as an engine that knows no hair shades strands by their colour alone, without the
    light that goes on from strand to strand.
    """
    t = _tangents(curves)
    wo = _across(t)
    wi = _unit(wo + np.cross(t, wo))
    h = np.zeros(len(t), np.float32)
    visible, _ = part.evaluate(curves.points, t, h, wo, wi)
    bright = max(float(np.percentile(visible, 95)), 1e-6)
    colors = _as_albedo(visible * (_BRIGHT / (np.pi * bright)), 1.0)
    if part.emits:
        colors += np.minimum(fiber_emission(part, curves), 1.0)
    return colors


def fiber_emission(part: FiberAsset, curves: Curves) -> Array:
    """Radiance that the middles of strands send sidewards at their points: (p, 3) float32."""
    t = _tangents(curves)
    return part.emission(curves.points, t, np.zeros(len(t), np.float32), _across(t))


def _tangents(curves: Curves) -> Array:
    """Unit tangents at the points of strands: (p, 3) float32."""
    tangents = np.gradient(curves.points, axis=0)
    ends = curves.offsets.astype(np.int64)
    tangents[ends[:-1]] = curves.points[ends[:-1] + 1] - curves.points[ends[:-1]]
    tangents[ends[1:] - 1] = curves.points[ends[1:] - 1] - curves.points[ends[1:] - 2]
    return _unit(tangents)


def _vertices(mesh: Mesh) -> tuple[NDArray[np.int64], Array, Array, Array]:
    """For each vertex: a triangle with this corner, u and v there, and the triangle's width."""
    corner = np.zeros(len(mesh.positions), np.int64)
    corner[mesh.triangles.ravel()] = np.arange(mesh.triangles.size)
    triangle, k = np.divmod(corner, 3)
    a, b, c = mesh.positions[mesh.triangles[triangle]].swapaxes(0, 1)
    width = np.sqrt(np.linalg.norm(np.cross(b - a, c - a), axis=1))
    u, v, width = (values.astype(np.float32) for values in (k == 1, k == 2, width))
    return triangle, u, v, width


def _as_albedo(transport: Array, cosine: float) -> Array:
    albedo: Array = np.clip(np.pi * transport / cosine, 0.0, 1.0).astype(np.float32)
    return albedo


def _across(vectors: Array) -> Array:
    """Unit vectors at right angles to unit vectors: (n, 3) float32."""
    axis = np.where(np.abs(vectors[:, 1:2]) < 0.9, [[0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0]])
    return _unit(np.cross(np.cross(vectors, axis), vectors))


def _unit(vectors: NDArray[Any]) -> Array:
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    unit: Array = (vectors / np.maximum(length, 1e-30)).astype(np.float32)
    return unit
