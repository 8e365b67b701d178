"""Connected pieces of a mesh."""

from __future__ import annotations

import numpy as np

from rna_sdk.package import Mesh


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
