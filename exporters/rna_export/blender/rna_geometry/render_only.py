"""Refuses shapes that only Cycles makes while it renders: their geometry cannot be exported."""

import bpy
from rna_geometry import shown_objects
from rna_geometry.shown_objects import SURFACES
from rna_materials.object_materials import materials_of


def refuse() -> None:
    """Raise ValueError for true displacement and adaptive subdivision of visible objects."""
    for instance in shown_objects.seen():
        item = instance.object.original
        if item.type in SURFACES:
            _check_modifiers(item)
            for material in materials_of(instance.object):
                if material is not None:
                    _check_displacement(material)


def _check_modifiers(item: bpy.types.Object) -> None:
    for modifier in item.modifiers:
        if modifier.type == "SUBSURF" and modifier.show_render:
            if modifier.use_adaptive_subdivision:
                raise ValueError(
                    f"object {item.name!r} has adaptive subdivision, whose geometry depends on the "
                    "camera: turn it off in the modifier and set Levels Render instead"
                )


def _check_displacement(material: bpy.types.Material) -> None:
    if material.displacement_method == "BUMP" or material.node_tree is None:
        return
    output = material.node_tree.get_output_node("CYCLES")
    if output is not None and output.inputs["Displacement"].is_linked:
        raise ValueError(
            f"material {material.name!r} displaces its surface while it renders: bake that into "
            "the mesh, or set the material's Displacement to Bump Only, which becomes a normal map "
            "where its height follows a UV map"
        )
