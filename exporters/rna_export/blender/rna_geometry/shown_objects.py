"""Rendered objects, including all instances."""

from __future__ import annotations

from collections.abc import Iterator

import bpy
from rna_geometry import rendered_geometry


def instances() -> Iterator[bpy.types.DepsgraphObjectInstance]:
    """Depsgraph instances that renders show; each is valid until the next one is requested."""
    for instance in rendered_geometry.depsgraph().object_instances:
        item = instance.object.original
        if instance.show_self and not item.hide_render:
            if instance.is_instance or not _is_pattern(item):
                yield instance


def seen() -> Iterator[bpy.types.DepsgraphObjectInstance]:
    """Those of `instances` that camera rays see, and so belong to the package."""
    for instance in instances():
        parent = instance.parent.original if instance.is_instance else None
        if instance.object.original.visible_camera and (parent is None or parent.visible_camera):
            yield instance


def _is_pattern(item: bpy.types.Object) -> bool:
    """Whether an object is shown only where its parent instances it."""
    return item.parent is not None and item.parent.instance_type in ("VERTS", "FACES")
