"""`rna-run --device gpu`: the renderer of bands of a scene on the GPU."""

import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from threading import Lock
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from rna_gpu.asset import GpuAsset, GpuFiber, GpuPart, GpuSurface
from rna_gpu.device import Device, open_device
from rna_gpu.loading import load
from rna_gpu.scene.scene_tables import asset_at, scene_tables
from rna_gpu.scene.wavefront import Wavefront
from rna_render import Camera, Layers, Sampler, World
from rna_render.paths.integrator_factory import all_lights, indirect_clamp
from rna_render.scene import CameraModel, Scene, from_origin
from rna_render.world.domain_watch import WatchedAsset
from rna_sdk.errors import DeviceLostError

LOSSES = 3
"""So many lost devices of a scene are replaced; the band under way is rendered again."""

_MOST_SAMPLES = 16
"""Samples at once: reading them costs what reading one does, and their sums in float32 are exact
enough. Software drivers take one: there reading costs little, and a stop waits for the band."""


class GpuRenderer:
    """Renders a scene: rna_render.paths.bands.BandRenderer.

    Attributes:
        groups: names of the groups of lights.
        at_once: 1, since a GPU does one thing after the other.
        band: pixels that it renders at once.
    """

    at_once = 1

    def __init__(
        self,
        scene: Scene,
        world: World,
        next_camera: CameraModel | None = None,
        open_it: Callable[[], Device] | None = None,
    ) -> None:
        """scene: with resolved paths. next_camera: of the next frame; None for the same. open_it:
        opens the device, and another one where it is lost; None for the fastest.

        Raises:
            GpuError: there is no GPU, or the scene does not fit on it.
        """
        camera = from_origin(scene.camera, world.origin)
        self._scene, self._world = scene.model_copy(update={"camera": camera}), world
        models = camera, from_origin(next_camera or scene.camera, world.origin)
        moves = models[0] != models[1]
        self._cameras = [Camera(model, scene.resolution) for model in models if moves]
        self._open = open_it or _DEVICE.get
        self._lock, self._losses = Lock(), 0
        self._start()
        self.groups, self.band = self._gpu.groups, self._gpu.band

    @property
    def samples(self) -> int:
        """Largest number of samples of a pixel that are rendered at once."""
        one = self._cameras or self._gpu.is_software  # a motion is of one sample
        return 1 if one else _MOST_SAMPLES

    def render(self, pixels: NDArray[np.uint32], sampler: Sampler) -> Layers:
        """The sum of `sampler.count` samples of the given pixels, (n,).

        Raises:
            DeviceLostError: the device was lost more than LOSSES times.
        """
        with self._lock:
            starts = range(0, len(pixels), self._gpu.band)
            bands = [self._rendered(pixels[k : k + starts.step], sampler) for k in starts]
        layers = Layers.concatenate(bands)
        if self._cameras:
            now, after = self._cameras
            row = np.flatnonzero(layers.hit)
            at = layers.position_world[row]
            layers.motion[row] = now.motion_to(after, at, at)
        from_file = layers.hit[:, None] * self._world.origin
        layers.position_world = (layers.position_world + from_file).astype(np.float32)
        return layers

    def _rendered(self, pixels: NDArray[np.uint32], sampler: Sampler) -> Layers:
        while True:
            try:
                samples = range(sampler.sample, sampler.sample + sampler.count)
                layers = self._gpu.render(pixels, samples)
                if self._watched:
                    counts = self._gpu.outside_domains()
                    for k, scene_object in self._watched.items():
                        scene_object.add(*counts[k].tolist())
                return layers
            except DeviceLostError as error:
                self._losses += 1
                if self._losses > LOSSES:
                    raise
                print(f"{error}; going on with sample {sampler.sample + 1}", file=sys.stderr)
                _DEVICE.forget()
                self._start()

    def _start(self) -> None:
        scene, world = self._scene, self._world
        every = all_lights(scene, world)
        clamp = indirect_clamp(scene.clamp_indirect, every, world.radius)
        # Shadow catchers find light by samples of lights alone, which have to find all of it.
        catches = world.catches_shadows.any()
        lights = every if catches else [light.mis_compensated() for light in every]
        tables, device = scene_tables(world, lights), self._open()
        parts = _parts(scene, world, tables.parts, device)
        self._gpu = Wavefront(device, scene, tables, parts, lights, world.scatters, clamp)
        scene_objects = [world.objects[place] for place, _ in tables.parts]
        self._watched = {
            k: scene_object
            for k, scene_object in enumerate(scene_objects)
            if isinstance(scene_object, WatchedAsset)
        }


class _OpenDevice:
    """The fastest device, opened once, so that images of one process share compiled shaders."""

    def __init__(self) -> None:
        self._device: Device | None = None

    def get(self) -> Device:
        self._device = self._device or open_device()
        return self._device

    def forget(self) -> None:
        """Drops a lost device."""
        self._device = None


_DEVICE = _OpenDevice()

_Loaded = dict[tuple[Path, str], GpuSurface | GpuFiber | GpuAsset]
_LOADED: WeakKeyDictionary[World, tuple[Device, _Loaded]] = WeakKeyDictionary()
"""The assets of worlds of which several images are rendered."""


def _parts(
    scene: Scene, world: World, wanted: Sequence[tuple[int, int]], device: Device
) -> list[GpuPart]:
    loaded_device, loaded = _LOADED.get(world, (device, {}))
    if loaded_device is not device:
        loaded = {}
    result: list[GpuPart] = []
    for place, part in wanted:
        key = scene.assets[place].path, asset_at(world, place).tier.name
        if key not in loaded:
            loaded[key] = load(key[0], key[1], device)
        asset = loaded[key]
        result.append(asset.parts[part] if isinstance(asset, GpuAsset) else asset)
    _LOADED[world] = device, loaded
    return result
