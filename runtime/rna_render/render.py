"""From a scene file to a finished film."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import closing
from pathlib import Path

import numpy as np

from rna_render.asset_parts import Asset
from rna_render.bands import BandRenderer, rendered_bands
from rna_render.camera import Camera
from rna_render.domain_watch import watched
from rna_render.film import Film, Layers
from rna_render.indirect_clamp import indirect_clamp
from rna_render.integrator import Integrator
from rna_render.lights import (
    AssetEmission,
    AssetLight,
    Light,
    MeshLight,
    PlacedLight,
    make_light,
)
from rna_render.lights.models import AreaModel
from rna_render.materials import MeshObject, ground, read_mesh_object
from rna_render.sampling import Sampler
from rna_render.scene_file import SceneFile
from rna_render.scene_model import Scene
from rna_render.tier_choice import Choice, TierChoice, Tiers
from rna_render.time_limit import ENOUGH_SAMPLES, in_time, seconds_a_sample
from rna_render.transforms import world_from_object
from rna_render.world import Placement, World
from rna_sdk.errors import QueryError, SceneError


class QualityWarning(UserWarning):
    """A scene asks for more accuracy than its packages have."""


def load_world(
    scene_file: SceneFile,
    views: Sequence[Scene] = (),
    open_renderer: Callable[[SceneFile, World], BandRenderer] | None = None,
) -> World:
    """The scene's things, loaded and placed: assets, objects, the ground, lights with a shape.

    Each package is loaded once a tier and proxy, and each object file once a material. Tiers and
    proxies are those that `quality` asks for.

    views: the images to come, where their cameras differ from the scene's. open_renderer: of what
    `quality.seconds` is measured with; None for the CPU. Raises SceneError where the file names
    something that is not there or cannot be used, PackageError for a broken package. Warns with
    QualityWarning where no tier is accurate enough.
    """
    quality = scene_file.scene.quality
    if quality is None:
        return _world(scene_file, tuple(Choice(asset.tier) for asset in scene_file.scene.assets))
    choice = TierChoice(scene_file, views or (scene_file.scene,))
    if quality.max_error is not None:
        for line in choice.unmet(quality.max_error):
            warnings.warn(line, QualityWarning, stacklevel=2)
    max_error = quality.max_error or 0.0
    if quality.seconds is None:
        return _world(scene_file, choice.within(max_error))
    make = open_renderer or _integrator_of
    return _world_in_time(scene_file, choice.coarser(max_error), quality.seconds, make)


def _integrator_of(scene_file: SceneFile, world: World) -> Integrator:
    return make_integrator(scene_file.scene, world, resolve=scene_file.resolve)


def _world_in_time(
    scene_file: SceneFile,
    choices: Iterable[Tiers],
    seconds: float,
    make: Callable[[SceneFile, World], BandRenderer],
) -> World:
    """With the first of the choices that leaves time for enough samples, or the last."""
    scene = scene_file.scene
    enough = min(ENOUGH_SAMPLES, scene.samples)
    for tiers in choices:
        world = _world(scene_file, tiers)
        if (
            enough * seconds_a_sample(make(scene_file, world), math.prod(scene.resolution))
            <= seconds
        ):
            break
    return world


def _world(scene_file: SceneFile, tiers: Tiers) -> World:
    return World(
        [
            *_placed_assets(scene_file, tiers),
            *_placed_objects(scene_file),
            *_placed_ground(scene_file),
            *_placed_lights(scene_file),
        ]
    )


def make_integrator(
    scene: Scene,
    world: World,
    on_first_hits: Callable[[], None] = lambda: None,
    resolve: Callable[[Path], Path] = Path,
) -> Integrator:
    """What renders `scene`, once its things are in `world`.

    resolve: finds files that the scene names. Raises SceneError for an environment's image that
    cannot be used.
    """
    lights = all_lights(scene, world, resolve)
    camera = Camera(scene.camera, scene.resolution)
    clamp = indirect_clamp(scene.clamp_indirect, lights, world.radius)
    return Integrator(world, camera, lights, scene.max_depth, clamp, on_first_hits)


def all_lights(scene: Scene, world: World, resolve: Callable[[Path], Path] = Path) -> list[Light]:
    """Those of the world, then those without a shape; errors as of `make_integrator`."""
    without_shape = [model for model in scene.lights if not isinstance(model, AreaModel)]
    return [*world.lights, *(make_light(model, resolve) for model in without_shape)]


def render(
    scene: Scene,
    renderer: BandRenderer,
    stop: Callable[[], bool] = lambda: False,
    progress: Callable[[int], None] = lambda pixels: None,
    on_sample: Callable[[Film], None] = lambda film: None,
) -> Film:
    """Render `scene.samples` samples of every pixel, or fewer if `stop` or `quality` says so.

    stop: asked after every band; the sample under way is then dropped. progress: told after every
    band how many pixels it had. on_sample: given the film after every sample but the last.
    """
    film = Film(scene.resolution, renderer.groups)
    samplers: Iterator[Sampler] = (Sampler(scene.seed, number) for number in range(scene.samples))
    if scene.quality is not None and scene.quality.seconds is not None:
        samplers = in_time(samplers, scene.quality.seconds, lambda: film.samples)
    sample: list[Layers] = []
    with closing(rendered_bands(renderer, film.width * film.height, samplers)) as bands:
        for band, last in bands:
            sample.append(band)
            progress(len(band.hit))
            if last:
                film.add(Layers.concatenate(sample))
                sample.clear()
                if film.samples < scene.samples:
                    on_sample(film)
            if stop():
                break
    return film


def _placed_assets(scene_file: SceneFile, tiers: Tiers) -> list[Placement]:
    from rna_sdk.runtime import load

    loaded: dict[tuple[Path, Choice], Asset] = {}
    emissions: dict[tuple[Path, Choice], AssetEmission | None] = {}
    placements = []
    for index, (model, chosen) in enumerate(zip(scene_file.scene.assets, tiers, strict=True)):
        path = scene_file.asset_path(index)
        if (path, chosen) not in loaded:
            try:
                asset = load(path, tier=chosen.tier, threads=1, pixels=chosen.pixels)
                loaded[path, chosen] = watched(asset, path.name)
            except QueryError as error:
                raise scene_file.error(("assets", index, "tier"), str(error)) from error
            emissions[path, chosen] = emission_of(loaded[path, chosen])
        at = world_from_object(model.transform), emissions[path, chosen], model.emission
        placements.append(place_asset(loaded[path, chosen], *at))
    return placements


def _placed_objects(scene_file: SceneFile) -> list[Placement]:
    loaded: dict[tuple[Path, str], MeshObject] = {}
    placements = []
    for index, model in enumerate(scene_file.scene.objects):
        path = scene_file.resolve(model.path)
        key = path, repr(model.material)
        if key not in loaded:
            try:
                loaded[key] = read_mesh_object(path, model.material, scene_file.resolve)
            except SceneError as error:
                raise scene_file.error(("objects", index), str(error)) from error
        matrix = world_from_object(model.transform)
        placements.append(Placement(loaded[key], matrix, mesh_light(loaded[key], matrix)))
    return placements


def _placed_ground(scene_file: SceneFile) -> list[Placement]:
    model = scene_file.scene.ground
    if model is None:
        return []
    mesh = ground(model, scene_file.resolve)
    return [Placement(mesh, np.eye(4), mesh_light(mesh, np.eye(4)), boundless=True)]


def _placed_lights(scene_file: SceneFile) -> list[Placement]:
    models = [model for model in scene_file.scene.lights if isinstance(model, AreaModel)]
    lights = [make_light(model, scene_file.resolve) for model in models]
    return [
        Placement(light, light.world_from_object, light, boundless=True)
        for light in lights
        if isinstance(light, PlacedLight)
    ]


def place_asset(
    asset: Asset,
    world_from_object: np.ndarray,
    emission: AssetEmission | None = None,
    factor: float = 1.0,
) -> Placement:
    """An asset, and the light that it sends out.

    world_from_object: (4, 4), a similarity. emission: `emission_of` the asset, for callers that
    place it several times. factor: on what it emits.
    """
    emission = emission or emission_of(asset)
    shines = emission is not None and factor > 0.0
    light = AssetLight(emission, world_from_object, factor) if shines else None
    return Placement(asset, world_from_object, light)


def emission_of(asset: Asset) -> AssetEmission | None:
    """What an asset shines with, if it does."""
    return AssetEmission(asset) if any(part.emits for part in asset.parts) else None


def mesh_light(thing: MeshObject, world_from_object: np.ndarray) -> MeshLight | None:
    """What an object shines with, if it does."""
    if not thing.is_emissive:
        return None
    linear, translation = world_from_object[:3, :3], world_from_object[:3, 3]
    positions = (thing.positions @ linear.T + translation).astype(np.float32)
    emission = thing.emitted_luminance, thing.emission
    opaque = None if thing.transmittance is None else thing.opaque_emission
    return MeshLight(positions, thing.triangles, *emission, opaque_emission=opaque)
