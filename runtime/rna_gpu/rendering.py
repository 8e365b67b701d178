"""`rna-run --device gpu`: a scene on the GPU, from its world to a film."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence

from rna_gpu.asset import GpuAsset, GpuPart
from rna_gpu.device import Device, open_device
from rna_gpu.errors import DeviceLostError
from rna_gpu.loading import load
from rna_gpu.scene_support import check_scene
from rna_gpu.scene_tables import scene_tables
from rna_gpu.wavefront import Wavefront
from rna_render.film import Film, Layers
from rna_render.indirect_clamp import indirect_clamp
from rna_render.lights import AssetLight
from rna_render.materials import MeshObject
from rna_render.render import all_lights
from rna_render.scene_file import SceneFile
from rna_render.world import World

LOSSES = 3
"""So many lost devices are replaced; the sample under way begins again."""


def render_scene(
    scene_file: SceneFile,
    world: World,
    stop: Callable[[], bool],
    progress: Callable[[int], None],
    on_first_hits: Callable[[], None],
    open_it: Callable[[], Device] = open_device,
) -> Film:
    """The scene's image, or fewer samples of it if `stop` says so: rna_render.devices.Renderer.

    open_it: opens the device, and another one where it is lost.

    Raises:
        GpuError: there is no GPU, the scene does not fit on it or holds what is not supported.
        DeviceLostError: it was lost more than LOSSES times.
    """
    check_scene(scene_file, world)
    gpu = _on_gpu(scene_file, world, open_it())
    film = Film(scene_file.scene.resolution, gpu.groups)
    report = _Report(progress, on_first_hits)
    losses = 0
    while film.samples < scene_file.scene.samples and not stop():
        try:
            sample = _sample(gpu, film, stop, report)
        except DeviceLostError as error:
            losses += 1
            if losses > LOSSES:
                raise
            print(f"{error}; going on with sample {film.samples + 1}", file=sys.stderr)
            gpu = _on_gpu(scene_file, world, open_it())
            continue
        if sample is not None:
            film.add(sample)
    return film


class _Report:
    """Tells of the first hits, once, and of progress."""

    def __init__(self, progress: Callable[[int], None], on_first_hits: Callable[[], None]) -> None:
        self._progress, self._on_first_hits, self._told = progress, on_first_hits, False

    def __call__(self, pixels: int) -> None:
        if not self._told:
            self._told = True
            self._on_first_hits()
        self._progress(pixels)


def _sample(
    gpu: Wavefront, film: Film, stop: Callable[[], bool], progress: Callable[[int], None]
) -> Layers | None:
    """One sample of every pixel; None if it was stopped."""
    pixels, bands = film.width * film.height, []
    for first in range(0, pixels, gpu.band):
        count = min(gpu.band, pixels - first)
        bands.append(gpu.render(first, count, film.samples))
        progress(count)
        if stop() and first + count < pixels:
            return None
    return Layers.concatenate(bands)


def _on_gpu(scene_file: SceneFile, world: World, device: Device) -> Wavefront:
    scene, every = scene_file.scene, all_lights(scene_file.scene, world, scene_file.resolve)
    clamp = indirect_clamp(scene.clamp_indirect, every, world.radius)
    sampled = [light for light in every if not isinstance(light, AssetLight)]
    lights = sampled if _has_catcher(world) else [light.beside_rays() for light in sampled]
    tables = scene_tables(world, lights)
    parts = _parts(scene_file, world, tables.parts, device)
    return Wavefront(device, scene, tables, parts, lights, world.scatters, clamp)


def _has_catcher(world: World) -> bool:
    """Shadow catchers find light by samples of lights alone, which then have to find all of it."""
    return any(isinstance(x, MeshObject) and x.catches_shadows for x in world.things)


def _parts(
    scene_file: SceneFile, world: World, wanted: Sequence[tuple[int, int]], device: Device
) -> list[GpuPart]:
    loaded: dict[tuple[object, str], GpuPart | GpuAsset] = {}
    result = []
    for place, part in wanted:
        key = scene_file.asset_path(place), world.things[place].tier.name
        if key not in loaded:
            loaded[key] = load(key[0], key[1], device)
        asset = loaded[key]
        result.append(asset.parts[part] if isinstance(asset, GpuAsset) else asset)
    return result
