"""From a scene file to a finished film."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from rna_render.bodies import Asset
from rna_render.camera import Camera
from rna_render.film import Film, Layers
from rna_render.integrator import Integrator
from rna_render.lights import make_light
from rna_render.sampling import Sampler
from rna_render.scene_file import SceneFile
from rna_render.scene_model import EnvironmentModel, Scene
from rna_render.transforms import world_from_object
from rna_render.world import Placement, World
from rna_sdk.errors import QueryError

# Rays traced together: enough to fill all threads, few enough that a stop is noticed soon.
BAND = 1 << 16


def load_world(scene_file: SceneFile, threads: int | None = None) -> World:
    """The scene's assets, loaded and placed; each pair of package and tier is loaded once.

    threads: for the neural runtime; all if None. Raises SceneError where the file names a
    package or a tier that is not there, PackageError for a package that is broken.
    """
    from rna_sdk.runtime import load

    loaded: dict[tuple[Path, str | None], Asset] = {}
    placements = []
    for index, model in enumerate(scene_file.scene.assets):
        path = scene_file.resolve(model.path)
        if not path.is_file():
            raise scene_file.error(("assets", index, "path"), f"no such file: {path}")
        if (path, model.tier) not in loaded:
            try:
                loaded[path, model.tier] = load(path, tier=model.tier, threads=threads)
            except QueryError as error:
                raise scene_file.error(("assets", index, "tier"), str(error)) from error
        placements.append(Placement(loaded[path, model.tier], world_from_object(model.transform)))
    return World(placements)


def make_integrator(
    scene: Scene, world: World, on_first_hits: Callable[[], None] = lambda: None
) -> Integrator:
    """What renders `scene`, once its assets are in `world`."""
    shown = [
        light.radiance
        for light in scene.lights
        if isinstance(light, EnvironmentModel) and light.visible_to_camera
    ]
    background = np.sum(shown, axis=0) if shown else None
    lights = [make_light(light) for light in scene.lights]
    camera = Camera(scene.camera, scene.resolution)
    return Integrator(world, camera, lights, background, on_first_hits)


def render(
    scene: Scene,
    integrator: Integrator,
    stop: Callable[[], bool] = lambda: False,
    progress: Callable[[int], None] = lambda pixels: None,
) -> Film:
    """Render `scene.samples` samples of every pixel, or fewer if `stop` says so.

    stop: asked after every band; the sample under way is then dropped. progress: told after
    every band how many pixels it had.
    """
    film = Film(scene.resolution)
    pixels = np.arange(film.width * film.height, dtype=np.uint32)
    bands = [pixels[start : start + BAND] for start in range(0, len(pixels), BAND)]
    for number in range(scene.samples):
        sampler, finished = Sampler(scene.seed, number), []
        for band in bands:
            finished.append(integrator.render(band, sampler))
            progress(len(band))
            if stop():
                break
        if len(finished) == len(bands):
            film.add(Layers.concatenate(finished))
        if stop():
            break
    return film
