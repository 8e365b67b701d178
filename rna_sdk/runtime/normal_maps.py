"""Shading normals from normal maps: spec/RNA.md, 4.5, in numpy.

For tests, tools and readers in Python; renderers have their own kernels for the same formula.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from rna_sdk.arrays import indices
from rna_sdk.package import Mesh
from rna_sdk.package.textures.normal_maps import NormalMap
from rna_sdk.runtime.transmittance_lookup import bilinear

Float = NDArray[np.float64]

_SHORT = 1e-6


def mapped_normals(
    mesh: Mesh,
    records: Sequence[NormalMap],
    triangle: NDArray[np.integer],
    u: NDArray[np.floating],
    v: NDArray[np.floating],
) -> NDArray[np.float32]:
    """Normals to evaluate a part with at ray hits: interpolated, with its normal maps applied.

    records: the part's (`asset.parts[k].normal_maps`). triangle: (n,) indices of the hit triangles.
    u, v: (n,) barycentric coordinates of the second and third corner.

    Returns (n, 3) float32 unit normals, object space.

    Raises:
        QueryError: `triangle` is no such array, or a triangle is not there.

    Examples:
        >>> asset = load("toy.rna")  # without normal maps: the mesh's own normals
        >>> first, middle = np.zeros(1, np.int32), np.full(1, 1 / 3, np.float32)
        >>> mapped_normals(asset.mesh, asset.normal_maps, first, middle, middle).shape
        (1, 3)
    """
    triangle = indices("triangle", triangle, len(mesh.triangles))
    corners = mesh.triangles[triangle]
    weights = np.stack([1.0 - u.astype(np.float64) - v, u, v], axis=1, dtype=np.float64)
    n = _unit(np.einsum("nk,nkc->nc", weights, mesh.normals[corners].astype(np.float64)))
    for record in records:
        rows = np.flatnonzero((triangle >= record.first) & (triangle < record.first + record.count))
        n[rows] = _mapped(record, mesh, corners[rows], weights[rows], n[rows])
    return n.astype(np.float32)


def _mapped(
    record: NormalMap, mesh: Mesh, corners: NDArray[np.uint32], weights: Float, n: Float
) -> Float:
    assert mesh.uvs is not None  # a valid part with normal maps has them
    t, b, is_flat = tangent_frames(mesh, corners, n)
    at = np.einsum("nk,nkc->nc", weights, mesh.uvs[corners].astype(np.float64))
    x, y = ((bilinear(record.texture, at) - 127.0) / 127.0).T[..., None]
    bent = x * t + y * b + np.sqrt(np.maximum(1.0 - x * x - y * y, 0.0)) * n
    is_flat |= np.linalg.norm(bent, axis=1) <= _SHORT
    return np.where(is_flat[:, None], n, _unit(bent))


def tangent_frames(
    mesh: Mesh, corners: NDArray[np.uint32], n: Float
) -> tuple[Float, Float, NDArray[np.bool_]]:
    """Tangents and bitangents (n, 3) at points of triangles, and whether they do not tell.

    corners: (n, 3), of the triangles. n: (n, 3) unit normals at the points.
    """
    assert mesh.uvs is not None
    p, uv = (values[corners].astype(np.float64) for values in (mesh.positions, mesh.uvs))
    along_u, along_v, is_flat = _directions(p, uv)
    t = along_u - np.sum(along_u * n, axis=1, keepdims=True) * n
    length = np.linalg.norm(t, axis=1)
    is_flat |= length <= _SHORT * np.linalg.norm(along_u, axis=1)
    t = t / np.where(is_flat, 1.0, length)[:, None]
    b = np.cross(n, t)
    return t, np.where(np.sum(b * along_v, axis=1, keepdims=True) > 0.0, -b, b), is_flat


def _directions(p: Float, uv: Float) -> tuple[Float, Float, NDArray[np.bool_]]:
    """Along which u and v grow on triangles, and whether they do not tell.

    p: (n, 3, 3) corners; uv: (n, 3, 2).
    """
    (e1, e2), (d1, d2) = ((a[:, 1] - a[:, 0], a[:, 2] - a[:, 0]) for a in (p, uv))
    area = d1[:, :1] * d2[:, 1:] - d2[:, :1] * d1[:, 1:]
    sign = np.where(area < 0.0, -1.0, 1.0)
    along_u = (d2[:, 1:] * e1 - d1[:, 1:] * e2) * sign
    along_v = (d1[:, :1] * e2 - d2[:, :1] * e1) * sign
    return along_u, along_v, area[:, 0] == 0.0


def _unit(vectors: Float) -> Float:
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    result: Float = vectors / np.where(length > 0.0, length, 1.0)
    return result
