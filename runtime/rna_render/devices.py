"""What renders a scene: the CPU, or a device that another package offers.

A device is an entry point of the group `rna_render.devices`, by the name that `--device` takes; it
gives a Renderer.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import EntryPoint, entry_points
from typing import Protocol

from rna_render.film import Film
from rna_render.scene_file import SceneFile
from rna_render.world import World
from rna_sdk.errors import SceneError

GROUP = "rna_render.devices"
CPU = "cpu"


class Renderer(Protocol):
    """Renders a scene."""

    def __call__(
        self,
        scene_file: SceneFile,
        world: World,
        stop: Callable[[], bool],
        progress: Callable[[int], None],
        on_first_hits: Callable[[], None],
    ) -> Film:
        """The film of `scene_file.scene.samples` samples, or fewer if `stop` says so.

        world: the scene's things, loaded. progress: told how many pixels of a sample are done.
        Raises RnaError for what the device does not know or have room for.
        """
        ...


def find_renderer(name: str) -> Renderer:
    """The renderer of a device that is not the CPU.

    Raises:
        SceneError: no installed package offers it, or what it needs is not installed.
    """
    offered = {entry.name: entry for entry in entry_points(group=GROUP)}
    if name not in offered:
        known = ", ".join([CPU, *sorted(offered)])
        raise SceneError(f"--device {name}: no such device; there are: {known}")
    return _loaded(offered[name])


def _loaded(entry: EntryPoint) -> Renderer:
    try:
        renderer: Renderer = entry.load()
    except ModuleNotFoundError as error:
        missing = f"{error.name} is not installed; try: pip install 'rna-sdk[{entry.name}]'"
        raise SceneError(f"--device {entry.name}: {missing}") from error
    return renderer
