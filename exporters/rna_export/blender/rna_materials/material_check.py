"""Reports materials that Cycles does not support.

Only what a shown object uses counts, and only nodes that lead to the output.
"""

from collections.abc import Iterator
from pathlib import Path

import bpy
from listing import listed
from rna_geometry import shown_objects
from rna_materials.object_materials import materials_of

_OF_EEVEE = {"SHADERTORGB": "Shader to RGB", "EEVEE_SPECULAR": "Specular BSDF"}
FIND = "use File > External Data > Find Missing Files, and save"
"""The remedy where a file that a .blend names is gone."""


def problems() -> list[str]:
    """Problems of the materials, one sentence each, with the name of the material."""
    result, bare = [], []
    for material, item in shown_materials():
        if material is None:
            bare.append(item)
        elif material.node_tree is not None:
            result += [f"material {material.name!r}: {what}" for what in _of_material(material)]
    return result + _of_bare(bare)


def shown_materials() -> Iterator[tuple[bpy.types.Material | None, str]]:
    """Each material once, or None with each object that has a slot without one."""
    seen = set()
    for instance in shown_objects.instances():
        item = instance.object.original
        if not hasattr(item.data, "materials"):
            continue
        for material in materials_of(instance.object):
            key = item.name if material is None else ("material", material.name_full)
            if key not in seen:
                seen.add(key)
                yield material, item.name


def _of_bare(names: list[str]) -> list[str]:
    if not names:
        return []
    named = listed([*map(repr, names)])
    return [f"without a material, and so of Cycles' usual grey: {named}"]


def _of_material(material: bpy.types.Material) -> list[str]:
    output = material.node_tree.get_output_node("CYCLES")
    if output is None:
        return ["it has no material output for Cycles; renders show it black"]
    if not any(output.inputs[name].is_linked for name in ("Surface", "Volume")):
        return ["nothing is connected to its output; renders show it black"]
    nodes = nodes_before(output)
    return list(dict.fromkeys(what for node in nodes if (what := _of_node(node)) is not None))


def nodes_before(output: bpy.types.Node) -> Iterator[bpy.types.Node]:
    """All nodes that a node depends on, including those inside groups, without muted ones."""
    todo, seen = [output], set()
    while todo:
        node = todo.pop()
        if node in seen or node.mute:
            continue
        seen.add(node)
        yield node
        todo += [link.from_node for socket in node.inputs for link in socket.links]
        if node.type == "GROUP" and node.node_tree is not None:
            todo += [n for n in node.node_tree.nodes if n.type == "GROUP_OUTPUT"]


def _of_node(node: bpy.types.Node) -> str | None:
    if node.bl_idname == "NodeUndefined":
        return f"the node {node.name!r} is of a kind that Blender {bpy.app.version_string} lacks"
    if node.type in _OF_EEVEE:
        return f"the node {_OF_EEVEE[node.type]!r} is for EEVEE only; Cycles leaves it out"
    if node.type in ("TEX_IMAGE", "TEX_ENVIRONMENT"):
        return of_image(node.image)
    if node.type == "SCRIPT":
        return _of_script(node)
    return None


def of_image(image: bpy.types.Image | None) -> str | None:
    """Why renders cannot show an image; None if they can."""
    if image is None:
        return "an image texture has no image; renders show it pink"
    if image.source == "GENERATED" or image.size[0]:
        image.buffers_free()  # asking for the size loads it
        return None
    path = bpy.path.abspath(image.filepath, library=image.library)
    reason = "cannot be read" if Path(path).is_file() else "is missing"
    return f"image {path!r} {reason}; renders show it pink: {FIND}"


def _of_script(node: bpy.types.Node) -> str | None:
    if not bpy.context.scene.cycles.shading_system:
        return (
            f"the script of the node {node.name!r} is left out: Open Shading Language is off in "
            "the scene"
        )
    if not node.bytecode and not node.filepath:
        return f"the script of the node {node.name!r} was never compiled; Cycles leaves it out"
    return None
