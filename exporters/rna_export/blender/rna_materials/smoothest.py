"""The smoothest highlight of the shown materials, which views have to look for."""

from __future__ import annotations

from collections.abc import Iterator

import bpy
from rna_materials.material_check import nodes_before, shown_materials

_MIRRORS = ("BSDF_GLOSSY", "BSDF_METALLIC", "BSDF_GLASS", "BSDF_REFRACTION")
_SHOWS = {"Metallic", "Specular IOR Level", "Transmission Weight"}
"""Inputs of a Principled BSDF; where all are 0 it has no highlight but that of its coat."""


def smoothest() -> tuple[str, float] | None:
    """Name and roughness of the material with the least one; None without a highlight.

    Roughness from a texture or a node does not count.
    """
    found = [
        (roughness, material.name)
        for material, _ in shown_materials()
        if material is not None and material.node_tree is not None
        for roughness in _of_material(material)
    ]
    return min(found)[::-1] if found else None


def _of_material(material: bpy.types.Material) -> Iterator[float]:
    output = material.node_tree.get_output_node("CYCLES")
    for node in [] if output is None else nodes_before(output):
        for name in _roughness_inputs(node):
            if not node.inputs[name].is_linked:
                yield node.inputs[name].default_value


def _roughness_inputs(node: bpy.types.Node) -> Iterator[str]:
    if node.type in _MIRRORS or (
        node.type == "BSDF_PRINCIPLED" and any(_is_on(node, name) for name in _SHOWS)
    ):
        yield "Roughness"
    if node.type == "BSDF_PRINCIPLED" and _is_on(node, "Coat Weight"):
        yield "Coat Roughness"


def _is_on(node: bpy.types.Node, name: str) -> bool:
    return bool(node.inputs[name].is_linked or node.inputs[name].default_value > 0.0)
