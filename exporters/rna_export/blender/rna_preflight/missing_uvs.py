"""Images that lie on UV coordinates which an object has not: renders show one colour of them."""

from collections.abc import Iterator

import bpy
from rna_geometry import shown_objects
from rna_geometry.attributes import uv_map
from rna_materials.material_check import of_image
from rna_materials.node_sources import Inside, origin
from rna_materials.object_materials import materials_of
from rna_materials.uv_render import surface_sources


def problems() -> list[str]:
    """One sentence a material, with the name of one such object; within `as_rendered`."""
    result: dict[str, str] = {}
    for instance in shown_objects.seen():
        item = instance.object
        if item.type != "MESH" or uv_map(item.data, "") is not None:
            continue
        for material in materials_of(item):
            if material is None or material.name_full in result or material.node_tree is None:
                continue
            for image in _images_on_uvs(material):
                result[material.name_full] = (
                    f"object {item.original.name!r} has no UV map, and shows one colour of the "
                    f"image {image.name!r} of its material {material.name!r}: unwrap it (U in "
                    "Edit Mode)"
                )
    return list(result.values())


def _images_on_uvs(material: bpy.types.Material) -> Iterator[bpy.types.Image]:
    for node, _, inside in surface_sources(material):
        if node.type == "TEX_IMAGE" and _is_on_uvs(node, inside) and of_image(node.image) is None:
            yield node.image


def _is_on_uvs(node: bpy.types.Node, inside: Inside) -> bool:
    source = origin(node.inputs["Vector"], inside)
    while source is not None and source[0].type == "MAPPING":
        source = origin(source[0].inputs["Vector"], source[2])
    if source is None or source[0].type == "UVMAP":
        return True
    return bool(source[0].type == "TEX_COORD" and source[1].name == "UV")
