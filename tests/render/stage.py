"""Small scenes of given assets, and their images."""

import numpy as np

from rna_render.paths.bands import render
from rna_render.paths.integrator_factory import make_integrator
from rna_render.scene.scene_model import Scene
from rna_render.scene.transforms import world_from_object
from rna_render.world.placements import Placement
from rna_render.world.world import World

WHITE = (1.0, 1.0, 1.0)
SUN = {"type": "directional", "direction": (0, 1, 0), "irradiance": WHITE}
SKY = {"type": "environment", "radiance": WHITE}


ABOVE = {"position": (0, 4, 0), "look_at": (0, 0, 0), "up": (0, 0, -1), "vertical_fov_deg": 20}
LOW = {"position": (0, 0.4, 4), "look_at": (0, 0, 0), "vertical_fov_deg": 2}


def stage(assets, lights, **changes) -> tuple[Scene, World]:
    """A small scene; `assets` are (asset, transform) pairs."""
    scene = Scene.model_validate(
        {
            "assets": [{"path": "-", "transform": transform} for _, transform in assets],
            "camera": ABOVE,
            "lights": lights,
            "resolution": (16, 12),
            "samples": 4,
            "clamp_indirect": None,
        }
        | changes
    )
    pairs = zip(assets, scene.assets, strict=True)
    return scene, World([Placement(a, world_from_object(m.transform)) for (a, _), m in pairs])


def image(assets, lights, **changes) -> dict[str, np.ndarray]:
    """Channels of its image."""
    scene, world = stage(assets, lights, **changes)
    return render(scene, make_integrator(scene, world)).channels()


def rgb(channels) -> np.ndarray:
    return np.stack([channels[c] for c in "RGB"], axis=-1)
