"""Geometry as readers have it, mostly restored from integers: spec/RNA.md, 4.1 and 4.2."""

from dataclasses import replace

import numpy as np

from rna_sdk.package import Curves, Mesh, quantise

PLAIN = ("surface-odd", "surface-tiny")
"""Packages that are asked for geometry as it is: with an odd mesh, and without coordinates."""
NORMAL_TOLERANCE = 2.0**-22
"""Tolerance of a component of a normal; all other values are the same to the bit."""


def with_extremes(mesh: Mesh) -> Mesh:
    """The mesh in 16 bits; some normals have components of -32768, which stand for -1 too, and are
    nearly as much too long as they may be."""
    stored = quantise(mesh).quantised
    assert stored is not None
    normals = stored.normals.copy()
    normals[:3] = 1400 * np.roll(np.eye(3), 1, axis=1) - 32768 * np.eye(3)
    return replace(stored, normals=normals).restored()


def restored(geometry: Mesh | Curves) -> tuple[np.ndarray, np.ndarray]:
    """Rows of vertices or points, and their tolerances, float64: position, normal, texture
    coordinate, 8 columns; or point, radius, 4."""
    rows = _of_curves(geometry) if isinstance(geometry, Curves) else _of_mesh(geometry)
    tolerance = np.zeros_like(rows)
    if isinstance(geometry, Mesh):
        tolerance[:, 3:6] = NORMAL_TOLERANCE
    return rows, tolerance


def _of_mesh(mesh: Mesh) -> np.ndarray:
    stored = mesh.quantised
    if stored is None:
        uvs = np.zeros((len(mesh.positions), 2)) if mesh.uvs is None else mesh.uvs
        return np.hstack([mesh.positions, mesh.normals, uvs]).astype(np.float64)
    assert stored.uvs is not None and stored.uvs.dtype == np.uint16
    positions = stored.translation + stored.scale * stored.positions.astype(np.float64)
    normals = np.maximum(stored.normals.astype(np.float64) / 32767, -1)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    uvs = stored.uvs.astype(np.float64) / 65535
    rows = np.hstack([positions.astype(np.float32), normals, uvs.astype(np.float32)])
    return rows.astype(np.float64)


def _of_curves(curves: Curves) -> np.ndarray:
    stored = curves.quantised
    assert stored is not None
    step, unit = stored.scales.astype(np.float64)
    points, used = [], 0
    for k, origin in enumerate(stored.origins.astype(np.float64)):
        count = int(stored.offsets[k + 1]) - int(stored.offsets[k]) - 1
        steps = stored.steps[used : used + count].astype(np.float64)
        points.append(origin + step * np.cumsum(np.vstack([np.zeros(3), steps]), axis=0))
        used += count
    radii = unit * stored.radii.astype(np.float64)
    rows = np.hstack([np.concatenate(points), radii[:, None]])
    return rows.astype(np.float32).astype(np.float64)
