"""What the tiers of a scene cost on this processor, and whether another one would be faster."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import cast

from rna_render.scene.scene_file import SceneFile
from rna_render.world.world import World
from rna_sdk.package import Package
from rna_sdk.runtime import Asset, is_no_worse, load

_FASTER = 0.9
"""Largest relative cost of another tier that is worth a note."""


def cost_lines(scene_file: SceneFile, world: World) -> Iterator[str]:
    """A line for each package and tier of the scene. Measures what was not measured before."""
    told = set()
    for index, asset in enumerate(loaded_assets(scene_file, world)):
        path = scene_file.asset_path(index)
        if (path, asset.tier.name) not in told:
            told.add((path, asset.tier.name))
            ns = asset.measured_ns_per_query()
            yield f"{path.name}: {asset.tier.name}, {ns:.0f} ns/query on this CPU" + "".join(
                f"; {name} takes {other:.0f} and is no worse"
                for name, other in _others(path, asset.tier.name).items()
                if other < _FASTER * ns
            )


def loaded_assets(scene_file: SceneFile, world: World) -> list[Asset]:
    """The scene's assets, in its order: the first of the world's things."""
    return cast(list[Asset], world.things[: len(scene_file.scene.assets)])


def _others(path: Path, chosen: str) -> dict[str, float]:
    """ns/query of the package's other tiers that are as accurate."""
    with Package.open(path) as package:
        tiers = package.manifest.tiers
        mine = package.tier(chosen)
    names = [tier.name for tier in tiers if tier is not mine and is_no_worse(tier, mine)]
    return {name: load(path, tier=name, threads=1).measured_ns_per_query() for name in names}
