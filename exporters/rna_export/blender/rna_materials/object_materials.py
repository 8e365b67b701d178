"""The materials of rendered geometry."""

import bpy
from rna_geometry.shown_objects import HAIR, SURFACES


def materials_of(item: bpy.types.Object) -> list[bpy.types.Material | None]:
    """The original materials of an evaluated object, by index; [None] for an object without slots.

    Geometry nodes may have set others than the slots have.
    """
    slots = [slot.material for slot in item.material_slots]
    materials = [*slots, *(item.data.materials[len(slots) :])] or [None]
    return [None if m is None else m.original for m in materials]


def override() -> None:
    """Give all objects the material that the view layer shows in the place of all others.

    The holes of a material that is not rendered are none.
    """
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
