"""Rotates a loaded source to Blender's front and up axes: -Y and +Z."""

import bpy
import mathutils

_UP_IS_Z = mathutils.Matrix.Identity(3)
_UP_IS_Y = mathutils.Matrix(((1, 0, 0), (0, 0, -1), (0, 1, 0)))  # what importers do


def turn(front: str | None, up: str | None, up_is_z: bool) -> None:
    """Turn all objects; `front`, `up`: axes of the file such as "-Y", None for the usual ones.

    up_is_z: whether the file's own up is its z axis; if not, it is y.
    """
    if front is None and up is None:
        return
    up = up or ("Z" if up_is_z else "Y")
    front = front or ("-Y" if up[-1] == "Z" else "Z")
    if front[-1] == up[-1]:
        raise ValueError(f"front {front} and up {up} are along one axis: give --front and --up")
    to_blender = _UP_IS_Z if up_is_z else _UP_IS_Y
    f, u = (to_blender @ _axis(name) for name in (front, up))
    # Rows: where Blender's x, y and z come from.
    matrix = mathutils.Matrix(((-f).cross(u), -f, u))
    scene = bpy.context.scene
    handle = bpy.data.objects.new("rna turned", None)
    for item in list(scene.objects):
        if item.parent is None:
            item.parent = handle  # without an inverse the handle's matrix goes before its own
    handle.matrix_world = matrix.to_4x4()
    scene.collection.objects.link(handle)


def _axis(name: str) -> mathutils.Vector:
    vector = mathutils.Vector((0.0, 0.0, 0.0))
    vector["XYZ".index(name[-1])] = -1.0 if name[0] == "-" else 1.0
    return vector
