"""Meshes whose faces name vertices that they lack: Python and Cycles would read beyond arrays."""

import bpy
import numpy as np
from rna_geometry.attributes import read


def repair() -> list[str]:
    """Remove such faces from all meshes; a note for each mesh."""
    notes = []
    for mesh in bpy.data.meshes:
        if not _is_whole(mesh):
            faces = len(mesh.polygons)
            mesh.validate()
            notes.append(
                f"mesh {mesh.name!r} is invalid: faces or edges name vertices that it lacks; "
                f"{faces - len(mesh.polygons):,} of {faces:,} faces were left out"
            )
    return notes


def _is_whole(mesh: bpy.types.Mesh) -> bool:
    vertices, loops = len(mesh.vertices), len(mesh.loops)
    corners = read(mesh.loops, "vertex_index", loops, np.int32)
    edges = read(mesh.edges, "vertices", 2 * len(mesh.edges), np.int32)
    starts = read(mesh.polygons, "loop_start", len(mesh.polygons), np.int32)
    sizes = read(mesh.polygons, "loop_total", len(mesh.polygons), np.int32)
    ends = starts + sizes
    return all(
        not len(index) or (index.min() >= 0 and index.max() < limit)
        for index, limit in ((corners, vertices), (edges, vertices), (ends - 1, loops))
    )
