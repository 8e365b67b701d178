"""A .blend file with some objects alone, for the capture."""

import bpy
import mathutils


def frame_of(item):
    """Transform of the asset's object space: the object's translation and rotation, no scale."""
    translation, turn, _ = item.matrix_world.decompose()
    return mathutils.Matrix.LocRotScale(translation, turn, None)


def with_children(items):
    """The objects and all below them, parents first."""
    result = []
    for item in items:
        for one in (item, *item.children_recursive):
            if one not in result:
                result.append(one)
    return sorted(result, key=_depth)


def _depth(item):
    return 0 if item.parent is None else 1 + _depth(item.parent)


def write_source(path, scene, items, frame):
    """Write `items` as they stand now, in the space of `frame`, in a copy of the scene's settings.

    path: of the file. items: parents before children.
    """
    scene_copy = scene.copy()
    copies = {}
    try:
        for collection in list(scene_copy.collection.children):
            scene_copy.collection.children.unlink(collection)
        for item in list(scene_copy.collection.objects):
            scene_copy.collection.objects.unlink(item)
        for item in items:
            copies[item] = _placed_copy(item, copies, frame)
            scene_copy.collection.objects.link(copies[item])
        bpy.data.libraries.write(str(path), {scene_copy}, path_remap="ABSOLUTE", compress=True)
    finally:
        for copy in copies.values():
            bpy.data.objects.remove(copy)
        bpy.data.scenes.remove(scene_copy)


def _placed_copy(item, copies, frame):
    """Copies an object, sharing its data: below its parent's copy, or with its world transform."""
    copy = item.copy()
    if item.parent in copies:
        copy.parent = copies[item.parent]
        return copy
    matrix = frame.inverted() @ item.matrix_world
    copy.animation_data_clear()
    for constraint in list(copy.constraints):
        copy.constraints.remove(constraint)
    copy.parent = None
    copy.rotation_mode = "QUATERNION"
    copy.delta_location, copy.delta_scale = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)
    copy.delta_rotation_quaternion = (1.0, 0.0, 0.0, 0.0)
    copy.matrix_world = matrix
    return copy
