"""Meshes that are not neural, and what they are made of; `models` has what a scene file says.

The names below are loaded when they are asked for, so that a scene file's models need no Embree.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rna_sdk.lazy_face import lazy_face

if TYPE_CHECKING:
    from rna_render.materials.files.mesh_file import MeshFileWarning, read_mesh_object
    from rna_render.materials.ggx import TABLE_SIZE
    from rna_render.materials.ggx_albedo import ALBEDO_MEANS, ALBEDO_TABLE
    from rna_render.materials.ground_plane import ground
    from rna_render.materials.material import Material, make_material
    from rna_render.materials.mesh_object import MeshObject
    from rna_render.materials.scattering import Scattering
    from rna_render.materials.textures import IDENTITY, SRGB, Texture, read_alpha, read_texels
    from rna_render.materials.transmission import main_texture, transmitted_by

__all__ = [
    "ALBEDO_MEANS",
    "ALBEDO_TABLE",
    "IDENTITY",
    "SRGB",
    "TABLE_SIZE",
    "Material",
    "MeshFileWarning",
    "MeshObject",
    "Scattering",
    "Texture",
    "ground",
    "main_texture",
    "make_material",
    "read_alpha",
    "read_mesh_object",
    "read_texels",
    "transmitted_by",
]

__getattr__, __dir__ = lazy_face(__name__)
