"""The evaluated scene of a render, its objects with all instances, and who owns them.

The viewport's may be another one.
"""

from collections.abc import Callable, Iterator
from typing import TypeVar

import bpy
import numpy as np

Result = TypeVar("Result")


class _Geometry(bpy.types.RenderEngine):  # type: ignore[misc]
    """Renders nothing. An engine is handed the geometry of renders; Python gets it in no other way.

    Blender makes the instances, so what they are to do stands in the class.
    """

    bl_idname, bl_label = "RNA_GEOMETRY", "RNA geometry"
    work: Callable[[], None] = lambda: None
    depsgraph: bpy.types.Depsgraph | None = None

    def render(self, depsgraph: bpy.types.Depsgraph) -> None:
        _Geometry.depsgraph = depsgraph
        try:
            _Geometry.work()
        finally:
            _Geometry.depsgraph = None


def as_rendered(work: Callable[[], Result]) -> Result:
    """Calls `work` while `depsgraph()` is a render's; returns its result. It may change nothing."""
    answers: list[Result] = []
    errors: list[Exception] = []

    def stored() -> None:
        try:
            answers.append(work())
        except Exception as error:  # Blender would print it and go on
            errors.append(error)

    scene = bpy.context.scene
    before = scene.render.engine, scene.camera
    camera = bpy.data.cameras.new("rna geometry")
    scene.camera = bpy.data.objects.new("rna geometry", camera)
    scene.collection.objects.link(scene.camera)
    _Geometry.work = stored
    bpy.utils.register_class(_Geometry)
    try:
        scene.render.engine = _Geometry.bl_idname
        bpy.ops.render.render()
    finally:
        bpy.data.cameras.remove(camera)  # and its object
        scene.render.engine, scene.camera = before
        bpy.utils.unregister_class(_Geometry)
    if errors:
        raise errors[0]
    if not answers:
        raise RuntimeError("Blender started no render")
    return answers[0]


def depsgraph() -> bpy.types.Depsgraph:
    """The evaluated scene: a render's within `as_rendered`, else the viewport's."""
    return _Geometry.depsgraph or bpy.context.evaluated_depsgraph_get()


SURFACES = ("MESH", "CURVE", "SURFACE", "FONT", "META")
"""Types of objects that renders show as surfaces, each as a mesh."""

HAIR = "CURVES"


def top_object(instance: bpy.types.DepsgraphObjectInstance) -> str:
    """The name of the highest of an instance's object and its parents that shows something."""
    item = (instance.parent if instance.is_instance else instance.object).original
    top = item
    while item.parent is not None:
        item = item.parent
        if item.type in (*SURFACES, HAIR):
            top = item
    return str(top.name)


def instances() -> Iterator[bpy.types.DepsgraphObjectInstance]:
    """Depsgraph instances that renders show; each is valid until the next one is requested."""
    for instance in _not_hidden():
        if _is_rendered(instance.object):
            yield instance


def _is_rendered(item: bpy.types.Object) -> bool:
    """Whether Cycles renders the data of an evaluated object: no surface but meshes, none empty.

    The mesh of a text, curve, NURBS surface or metaball is listed beside it, as an instance.
    """
    if item.type == "MESH":
        return len(item.data.polygons) > 0
    if item.type in (HAIR, "POINTCLOUD"):
        return len(item.data.points) > 0
    return item.type not in SURFACES


def bare_curves() -> list[str]:
    """Names of objects with curves that have no surface and are no hair, such as guides."""
    return list(
        dict.fromkeys(
            str(instance.object.original.name)
            for instance in _not_hidden()
            if _is_bare_curve(instance.object)
        )
    )


def _is_bare_curve(item: bpy.types.Object) -> bool:
    """Whether an evaluated object is curves of geometry nodes beside a mesh: renders show none."""
    return item.type == "CURVE" and item.original.type != "CURVE" and item.to_mesh() is None


def _not_hidden() -> Iterator[bpy.types.DepsgraphObjectInstance]:
    for instance in depsgraph().object_instances:
        item = instance.object.original
        # Geometry nodes and particles show instances of objects that are hidden themselves.
        if instance.show_self and (
            instance.is_instance or not (item.hide_render or _is_pattern(item))
        ):
            yield instance


def seen() -> Iterator[bpy.types.DepsgraphObjectInstance]:
    """Those of `instances` that camera rays see, and so belong to the package."""
    for instance in instances():
        parent = instance.parent.original if instance.is_instance else None
        if instance.object.original.visible_camera and (parent is None or parent.visible_camera):
            yield instance


def longest_side() -> float:
    """Longest side of the box around the boxes of all objects that camera rays see."""
    corners = [
        np.array([*map(list, instance.object.bound_box)]) @ matrix[:3, :3].T + matrix[:3, 3]
        for instance in seen()
        if instance.object.type in (*SURFACES, HAIR)
        for matrix in [np.array(instance.matrix_world)]
    ]
    return float(np.ptp(np.concatenate(corners), axis=0).max()) if corners else 0.0


def _is_pattern(item: bpy.types.Object) -> bool:
    """Whether an object is shown only where its parent instances it."""
    return item.parent is not None and item.parent.instance_type in ("VERTS", "FACES")
