"""Simplified proxy meshes, for an asset that is small in the image."""

import fast_simplification
import numpy as np
import trimesh

from rna_sdk.package import Mesh, quantise

_CREASE = np.cos(np.radians(40.0))  # faces that meet more sharply have normals of their own
_TRIANGLE = 0.5  # mean area, square pixels
_LEAST_SAVING = 2  # times fewer triangles


def proxy_of(mesh: Mesh, pixels: int) -> Mesh | None:
    """A quantised mesh for a bounding sphere of `pixels` in the image; None: it saves too little.

    Its triangles have half a square pixel each on average. Edges are collapsed by the least
    quadric error (Garland and Heckbert 1997). It has no texture coordinates.
    """
    positions = mesh.positions.astype(np.float64)
    low, high = mesh.box()
    pixel = float(np.linalg.norm(high - low)) / pixels
    area = trimesh.triangles.area(positions[mesh.triangles]).sum()
    wanted = int(np.ceil(area / (_TRIANGLE * pixel**2)))
    if wanted * _LEAST_SAVING > len(mesh.triangles):
        return None
    points, index = np.unique(positions, axis=0, return_inverse=True)
    faces = index.reshape(-1)[mesh.triangles].astype(np.int32)
    points, faces = fast_simplification.simplify(points, faces, target_count=wanted)
    faces = faces[trimesh.triangles.area(points[faces]) > 0]
    if not len(faces):
        return None
    proxy = quantise(_shaded(points, faces))
    assert isinstance(proxy, Mesh)  # as what it is made of
    return proxy


def _shaded(points: np.ndarray, faces: np.ndarray) -> Mesh:
    """A mesh with corner normals, smooth except at creases."""
    crosses = trimesh.triangles.cross(points[faces])
    units = crosses / np.linalg.norm(crosses, axis=1, keepdims=True)
    corners, face_of = faces.reshape(-1), np.repeat(np.arange(len(faces)), 3)
    order = np.argsort(corners, kind="stable")
    counts = np.bincount(corners, minlength=len(points))
    starts = np.cumsum(counts) - counts
    # Every corner with every face at its vertex.
    corner = np.repeat(np.arange(len(corners)), counts[corners])
    place = np.arange(len(corner)) - np.repeat(
        np.cumsum(counts[corners]) - counts[corners], counts[corners]
    )
    other = face_of[order[starts[corners[corner]] + place]]
    smooth = np.einsum("ij,ij->i", units[face_of[corner]], units[other]) > _CREASE
    normals = np.zeros((len(corners), 3))
    np.add.at(normals, corner[smooth], crosses[other[smooth]])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    rows = np.concatenate([points[corners], normals], axis=1).astype(np.float32) + np.float32(0)
    vertices, index = np.unique(rows, axis=0, return_inverse=True)
    return Mesh(
        np.ascontiguousarray(vertices[:, :3]),
        np.ascontiguousarray(vertices[:, 3:]),
        None,
        index.reshape(-1, 3).astype(np.uint32),
    )
