"""Loaded meshes are made whole, and their polygons sorted."""

import bmesh
import bpy
import numpy as np
from rna_geometry.attributes import read


def repair() -> list[str]:
    """Remove faces that name vertices which the mesh lacks; a note for each mesh.

    Python and Cycles would read beyond arrays.
    """
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


def sort_polygons() -> None:
    """Sort the polygons of all meshes by their vertices.

    Operators, such as the one for UV spheres, make them in the order of addresses in memory.
    """
    for mesh in bpy.data.meshes:
        keys = [tuple(polygon.vertices) for polygon in mesh.polygons]
        order = sorted(range(len(keys)), key=keys.__getitem__)
        if order == list(range(len(keys))):
            continue
        sorted_mesh = bmesh.new()
        sorted_mesh.from_mesh(mesh)
        sorted_mesh.faces.ensure_lookup_table()
        faces = list(sorted_mesh.faces)
        for rank, place in enumerate(order):
            faces[place].index = rank
        sorted_mesh.faces.sort()
        sorted_mesh.to_mesh(mesh)
        sorted_mesh.free()
