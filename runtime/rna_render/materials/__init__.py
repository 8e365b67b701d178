"""Meshes that are not neural, and what they are made of.

The models of the scene file are in `rna_render.materials.models`.
"""

from rna_render.materials.ground import ground
from rna_render.materials.material import Material, make_material
from rna_render.materials.mesh_file import MeshFileWarning, read_mesh_object
from rna_render.materials.mesh_object import MeshObject
from rna_render.materials.scattering import Scattering
from rna_render.materials.textures import Texture

__all__ = [
    "Material",
    "MeshFileWarning",
    "MeshObject",
    "Scattering",
    "Texture",
    "ground",
    "make_material",
    "read_mesh_object",
]
