"""Meshes of Blender, as renders show them, as glTF files."""

import numpy as np

from ..axes import from_blender
from .glb import Glb
from .materials import describe_material


class Meshes:
    """Writes each mesh once; returns its path.

    folder: for the files.
    """

    def __init__(self, folder, notes):
        self._folder, self._notes = folder, notes
        self._written = {}

    def write(self, item, matrix=None):
        """The file's name of an evaluated object's mesh; None if it has no triangles.

        matrix: baked into it, 4 x 4 of Blender's; None for the object's own space.
        """
        key = _key(item), None if matrix is None else tuple(map(tuple, matrix))
        if key not in self._written:
            self._written[key] = self._write(item, matrix, len(self._written))
        return self._written[key]

    def _write(self, item, matrix, number):
        mesh = item.to_mesh()
        if mesh is None:  # bare curves of geometry nodes
            return None
        try:
            glb = mesh_glb(item, mesh, matrix, self._notes)
        finally:
            item.to_mesh_clear()
        if glb is None:
            return None
        name = f"mesh-{number:03d}.glb"
        (self._folder / name).write_bytes(glb.to_bytes())
        return name


def _key(item):
    """Objects with the same are of one shape and one look."""
    if item.type != "MESH":
        return item.original.session_uid
    data = item.data.original or item.data
    changed = item.original.session_uid if item.modifiers or item.data.shape_keys else 0
    # What geometry nodes instance has no original: its address is its own during a render.
    identifier = data.session_uid or item.data.as_pointer()
    slots = tuple(slot.material.session_uid if slot.material else 0 for slot in item.material_slots)
    return identifier, changed, slots


def mesh_glb(item, mesh, matrix, notes):
    """The mesh in +Y up, its triangles by material; None if there are none."""
    mesh.calc_loop_triangles()
    count = len(mesh.loop_triangles)
    if not count:
        return None
    corners = _read(mesh.loop_triangles, "loops", 3 * count, np.int32)
    vertices = _read(mesh.loop_triangles, "vertices", 3 * count, np.int32)
    slots = _read(mesh.loop_triangles, "material_index", count, np.int32)
    rows = {
        "POSITION": _read(mesh.vertices, "co", (len(mesh.vertices), 3))[vertices],
        "NORMAL": _read(mesh.corner_normals, "vector", (len(mesh.loops), 3))[corners],
    }
    layer = next((layer for layer in mesh.uv_layers if layer.active_render), None)
    if layer is not None:
        uvs = _read(layer.uv, "vector", (len(mesh.loops), 2))[corners]
        rows["TEXCOORD_0"] = uvs * np.float32([1, -1]) + np.float32([0, 1])
    if matrix is not None:
        rows = _transformed(rows, np.array(matrix, np.float64))
    for name in ("POSITION", "NORMAL"):
        rows[name] = from_blender(rows[name])
    glb = Glb()
    for slot in np.unique(slots):
        material = _material_of(item, mesh, slot)
        index = glb.add_material(describe_material(material, glb, notes))
        chosen = np.repeat(slots == slot, 3)
        glb.add_triangles(index, **{name: values[chosen] for name, values in rows.items()})
    return glb


def _material_of(item, mesh, slot):
    slots = item.material_slots
    if slots:
        return slots[min(slot, len(slots) - 1)].material
    return mesh.materials[min(slot, len(mesh.materials) - 1)] if mesh.materials else None


def _transformed(rows, matrix):
    """Under an affine map; a mirror turns triangles round."""
    linear = matrix[:3, :3]
    normals = rows["NORMAL"] @ np.linalg.inv(linear)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    moved = {
        **rows,
        "POSITION": (rows["POSITION"] @ linear.T + matrix[:3, 3]).astype(np.float32),
        "NORMAL": (normals / np.maximum(length, 1e-30)).astype(np.float32),
    }
    if np.linalg.det(linear) > 0.0:
        return moved
    return {n: v.reshape(-1, 3, v.shape[1])[:, ::-1].reshape(v.shape) for n, v in moved.items()}


def _read(collection, name, shape, dtype=np.float32):
    values = np.empty(int(np.prod(shape)), dtype)
    collection.foreach_get(name, values)
    return values.reshape(shape)
