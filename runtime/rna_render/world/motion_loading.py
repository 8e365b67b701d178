"""The shapes of a scene's assets that move, at the frame that the scene shows."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from rna_render.lights import AssetEmission
from rna_render.motion.asset_motion import Motion, open_asset_motion
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import MotionModel
from rna_render.world.placements import emission_of
from rna_sdk.errors import MotionError, QueryError
from rna_trace.asset_parts import Asset, Shape, part_geometry

Shapes = Sequence[Shape]


class MotionLoader:
    """Opens each motion once, and makes each shape once a frame; those of one frame are kept."""

    def __init__(self) -> None:
        self._motions: dict[tuple[object, ...], Motion] = {}
        self._shapes: dict[tuple[object, ...], Shapes] = {}
        self._emissions: dict[int, AssetEmission | None] = {}
        self._lengths: dict[tuple[object, ...], int] = {}
        self._scene: object = None

    def shapes(
        self, scene_file: SceneFile, index: int, package: Path, asset: Asset
    ) -> Shapes | None:
        """The parts of one of the scene's assets in motion; None where it does not move.

        Raises SceneError, which points at its `motion`, where this cannot be used.
        """
        if self._scene is not scene_file.scene:
            self._scene = scene_file.scene
            self._shapes.clear()
            self._emissions.clear()
        model = scene_file.scene.assets[index].motion
        if model is None:
            return None
        path = scene_file.resolve(model.path)
        key = id(asset), path, model.clip, model.rate
        try:
            if key not in self._motions:
                geometries = [part_geometry(part) for part in asset.parts]
                at = model.clip, model.rate
                self._motions[key] = open_asset_motion(path, geometries, package.name, *at)
                self._lengths[key[1:]] = self._motions[key].frames
            frame = _frame(model, self._motions[key].frames)
            if (*key, frame) not in self._shapes:
                positions = self._motions[key].positions(frame)
                pairs = zip(asset.parts, positions, strict=True)
                self._shapes[(*key, frame)] = [part.deformed(p) for part, p in pairs]
        except (MotionError, QueryError) as error:
            raise scene_file.error(("assets", index, "motion"), str(error)) from error
        return self._shapes[(*key, frame)]

    def check(self, scene_file: SceneFile) -> None:
        """Raises SceneError where a motion that is open has not the frame of the scene."""
        for index, asset in enumerate(scene_file.scene.assets):
            if (model := asset.motion) is None:
                continue
            path = scene_file.resolve(model.path)
            frames = self._lengths.get((path, model.clip, model.rate))
            if frames is not None and _frame(model, frames) > frames - 1:
                has = f"has frames 0 to {frames - 1}, and no frame {model.start:g}"
                raise scene_file.error(("assets", index, "motion"), f"{path}: {has}")

    def emission(self, asset: Asset, shapes: Shapes) -> AssetEmission | None:
        """The emission of an asset in motion, made once a frame."""
        if id(shapes) not in self._emissions:
            self._emissions[id(shapes)] = emission_of(asset, shapes)
        return self._emissions[id(shapes)]


def _frame(model: MotionModel, frames: int) -> float:
    """The frame that a motion of so many shows; until the next one would be, the last one."""
    if model.loop and frames > 1:
        return model.start % (frames - 1)
    return float(frames - 1) if frames - 1 < model.start < frames else model.start
