"""The reference path tracer for relightable neural assets, and `rna-run`.

What other packages use of it; `rna_render.scene` has what a scene file says.

Examples:
    >>> scene_file = read_scene("scene.yaml")
    >>> scene, world = scene_file.resolved, load_world(scene_file)
    >>> film = render(scene, make_integrator(scene, world))
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rna_sdk.lazy_face import lazy_face

if TYPE_CHECKING:
    from rna_render.image.denoise import Denoiser
    from rna_render.image.film import Layers
    from rna_render.image.images import read_exr, write_exr
    from rna_render.image.view_transform import encode_srgb, to_display
    from rna_render.lights.files.environment_file import read_environment
    from rna_render.materials.files.mesh_file import read_mesh_object
    from rna_render.materials.ground_plane import ground
    from rna_render.materials.mesh_object import MeshObject
    from rna_render.motion.asset_motion import open_asset_motion
    from rna_render.paths.integrator import Integrator
    from rna_render.paths.integrator_factory import make_integrator
    from rna_render.paths.render import render
    from rna_render.paths.sampling import Sampler
    from rna_render.paths.world_in_time import load_world
    from rna_render.world.camera import Camera
    from rna_render.world.placements import place_asset, placed_box
    from rna_render.world.world import World

__all__ = [
    "Camera",
    "Denoiser",
    "Integrator",
    "Layers",
    "MeshObject",
    "Sampler",
    "World",
    "encode_srgb",
    "ground",
    "load_world",
    "make_integrator",
    "open_asset_motion",
    "place_asset",
    "placed_box",
    "read_environment",
    "read_exr",
    "read_mesh_object",
    "render",
    "to_display",
    "write_exr",
]

__getattr__, __dir__ = lazy_face(__name__)
