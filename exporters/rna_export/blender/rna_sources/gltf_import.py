"""Imports glTF, with the members that Blender's importer ignores in silence."""

from typing import Any

import bpy
from rna_sources import gltf_variants

_VISIBILITY = "KHR_node_visibility"


def load(source: str) -> list[str]:
    """Add the contents of a .gltf or .glb file to the scene; returns notes for the user."""
    from io_scene_gltf2.io.imp.gltf2_io_gltf import glTFImporter

    notes: list[str] = []
    read: list[Any] = []
    checks = glTFImporter.checks

    def checks_and_ours(importer: Any) -> None:
        importer.extensions_managed.append(_VISIBILITY)
        checks(importer)
        read.extend((importer.data, gltf_variants.described(importer.data)))
        notes.extend(_hide_nodes(importer.data))
        notes.extend(_unknown(importer.data, importer.extensions_managed))

    glTFImporter.checks = checks_and_ours
    try:
        bpy.ops.import_scene.gltf(filepath=source)
    finally:
        glTFImporter.checks = checks
    if bpy.data.actions:  # at their first keys, which clips of one character may share; 1 is later
        bpy.context.scene.frame_start = 0
        bpy.context.scene.frame_set(0)
    return [*notes, *gltf_variants.read(*read)]


def _hide_nodes(data: Any) -> list[str]:
    """Empty the nodes that the file hides, and all below them."""
    nodes = data.nodes or []
    hidden = [k for k, node in enumerate(nodes) if not _is_visible(node)]
    below = list(hidden)
    for k in below:  # grows as it goes
        children = nodes[k].children or []
        below += [c for c in children if 0 <= c < len(nodes) and c not in below]
    for k in below:
        nodes[k].mesh = nodes[k].skin = None
        (nodes[k].extensions or {}).pop("EXT_mesh_gpu_instancing", None)
    if not below:
        return []
    named = "node" if len(below) == 1 else "nodes"
    return [f"left out {len(below)} {named} that the file hides ({_VISIBILITY})"]


def _is_visible(node: Any) -> bool:
    extension = (node.extensions or {}).get(_VISIBILITY)
    return not isinstance(extension, dict) or extension.get("visible", True) is not False


def _unknown(data: Any, known: list[str]) -> list[str]:
    names = [name for name in data.extensions_used or [] if name not in known]
    if not names:
        return []
    return [f"Blender's importer does not know {', '.join(sorted(names))}, and passes over it"]
