"""The materials of rendered geometry."""

from __future__ import annotations

import bpy


def materials_of(item: bpy.types.Object) -> list[bpy.types.Material | None]:
    """The original materials of an evaluated object, by index; [None] for an object without slots.

    Geometry nodes may have set others than the slots have.
    """
    slots = [slot.material for slot in item.material_slots]
    materials = [*slots, *(item.data.materials[len(slots) :])] or [None]
    return [None if m is None else m.original for m in materials]
