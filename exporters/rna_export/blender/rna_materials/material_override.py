"""The material that a view layer shows in the place of all others."""

from __future__ import annotations

import bpy
from rna_geometry.top_objects import HAIR, SURFACES


def apply() -> None:
    """Give it to all objects: the holes of a material that is not rendered are none."""
    material = bpy.context.view_layer.material_override
    if material is None:
        return
    for item in bpy.data.objects:
        if item.type not in (*SURFACES, HAIR):
            continue
        if not item.material_slots and item.data.is_editable:
            item.data.materials.append(material)
        for slot in item.material_slots:
            slot.link, slot.material = "OBJECT", material
