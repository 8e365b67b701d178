"""The world of a scene file, with the tiers that the scene's `quality` requires."""

import math
import warnings
from collections.abc import Callable, Sequence
from functools import partial

from rna_render.paths.bands import BandRenderer
from rna_render.paths.integrator_factory import make_integrator
from rna_render.paths.time_limit import ENOUGH_SAMPLES, seconds_a_sample
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import Scene
from rna_render.world.scene_sources import check_files
from rna_render.world.tier_choice import Choice, TierChoice
from rna_render.world.world import World
from rna_render.world.world_loading import Loaded, placed_world


class QualityWarning(UserWarning):
    """A scene requires more accuracy than its packages have."""


def load_world(
    scene_file: SceneFile,
    views: Sequence[Scene] = (),
    open_renderer: Callable[[World], BandRenderer] | None = None,
    loaded: Loaded | None = None,
) -> World:
    """The scene's objects, loaded and placed: assets, objects, the ground, lights with a shape.

    Each package is loaded once a tier and proxy, and each object file once a material. Tiers and
    proxies are those that `quality` asks for.

    views: the images to come, where their cameras differ from the scene's. open_renderer: of what
    `quality.seconds` is measured with; None for the CPU. loaded: keeps what was loaded, and the
    tiers, for `placed_world` of other frames. Raises SceneError where the file names
    something that is not there or cannot be used, PackageError for a broken package. Warns with
    QualityWarning where no tier is accurate enough.
    """
    quality, loaded = scene_file.scene.quality, loaded or Loaded()
    check_files(scene_file)
    if quality is None:
        tiers = tuple(Choice(asset.tier) for asset in scene_file.scene.assets)
        return placed_world(scene_file, tiers, loaded)
    choice = TierChoice(scene_file, views or (scene_file.scene,))
    if quality.max_error is not None:
        for line in choice.unmet(quality.max_error):
            warnings.warn(line, QualityWarning, stacklevel=2)
    max_error = quality.max_error or 0.0
    if quality.seconds is None:
        return placed_world(scene_file, choice.within(max_error), loaded)
    # The first of the choices that leaves time for enough samples, or the last.
    scene = scene_file.resolved
    make = open_renderer or partial(make_integrator, scene)
    enough, count = min(ENOUGH_SAMPLES, scene.samples), math.prod(scene.resolution)
    for tiers in choice.coarser(max_error):
        world = placed_world(scene_file, tiers, loaded)
        if enough * seconds_a_sample(make(world), count) <= quality.seconds:
            break
    return world
