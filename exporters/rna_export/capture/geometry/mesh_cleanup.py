"""Converts a triangle soup to an indexed mesh, and finds the connected pieces of one."""

from collections.abc import Sequence

import numpy as np
import trimesh

from rna_sdk.package import Mesh


def with_last(corners: dict[str, np.ndarray], last: Sequence[str]) -> dict[str, np.ndarray]:
    """Corners, the triangles of the last materials at the end, by tile; degenerate ones go."""
    positions = corners["positions"].astype(np.float32).reshape(-1, 3, 3)
    area = trimesh.triangles.area(positions.astype(np.float64))
    rank = {material: place for place, material in enumerate(last)}
    places = np.array([rank.get(name, -1) for name in corners["material"]])
    order = np.lexsort((corners["tile"], places))
    order = order[area[order] > 0.0]
    rows = (3 * order[:, None] + np.arange(3)).ravel()
    of_corners = {name: corners[name][rows] for name in ("positions", "normals", "uvs", "vertex")}
    of_triangles = {name: corners[name][order] for name in ("material", "tile")}
    return {**corners, **of_corners, **of_triangles}


def welded(corners: dict[str, np.ndarray]) -> tuple[Mesh, np.ndarray]:
    """One vertex for each different corner (position, normal, uv); degenerate triangles go.

    A corner without a normal gets its triangle's. Second: (v,), the corner that each vertex is of.
    """
    with_uv = bool(corners["has_uv"])
    normals = _whole_normals(corners["positions"], corners["normals"])
    rows = np.concatenate(
        [corners["positions"], normals] + ([corners["uvs"]] if with_uv else []), axis=1
    )
    rows = rows.astype(np.float32) + 0.0
    vertices, first, index = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    triangles = index.reshape(-1, 3).astype(np.uint32)
    area = trimesh.triangles.area(vertices[:, :3].astype(np.float64)[triangles])
    vertices = np.ascontiguousarray(vertices, np.float32)
    normals = np.ascontiguousarray(vertices[:, 3:6])
    uvs = np.ascontiguousarray(vertices[:, 6:8]) if with_uv else None
    positions = np.ascontiguousarray(vertices[:, :3])
    return Mesh(positions, normals, uvs, triangles[area > 0.0]), first


def _whole_normals(positions: np.ndarray, normals: np.ndarray) -> np.ndarray:
    corners = positions.reshape(-1, 3, 3).astype(np.float64)
    flat = np.repeat(trimesh.triangles.cross(corners), 3, axis=0)
    chosen = np.where(np.linalg.norm(normals, axis=1, keepdims=True) > 0.5, normals, flat)
    lengths = np.linalg.norm(chosen, axis=1, keepdims=True)
    return np.asarray(chosen / np.maximum(lengths, 1e-30))


def repeated(mesh: Mesh) -> np.ndarray:
    """(t,) bool, triangles at whose three positions there is another one before, either way round.

    Normals and texture coordinates may differ.
    """
    _, place = np.unique(mesh.positions, axis=0, return_inverse=True)
    corners = np.sort(place.reshape(-1)[mesh.triangles], axis=1)
    _, first = np.unique(corners, axis=0, return_index=True)
    result = np.ones(len(corners), bool)
    result[first] = False
    return result


def vertex_islands(mesh: Mesh) -> np.ndarray:
    """(v,) a number for each vertex, the same for all of a connected piece.

    Vertices at one position are one, whatever their normals and texture coordinates.
    """
    _, place = np.unique(mesh.positions, axis=0, return_inverse=True)
    place = place.reshape(-1)
    return connected(int(place.max()) + 1, place[mesh.triangles])[place]


def connected(vertices: int, triangles: np.ndarray) -> np.ndarray:
    """(v,) the smallest vertex of the connected piece that each vertex is of.

    triangles: (t, 3) of the vertices.
    """
    label = np.arange(vertices)
    while True:
        least = label[triangles].min(axis=1)
        after = label.copy()
        for corner in triangles.T:
            np.minimum.at(after, corner, least)
            np.minimum.at(after, label[corner], least)
        after = after[after]
        if np.array_equal(after, label):
            return label
        label = after
