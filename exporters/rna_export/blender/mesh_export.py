"""Exports every mesh of the scene, as Cycles will render it, into one triangle soup."""

import numpy as np
import shown_objects
from top_objects import SURFACES, top_object


def export_mesh(path, owner=None):
    """Write an .npz with `positions`, `normals` (3t, 3), `uvs` (3t, 2) and `has_uv`.

    One row a triangle corner, world space, Blender's axes, float32. owner: the top object whose
    meshes are meant; None: all.
    """
    shown = (i for i in _mesh_instances() if owner in (None, top_object(i)))
    corners = [_corners(instance) for instance in shown]
    if not corners:
        raise ValueError("the scene has no mesh with faces")
    positions, normals, uvs, has_uv = zip(*corners, strict=True)
    np.savez(
        path,
        positions=np.concatenate(positions),
        normals=np.concatenate(normals),
        uvs=np.concatenate(uvs),
        has_uv=all(has_uv),
    )
    return {"triangles": int(sum(len(p) for p in positions) // 3)}


def owners():
    """Names of the top objects that renders show as a surface, each once."""
    found = {}
    for instance in _mesh_instances():
        owner = top_object(instance)
        if owner not in found and _has_faces(instance.object):
            found[owner] = True
    return list(found)


def _has_faces(item):
    faces = len(item.to_mesh().polygons)
    item.to_mesh_clear()
    return faces > 0


def _mesh_instances():
    for instance in shown_objects.instances():
        if instance.object.type in SURFACES:
            yield instance


def _corners(instance):
    mesh = instance.object.to_mesh()
    try:
        mesh.calc_loop_triangles()
        triangles = len(mesh.loop_triangles)
        loops = _read(mesh.loop_triangles, "loops", 3 * triangles, np.int32)
        vertices = _read(mesh.loop_triangles, "vertices", 3 * triangles, np.int32)
        positions = _read(mesh.vertices, "co", 3 * len(mesh.vertices)).reshape(-1, 3)[vertices]
        normals = _read(mesh.corner_normals, "vector", 3 * len(mesh.loops)).reshape(-1, 3)[loops]
        layer = mesh.uv_layers.active
        uvs = np.zeros((len(loops), 2), np.float32)
        if layer is not None:
            uvs = _read(layer.uv, "vector", 2 * len(mesh.loops)).reshape(-1, 2)[loops]
            uvs[:, 1] = 1.0 - uvs[:, 1]  # glTF counts v from the top
        matrix = np.array(instance.matrix_world, np.float32)
    finally:
        instance.object.to_mesh_clear()
    return (*_place(positions, normals, matrix), uvs, layer is not None)


def _place(positions, normals, matrix):
    world = positions @ matrix[:3, :3].T + matrix[:3, 3]
    turned = normals @ np.linalg.inv(matrix[:3, :3].astype(np.float64))
    turned /= np.maximum(np.linalg.norm(turned, axis=1, keepdims=True), 1e-30)
    if np.linalg.det(matrix[:3, :3].astype(np.float64)) < 0:  # a mirrored object keeps its outside
        world = world.reshape(-1, 3, 3)[:, ::-1].reshape(-1, 3)
        turned = turned.reshape(-1, 3, 3)[:, ::-1].reshape(-1, 3)
    return world.astype(np.float32), turned.astype(np.float32)


def _read(collection, attribute, size, dtype=np.float32):
    values = np.empty(size, dtype)
    collection.foreach_get(attribute, values)
    return values
