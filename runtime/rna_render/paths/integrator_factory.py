"""From a scene and its world to what renders it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from rna_render.lights import Light, make_light
from rna_render.paths.integrator import Integrator
from rna_render.scene.light_models import AreaModel
from rna_render.scene.scene_model import CameraModel, Scene
from rna_render.scene.transforms import from_origin
from rna_render.world.camera import Camera
from rna_render.world.world import World

# Radiance of a path, in units of what a white ball as large as the scene would send on average.
AUTO = 10.0


def make_integrator(
    scene: Scene, world: World, next_camera: CameraModel | None = None
) -> Integrator:
    """Integrator of `scene`, with resolved paths, whose objects are in `world`.

    next_camera: of the next frame, for motion vectors; None for the same.
    Raises SceneError for an environment's image that cannot be used.
    """
    lights = all_lights(scene, world)
    camera = Camera(from_origin(scene.camera, world.origin), scene.resolution, scene.samples)
    after = None
    if next_camera is not None and next_camera != scene.camera:
        after = Camera(from_origin(next_camera, world.origin), scene.resolution)
    clamp = indirect_clamp(scene.clamp_indirect, lights, world.radius)
    return Integrator(
        world,
        camera,
        lights,
        max_depth=scene.max_depth,
        clamp=clamp,
        next_camera=after,
    )


def all_lights(scene: Scene, world: World) -> list[Light]:
    """Lights of the world, then those without a shape; errors: see `make_integrator`."""
    without_shape = [model for model in scene.lights if not isinstance(model, AreaModel)]
    places = (from_origin(model, world.origin) for model in without_shape)
    return [*world.lights, *map(make_light, places)]


def indirect_clamp(
    setting: float | Literal["auto"] | None, lights: Sequence[Light], scene_radius: float
) -> float | None:
    """Clamp on per-path indirect radiance; None for no clamp.

    Light that reaches a diffuse surface via an asset's highlight is sampled by chance alone:
    rarely, and then much of it at once, as specks.

    setting: by the scene file; "auto" for AUTO times the mean radiance of a white ball as large as
    the scene, which follows from the lights' power.
    """
    if setting != "auto":
        return setting
    power = sum(light.power(scene_radius) for light in lights)
    ball = 4.0 * np.pi**2 * scene_radius**2
    if not (ball > 0.0 and power > 0.0 and np.isfinite(power / ball)):
        return None
    return AUTO * power / ball
