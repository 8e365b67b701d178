"""From a scene and its world to what renders it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from rna_render.lights import Light, make_light
from rna_render.paths.camera import Camera
from rna_render.paths.indirect_clamp import indirect_clamp
from rna_render.paths.integrator import BRANCHES, Integrator
from rna_render.scene.light_models import AreaModel
from rna_render.scene.scene_model import Scene
from rna_render.world.world import World


def make_integrator(
    scene: Scene,
    world: World,
    on_first_hits: Callable[[], None] = lambda: None,
    resolve: Callable[[Path], Path] = Path,
    branches: int = BRANCHES,
) -> Integrator:
    """Integrator of `scene`, whose things are in `world`.

    resolve: finds files that the scene names. branches: as of Integrator. Raises
    SceneError for an environment's image that cannot be used.
    """
    lights = all_lights(scene, world, resolve)
    camera = Camera(scene.camera, scene.resolution)
    clamp = indirect_clamp(scene.clamp_indirect, lights, world.radius)
    return Integrator(
        world, camera, lights, scene.max_depth, clamp, on_first_hits, branches=branches
    )


def all_lights(scene: Scene, world: World, resolve: Callable[[Path], Path] = Path) -> list[Light]:
    """Lights of the world, then those without a shape; errors as of `make_integrator`."""
    without_shape = [model for model in scene.lights if not isinstance(model, AreaModel)]
    return [*world.lights, *(make_light(model, resolve) for model in without_shape)]
