"""Blender's camera as a scene file's."""

import math

import mathutils

from ..axes import vector_from_blender
from ..sdk import SdkError


def describe_camera(depsgraph, resolution, notes):
    """The `camera` of the scene file. Raises SdkError for a camera that is no pinhole's."""
    scene = depsgraph.scene
    if scene.camera is None:
        raise SdkError("the scene has no camera")
    item = scene.camera.evaluated_get(depsgraph)
    camera = item.data
    if camera.type != "PERSP":
        raise SdkError(f"camera {item.name!r}: found type {camera.type}, expected PERSP")
    render = scene.render
    if render.pixel_aspect_x != render.pixel_aspect_y:
        notes.add("pixels that are not square are rendered as square ones")
    if camera.dof.use_dof:
        notes.add("depth of field is left out: everything is sharp", item.name)
    width, height = resolution
    projection = item.calc_matrix_camera(depsgraph, x=width, y=height)
    if abs(projection[0][2]) + abs(projection[1][2]) > 1e-6:
        notes.add("the lens's shift is left out", item.name)
    position, forward, up = axes_of(item)
    return {
        "position": vector_from_blender(position),
        "look_at": vector_from_blender(position + forward),
        "up": vector_from_blender(up),
        "vertical_fov_deg": math.degrees(2.0 * math.atan(1.0 / projection[1][1])),
    }


def axes_of(item):
    """Position, unit direction of view and unit up of a camera or lamp, in Blender's world."""
    matrix = item.matrix_world
    turn = matrix.to_quaternion()
    forward, up = (turn @ mathutils.Vector(v) for v in ((0, 0, -1), (0, 1, 0)))
    return matrix.translation.copy(), forward, up
