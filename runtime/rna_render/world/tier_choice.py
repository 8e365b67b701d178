"""Which tier each asset of a scene is rendered with: the cheapest that its size allows.

An asset's size is the height in pixels of the sphere about its package's bounds, the largest of
all views. Assets that no view shows are seen in reflections and by the light that they throw, if at
all, and count as the smallest.
"""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import Scene
from rna_render.scene.transforms import world_from_object
from rna_render.world.camera import Camera
from rna_sdk.errors import QueryError
from rna_sdk.package import Package
from rna_sdk.runtime import choose_tier, expected_error


class Choice(NamedTuple):
    """Tier and proxy of an asset in a scene.

    tier: its name; None: the package's first. pixels: as `rna_sdk.runtime.load` has it, to
    choose a proxy; the same for all sizes that have the same one. None: no proxy. indirect: the
    tier for what the camera does not see directly; None: `tier`.
    """

    tier: str | None
    pixels: float | None = None
    indirect: str | None = None


Tiers = tuple[Choice, ...]
"""For each of a scene's assets the tier's name; None for the package's first."""

# Mean FLIP; the first limit beyond "as accurate as can be".
_FIRST_STEP = 0.01

# The most of an image that is assumed to come from assets by way of other objects: the tier for it
# may have an error so many times as large. See docs/decisions/renderer.md.
INDIRECT_SHARE = 0.25


class TierChoice:
    """The tiers that the assets of a scene may have; a tier that the scene names stays.

    views: the scene as each image will show it; only cameras may differ. Raises SceneError for a
    file that is not there, PackageError for a broken package.
    """

    def __init__(self, scene_file: SceneFile, views: Sequence[Scene]) -> None:
        self._named = [asset.tier for asset in scene_file.scene.assets]
        paths = [asset.path for asset in scene_file.resolved.assets]
        opened = {path: Package.open(path) for path in dict.fromkeys(paths)}
        self._packages = [(path, opened[path]) for path in paths]
        boxes = [_bounds(opened[path]) for path in paths]
        self._pixels = _heights(scene_file.scene, views, boxes).tolist()

    def within(self, max_error: float) -> Tiers:
        """The cheapest tiers of at most this mean FLIP, or where there is none the best."""
        return tuple(self._choice(index, max_error) for index in range(len(self._named)))

    def coarser(self, max_error: float) -> Iterator[Tiers]:
        """This choice, then with twice the error and so on, as long as that changes tiers."""
        last = None
        while max_error < 2.0:  # FLIP is 1 at most
            tiers = self.within(max_error)
            if tiers != last:
                yield tiers
            last, max_error = tiers, max(2.0 * max_error, _FIRST_STEP)

    def unmet(self, max_error: float) -> list[str]:
        """A line for each package that has no tier within the limit at its largest size."""
        worst: dict[Path, int] = {}
        for index, (path, _) in enumerate(self._packages):
            tallest = worst.get(path, index)
            if self._named[index] is None and self._pixels[index] >= self._pixels[tallest]:
                worst[path] = index
        lines = []
        for path, index in worst.items():
            best, error = self._most_accurate(index)
            if not error <= max_error:
                best_tier = (
                    f"{best} with {error:.3g}" if np.isfinite(error) else f"{best}, unmeasured"
                )
                lines.append(
                    f"{path.name}: no tier has an error of at most {max_error:g} at "
                    f"{self._pixels[index]:.0f} pixels; the best is taken, {best_tier}"
                )
        return lines

    def _choice(self, index: int, max_error: float) -> Choice:
        named, pixels = self._named[index], self._proxy(index)
        if named is not None:
            return Choice(named, pixels)
        tier = self._best_within(index, max_error)
        indirect = self._best_within(index, max_error / INDIRECT_SHARE)
        return Choice(tier, pixels, None if indirect == tier else indirect)

    def _proxy(self, index: int) -> float | None:
        """The least height of the package's proxies that the asset does not exceed."""
        package = self._packages[index][1]
        parts = range(len(package.manifest.parts))
        heights = [height for part in parts for height in package.proxy_heights(part)]
        fitting = [height for height in heights if self._pixels[index] <= height]
        return min(fitting, default=None)

    def _best_within(self, index: int, max_error: float) -> str:
        try:
            package = self._packages[index][1]
            return choose_tier(package, max_error=max_error, pixels=self._pixels[index]).name
        except QueryError:
            return self._most_accurate(index)[0]

    def _most_accurate(self, index: int) -> tuple[str, float]:
        tiers, pixels = self._packages[index][1].manifest.tiers, self._pixels[index]
        best = min(tiers, key=lambda tier: expected_error(tier, pixels))
        return best.name, expected_error(best, pixels)


def _bounds(package: Package) -> np.ndarray:
    """(2, 3): lower and upper corner of the box around the bounds of all parts."""
    corners = np.array([(part.bounds.min, part.bounds.max) for part in package.manifest.parts])
    return np.stack([corners[:, 0].min(axis=0), corners[:, 1].max(axis=0)])


def _heights(scene: Scene, views: Sequence[Scene], boxes: Sequence[np.ndarray]) -> np.ndarray:
    """The largest height in any view of each asset's bounds, (n,) pixels."""
    if not boxes:
        return np.zeros(0)
    corners = np.array(boxes)
    matrices = np.array([world_from_object(asset.transform) for asset in scene.assets])
    scale = np.linalg.norm(matrices[:, :3, 0], axis=1)
    radius = scale * np.linalg.norm(corners[:, 1] - corners[:, 0], axis=1) / 2.0
    middle = corners.mean(axis=1)
    centre = np.einsum("nij,nj->ni", matrices[:, :3, :3], middle) + matrices[:, :3, 3]
    cameras = (Camera(view.camera, view.resolution) for view in views)
    return np.asarray(np.max([camera.heights(centre, radius) for camera in cameras], axis=0))
