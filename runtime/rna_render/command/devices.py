"""What renders a scene: the CPU, or a device that another package offers.

A device is an entry point of the group `rna_render.devices`, by the name that `--device` takes; it
gives an OpenRenderer.
"""

from __future__ import annotations

from importlib.metadata import EntryPoint, entry_points
from typing import Protocol

from rna_render.paths.bands import BandRenderer
from rna_render.paths.integrator_factory import make_integrator
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import CameraModel, Scene
from rna_render.world.world import World
from rna_sdk.commands.console import install_hint
from rna_sdk.errors import SceneError

GROUP = "rna_render.devices"
CPU = "cpu"


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
