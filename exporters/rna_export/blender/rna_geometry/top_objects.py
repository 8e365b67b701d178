"""The owner object of rendered geometry."""

from __future__ import annotations

import bpy

SURFACES = ("MESH", "CURVE", "SURFACE", "FONT", "META")
"""Types of objects that renders show as surfaces."""

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
