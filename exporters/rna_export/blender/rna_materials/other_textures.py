"""Images that shaders read beside base colour and normals: planes learn them."""

from typing import Any

import bpy
import numpy as np
from rna_materials.base_color_source import COLOURS
from rna_materials.node_sources import sources
from rna_materials.uv_dependence import IDENTITY, dependence
from rna_materials.uv_render import surface_sources

_MAPPED = ("Normal", "Coat Normal", "Alpha")


def texels_of_inputs(
    material: bpy.types.Material, chart: dict[str, Any] | None
) -> dict[str, float]:
    """Inputs of a material's shaders with images -> texels in a unit square of its chart, the most.

    chart: see `surface_textures.export_textures`; None for UVs as they are.
    """
    matrix = IDENTITY if chart is None else np.array(chart["matrix"])
    scale = abs(np.linalg.det(matrix[:, :2]))
    result: dict[str, float] = {}
    for node, _, inside in surface_sources(material):
        if node.type not in COLOURS or scale == 0.0:
            continue
        for socket in node.inputs:
            if socket.name in (*_MAPPED, COLOURS[node.type]):
                continue
            for image in dependence(sources(socket, inside)).images:
                texels = image.size[0] * image.size[1]
                texels *= abs(np.linalg.det(image.mapping[:, :2])) / scale
                result[socket.name] = max(result.get(socket.name, 0.0), float(texels))
    return result
