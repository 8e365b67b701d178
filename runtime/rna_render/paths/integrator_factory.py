"""From a scene and its world to their renderer: the CPU, or a device that another package offers.

A device is an entry point of the group `rna_render.devices`, by the name that `--device` takes; it
gives an OpenRenderer.
"""

from collections.abc import Sequence
from importlib.metadata import EntryPoint, entry_points
from typing import Literal, Protocol

import numpy as np

from rna_render.lights import Light, make_light
from rna_render.paths.bands import BandRenderer
from rna_render.paths.integrator import Integrator
from rna_render.scene.light_models import AreaModel
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import CameraModel, Scene
from rna_render.scene.transforms import from_origin
from rna_render.world.camera import Camera
from rna_render.world.world import World
from rna_sdk.commands.console import install_hint
from rna_sdk.errors import SceneError

# Radiance of a path, in units of what a white ball as large as the scene would send on average.
AUTO = 10.0

GROUP = "rna_render.devices"
CPU = "cpu"


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


class OpenRenderer(Protocol):
    """Opens a device for a scene."""

    def __call__(
        self, scene: Scene, world: World, next_camera: CameraModel | None = None
    ) -> BandRenderer:
        """Renderer of a scene with resolved paths, whose objects are in `world`.

        next_camera: of the next frame, for motion vectors; None for the same. Raises RnaError for
        what the device does not know or have room for.
        """
        ...


def check_device(device: str, scene_file: SceneFile) -> None:
    """Raises SceneError, which points at the key, for a scene that is for the CPU alone."""
    if device == CPU:
        return
    for index, asset in enumerate(scene_file.scene.assets):
        if asset.motion is not None:
            message = f"is rendered on the CPU, not with --device {device}"
            raise scene_file.error(("assets", index, "motion"), message)


def open_renderer(
    device: str, scene: Scene, world: World, next_camera: CameraModel | None = None
) -> BandRenderer:
    """Renderer of the scene on a device: "cpu", or one that a package offers; see OpenRenderer.

    Raises:
        SceneError: no installed package offers it, or what it needs is not installed.
        RnaError: the device does not know the scene, or has no room for it.
    """
    if device == CPU:
        return make_integrator(scene, world, next_camera)
    return find_device(device)(scene, world, next_camera)


def find_device(name: str) -> OpenRenderer:
    """Function that opens a device other than the CPU.

    Raises:
        SceneError: no installed package offers it, or what it needs is not installed.
    """
    offered = {entry.name: entry for entry in entry_points(group=GROUP)}
    if name not in offered:
        known = ", ".join([CPU, *sorted(offered)])
        raise SceneError(f"--device {name}: no such device; there are: {known}")
    return _loaded(offered[name])


def _loaded(entry: EntryPoint) -> OpenRenderer:
    try:
        renderer: OpenRenderer = entry.load()
    except ModuleNotFoundError as error:
        missing = f"{error.name} is not installed: {install_hint(entry.name)}"
        raise SceneError(f"--device {entry.name}: {missing}") from error
    return renderer
