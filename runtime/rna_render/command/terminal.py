"""Rendering with a progress bar, which Ctrl-C ends early; printed lines about a scene."""

import signal
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from rna_render.image.film import Film
from rna_render.paths.bands import BandRenderer, render
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import QualityModel, Scene
from rna_render.world.domain_watch import warn_of_extrapolation
from rna_render.world.world import World
from rna_sdk.commands.size_note import size_note
from rna_sdk.files.file_kinds import kind_of
from rna_sdk.package import Package
from rna_sdk.runtime import Asset, is_no_worse, load
from rna_work.bar import Bar

_FASTER = 0.9
"""Largest relative cost of another tier that is worth a note."""


_SEEN = 1e-3
"""Smallest share of the light that is told when a clamp takes it."""


class Interrupt:
    """While entered, the first Ctrl-C requests a stop and the second one ends the program."""

    def __init__(self) -> None:
        self._stop_requested = False

    def requested(self) -> bool:
        return self._stop_requested

    def __enter__(self) -> "Interrupt":
        self._previous = signal.signal(signal.SIGINT, self._ask)
        return self

    def __exit__(self, *exception: object) -> None:
        signal.signal(signal.SIGINT, self._previous)

    def _ask(self, number: int, frame: object) -> None:
        if self._stop_requested:
            raise KeyboardInterrupt
        self._stop_requested = True
        print("\nstopping after this band of pixels; Ctrl-C again ends at once", file=sys.stderr)


def tell_size(scene_file: SceneFile) -> None:
    """Print a note where a package that is shown alone may be in centimetres."""
    path = scene_file.path
    if kind_of(path) == "package":
        with Package.open(path) as package:
            note = size_note(*package.box())
        if note is not None:
            print(f"note: {note}", file=sys.stderr)


def tell_tiers(quality: QualityModel | None, world: World) -> None:
    """Print which tiers the scene's `quality` led to, if it has one."""
    assets = world.assets
    if quality is not None and assets:
        tiers = _counted(assets)
        if world.indirect:
            tiers += f"; of indirect radiance: {_counted(world.indirect)}"
        print(f"tiers of {len(assets)} assets: {tiers}", file=sys.stderr)


def tell_clamp(scene: Scene, film: Film) -> None:
    """Print how much light the clamp on indirect radiance took, if that can be seen."""
    share = film.clamped_share
    if share > _SEEN:
        print(
            f"clamp_indirect: {scene.clamp_indirect} took {share:.2%} of the image's light; null "
            "keeps it, with its noise",
            file=sys.stderr,
        )


def _counted(assets: Sequence[Asset]) -> str:
    names = Counter(asset.tier.name for asset in assets)
    return ", ".join(f"{number} {name}" for name, number in names.most_common())


def render_with_bar(
    scene: Scene,
    renderer: BandRenderer,
    world: World,
    stop: Callable[[], bool],
    what: str = "rendering",
    first_band: Callable[[], str] | None = None,
    on_sample: Callable[[Film], None] = lambda film: None,
) -> Film:
    """Render the scene, whose objects are in `world`, or fewer samples of it if `stop` says so.

    what: stands before the bar. first_band: what to print when the first band is finished.
    on_sample: given the film after every sample but the last.
    """
    total = scene.resolution[0] * scene.resolution[1] * scene.samples
    bar = Bar(total=total, unit="ray", unit_scale=True, desc=what, leave=False, position=0)

    def advance(pixels: int) -> None:
        if first_band is not None and not bar.n:
            bar.write(first_band(), file=sys.stderr)
        bar.update(pixels)

    with bar:
        film = render(scene, renderer, stop, advance, on_sample)
    warn_of_extrapolation([*world.objects, *world.indirect])
    if film.samples < scene.samples and not stop():
        print(f"{what}: time for {film.samples} of {scene.samples} samples", file=sys.stderr)
    return film


class Interim:
    """Hands a film on after a sample, if enough time has passed since it did so last.

    seconds: from the end of one writing to the next, the first being after the first sample; None
    for no writing. write: is given the film.
    """

    def __init__(self, seconds: float | None, write: Callable[[Film], None]) -> None:
        self._seconds, self._write = seconds, write
        self._next = 0.0

    def __call__(self, film: Film) -> None:
        if self._seconds is not None and time.monotonic() >= self._next:
            self._write(film)
            self._next = time.monotonic() + self._seconds


def cost_lines(paths: Sequence[Path], world: World) -> Iterator[str]:
    """A line for each package and tier of the scene: the cost of a query on this processor.

    paths: of the world's assets. Measures what was not measured before.
    """
    reported = set()
    for path, asset in zip(paths, world.assets, strict=True):
        if (path, asset.tier.name) not in reported:
            reported.add((path, asset.tier.name))
            ns = asset.measured_ns_per_query()
            yield f"{path.name}: {asset.tier.name}, {ns:.0f} ns/query on this CPU" + "".join(
                f"; {name} takes {other:.0f} and is no worse"
                for name, other in _others(path, asset.tier.name).items()
                if other < _FASTER * ns
            )


def _others(path: Path, chosen: str) -> dict[str, float]:
    """ns/query of the package's other tiers that are as accurate."""
    with Package.open(path) as package:
        tiers = package.manifest.tiers
        mine = package.tier(chosen)
    names = [tier.name for tier in tiers if tier is not mine and is_no_worse(tier, mine)]
    return {name: load(path, tier=name, threads=1).measured_ns_per_query() for name in names}
