"""Public names of `rna_render`."""

from .image.denoise import Denoiser as Denoiser
from .image.film import Layers as Layers
from .image.images import read_exr as read_exr
from .image.images import write_exr as write_exr
from .image.view_transform import encode_srgb as encode_srgb
from .image.view_transform import to_display as to_display
from .lights.files.environment_file import read_environment as read_environment
from .materials.files.mesh_file import read_mesh_object as read_mesh_object
from .materials.ground_plane import ground as ground
from .materials.mesh_object import MeshObject as MeshObject
from .motion.asset_motion import open_asset_motion as open_asset_motion
from .paths.bands import render as render
from .paths.direct_light import DirectLight as DirectLight
from .paths.integrator import Integrator as Integrator
from .paths.integrator_factory import make_integrator as make_integrator
from .paths.sampling import Sampler as Sampler
from .paths.world_in_time import load_world as load_world
from .world.camera import Camera as Camera
from .world.placements import place_asset as place_asset
from .world.world import World as World
