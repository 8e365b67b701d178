"""The shapes of a scene's assets that move, at the frame that the scene shows."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rna_render.lights import AssetEmission
from rna_render.motion.asset_motion import open_asset_motion
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import MotionModel
from rna_render.world.next_frame import NextFrame
from rna_render.world.placements import emission_of
from rna_sdk.errors import MotionError, QueryError
from rna_sdk.motion import Motion
from rna_sdk.package import Package
from rna_trace.asset_parts import Asset, Shape, part_geometry

Shapes = Sequence[Shape]


class MotionLoader:
    """Opens each motion once, and makes each shape once a frame; those of one frame are kept."""

    def __init__(self) -> None:
        self._motions: dict[tuple[object, ...], Motion] = {}
        self._shapes: dict[tuple[object, ...], Shapes] = {}
        self._emissions: dict[int, AssetEmission | None] = {}
        self._after: dict[tuple[object, ...], tuple[float, list[np.ndarray]]] = {}
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
        key = _key(scene_file, index)
        try:
            if key not in self._motions:
                geometries = [part_geometry(part) for part in asset.parts]
                with Package.open(package) as opened:
                    rest_frame = opened.manifest.provenance.rest_frame
                at = model.clip, model.rate, rest_frame
                path = scene_file.resolve(model.path)
                self._motions[key] = open_asset_motion(path, geometries, package.name, *at)
            motion = self._motions[key]
            frame = _frame(model, motion.frames)
            shape = id(asset), *key, frame
            if shape not in self._shapes:
                kept, positions = self._after.get(key, (-1.0, []))
                if kept != frame:
                    positions = motion.positions(frame)
                pairs = zip(asset.parts, positions, strict=True)
                self._shapes[shape] = [part.deformed(p) for part, p in pairs]
        except (MotionError, QueryError) as error:
            raise scene_file.error(("assets", index, "motion"), str(error)) from error
        return self._shapes[shape]

    def after(self, scene_file: SceneFile, index: int, shapes: Shapes | None) -> NextFrame | None:
        """Where an asset in motion is in the next frame; after the last one it stays there."""
        model = scene_file.scene.assets[index].motion
        if model is None or shapes is None:
            return None
        key = _key(scene_file, index)
        motion = self._motions[key]
        frame = _frame(model, motion.frames, 1.0)
        if self._after.get(key, (-1.0, []))[0] != frame:
            try:
                self._after[key] = frame, motion.positions(frame)
            except MotionError as error:
                raise scene_file.error(("assets", index, "motion"), str(error)) from error
        return NextFrame(shapes, self._after[key][1])

    def check(self, scene_file: SceneFile) -> None:
        """Raises SceneError where a motion that is open has not the frame of the scene."""
        for index, asset in enumerate(scene_file.scene.assets):
            if asset.motion is None or (key := _key(scene_file, index)) not in self._motions:
                continue
            motion = self._motions[key]
            try:
                motion.check_frame(_frame(asset.motion, motion.frames))
            except MotionError as error:
                raise scene_file.error(("assets", index, "motion"), str(error)) from error

    def emission(self, asset: Asset, shapes: Shapes) -> AssetEmission | None:
        """The emission of an asset in motion, made once a frame."""
        if id(shapes) not in self._emissions:
            self._emissions[id(shapes)] = emission_of(asset, shapes)
        return self._emissions[id(shapes)]


def _key(scene_file: SceneFile, index: int) -> tuple[object, ...]:
    """What an asset of the scene has its motion by: all tiers of a package have its vertices."""
    model = scene_file.scene.assets[index].motion
    assert model is not None
    path = scene_file.resolve(model.path)
    return scene_file.asset_path(index), path, model.clip, model.rate


def _frame(model: MotionModel, frames: int, later: float = 0.0) -> float:
    """The frame that a motion of so many shows; until the next one would be, the last one.

    later: 1 for the next frame, which after the last one is this.
    """
    at, last = model.start + later, float(frames - 1)
    if model.loop and frames > 1:
        return at % last
    return last if last < at < frames + later else at
