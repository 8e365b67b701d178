"""One order of polygons for every process: sums over them, such as normals, depend on it."""

import bmesh
import bpy


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
