"""Public names of `rna_render.materials`."""

from .files.mesh_file import MeshFileWarning as MeshFileWarning
from .files.mesh_file import read_mesh_object as read_mesh_object
from .ggx import TABLE_SIZE as TABLE_SIZE
from .ggx_albedo import ALBEDO_MEANS as ALBEDO_MEANS
from .ggx_albedo import ALBEDO_TABLE as ALBEDO_TABLE
from .ground_plane import ground as ground
from .material import Material as Material
from .material import make_material as make_material
from .mesh_object import MeshObject as MeshObject
from .scattering import Scattering as Scattering
from .textures import IDENTITY as IDENTITY
from .textures import SRGB as SRGB
from .textures import Texture as Texture
from .textures import read_alpha as read_alpha
from .textures import read_texels as read_texels
from .transmission import main_texture as main_texture
from .transmission import transmitted_by as transmitted_by
