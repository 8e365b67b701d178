"""Objects that a capture leaves out because renders do, and objects far larger than the rest."""

import bpy
import numpy as np
from listing import listed
from rna_geometry import shown_objects
from rna_geometry.shown_objects import HAIR, SURFACES, top_object

_BACKDROP = 12.0  # times as long as all else


def unrendered() -> str | None:
    """Names of meshes, texts and hair of the scene that renders do not show; within `as_rendered`.

    Emitters of hair that are hidden themselves do not count, nor what shapes something else, as
    cutters and the sources of instances do.
    """
    shown = set()
    for instance in shown_objects.instances():
        shown.add(instance.object.original.name_full)
        if instance.is_instance:
            shown.add(instance.parent.original.name_full)
    hidden = [
        item
        for item in bpy.context.scene.objects
        if item.name_full not in shown and _has_shape(item) and item.show_instancer_for_render
    ]
    users = bpy.data.user_map(subset=hidden)
    names = [item.name for item in hidden if not any(_is_shaped(u, item) for u in users[item])]
    return listed([*map(repr, names)]) or None


def _is_shaped(user: bpy.types.ID, item: bpy.types.Object) -> bool:
    """Whether a data-block that names an object is shaped by it, or is made of it."""
    if isinstance(user, bpy.types.Object):
        return bool(user != item and user.parent != item)
    return isinstance(user, bpy.types.GeometryNodeTree | bpy.types.ParticleSettings)


def notes() -> list[str]:
    """Notes for the user about left-out objects and backdrops; within `as_rendered`."""
    result, names = [], unrendered()
    if names is not None:
        result.append(f"left out, since renders do not show them: {names}")
    large = _much_the_longest()
    if large is not None:
        name, times = large
        result.append(
            f"object {name!r} is {times:.0f} times as long as all else together, which gets that "
            "much less detail: if it is a floor or a backdrop, hide it in renders (the camera icon)"
        )
    return result


def _has_shape(item: bpy.types.Object) -> bool:
    solid = item.type in (HAIR, "FONT", "SURFACE")
    return bool(solid or (item.type == "MESH" and len(item.data.polygons)))


def _much_the_longest() -> tuple[str, float] | None:
    """The top object beside which all else is small, and how many times as long it is."""
    boxes: dict[str, np.ndarray] = {}
    for instance in shown_objects.seen():
        if instance.object.type in (*SURFACES, HAIR):
            matrix = np.array(instance.matrix_world)
            corners = np.array([*map(list, instance.object.bound_box)]) @ matrix[:3, :3].T
            box = np.array([corners.min(axis=0), corners.max(axis=0)]) + matrix[:3, 3]
            name = top_object(instance)
            boxes[name] = _around([boxes.get(name, box), box])
    if len(boxes) < 2:
        return None
    name = max(boxes, key=lambda each: _longest(boxes[each]))
    rest = _longest(_around([box for other, box in boxes.items() if other != name]))
    times = _longest(boxes[name]) / rest if rest > 0.0 else 0.0
    return (name, times) if times >= _BACKDROP else None


def _around(boxes: list[np.ndarray]) -> np.ndarray:
    """The box (2, 3) around boxes."""
    return np.array([np.min([b[0] for b in boxes], axis=0), np.max([b[1] for b in boxes], axis=0)])


def _longest(box: np.ndarray) -> float:
    return float((box[1] - box[0]).max())
