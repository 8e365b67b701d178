"""Materials that look otherwise in another frame: no model of several poses can follow them."""

from collections.abc import Iterator

import bpy
from rna_materials.material_uses import named, shown_materials
from rna_materials.uv_render import surface_sources


def changing() -> list[str]:
    """The shown materials that change with the frame, each with its cause; within `as_rendered`."""
    shown = named(set().union(*shown_materials()))
    found = ((m, next(_changes(m), None)) for m in shown)
    return [f"material {m.name!r} {what}" for m, what in found if what is not None]


def _changes(material: bpy.types.Material) -> Iterator[str]:
    nodes = [node for node, _, _ in surface_sources(material)]
    for node in nodes:
        if node.type == "TEX_IMAGE" and node.image and node.image.source in ("MOVIE", "SEQUENCE"):
            yield f"plays the image {node.image.name!r}"
    trees = [material, material.node_tree, *(node.id_data for node in nodes)]
    if any(tree is not None and _is_animated(tree.animation_data) for tree in trees):
        yield "is animated"


def _is_animated(data: bpy.types.AnimData | None) -> bool:
    return data is not None and bool(data.action or data.drivers or data.nla_tracks)
