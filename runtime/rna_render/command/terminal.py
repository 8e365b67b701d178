"""Rendering with a bar of progress, which Ctrl-C ends early."""

from __future__ import annotations

import signal
import sys
from collections import Counter
from collections.abc import Callable, Sequence
from typing import cast

from tqdm import tqdm

from rna_render.command.devices import CPU, open_renderer
from rna_render.image.film import Film
from rna_render.paths.render import render
from rna_render.scene.scene_file import SceneFile
from rna_render.world.domain_watch import warn_of_extrapolation
from rna_render.world.tier_costs import cost_lines, loaded_assets
from rna_render.world.world import World
from rna_sdk.file_kinds import kind_of
from rna_sdk.package import Package
from rna_sdk.runtime import Asset
from rna_sdk.size_note import size_note


class Interrupt:
    """While entered, the first Ctrl-C asks for a stop and the second one ends the program."""

    def __init__(self) -> None:
        self._asked = False

    def requested(self) -> bool:
        return self._asked

    def __enter__(self) -> Interrupt:
        self._previous = signal.signal(signal.SIGINT, self._ask)
        return self

    def __exit__(self, *exception: object) -> None:
        signal.signal(signal.SIGINT, self._previous)

    def _ask(self, number: int, frame: object) -> None:
        if self._asked:
            raise KeyboardInterrupt
        self._asked = True
        print("\nstopping after this band of pixels; Ctrl-C again ends at once", file=sys.stderr)


def tell_size(scene_file: SceneFile) -> None:
    """Print a note where a package that is shown alone looks as if it were in centimetres."""
    if kind_of(scene_file.path) == "package":
        with Package.open(scene_file.path) as package:
            note = size_note(*package.box())
        if note is not None:
            print(f"note: {note}", file=sys.stderr)


def tell_tiers(scene_file: SceneFile, world: World) -> None:
    """Print which tiers the scene's `quality` led to, if it has one."""
    assets = loaded_assets(scene_file, world)
    if scene_file.scene.quality is not None and assets:
        told = _counted(assets)
        if world.indirect:
            told += f"; of indirect radiance: {_counted(cast(list[Asset], world.indirect))}"
        print(f"tiers of {len(assets)} assets: {told}", file=sys.stderr)


def _counted(assets: Sequence[Asset]) -> str:
    names = Counter(asset.tier.name for asset in assets)
    return ", ".join(f"{number} {name}" for name, number in names.most_common())


def tell_costs(scene_file: SceneFile, world: World) -> None:
    """Print the cost per query of each asset's tier on this processor."""
    for line in cost_lines(scene_file, world):
        print(line, file=sys.stderr)


def render_with_bar(
    scene_file: SceneFile,
    world: World,
    stop: Callable[[], bool],
    what: str = "rendering",
    first_band: Callable[[], str] | None = None,
    on_sample: Callable[[Film], None] = lambda film: None,
    device: str = CPU,
) -> Film:
    """Render the scene, or fewer samples of it if `stop` says so.

    what: stands before the bar. first_band: what to print when the first band is finished.
    on_sample: given the film after every sample but the last. device: where; see `devices`.
    """
    scene = scene_file.scene
    total = scene.resolution[0] * scene.resolution[1] * scene.samples
    bar = tqdm(total=total, unit="ray", unit_scale=True, desc=what, leave=False, position=0)

    def advance(pixels: int) -> None:
        if first_band is not None and not bar.n:
            bar.write(first_band(), file=sys.stderr)
        bar.update(pixels)

    with bar:
        renderer = open_renderer(device, scene_file, world)
        film = render(scene, renderer, stop, advance, on_sample)
    warn_of_extrapolation([*world.things, *world.indirect])
    if film.samples < scene.samples and not stop():
        print(f"{what}: time for {film.samples} of {scene.samples} samples", file=sys.stderr)
    return film
