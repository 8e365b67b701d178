"""The shapes of a scene's assets that move, at the frame that the scene shows."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rna_render.lights import AssetEmission
from rna_render.motion.asset_motion import open_asset_motion
from rna_render.scene.scene_model import MotionModel
from rna_render.world.next_frame import NextFrame
from rna_render.world.placements import emission_of
from rna_sdk.errors import MotionError
from rna_sdk.motion import Motion
from rna_sdk.package import Package
from rna_sdk.runtime import Asset
from rna_trace.asset_parts import Shape, part_geometry

Shapes = Sequence[Shape]

_CLOSED = 0.01  # of an asset's size, how far the ends of a loop may be apart


class MotionLoader:
    """Opens each motion once, and makes each shape once a frame; shapes of a frame are cached."""

    def __init__(self) -> None:
        self._motions: dict[tuple[object, ...], Motion] = {}
        self._closed: set[tuple[object, ...]] = set()  # motions whose ends meet
        self._shapes: dict[tuple[object, ...], Shapes] = {}
        self._emissions: dict[int, AssetEmission | None] = {}
        self._after: dict[tuple[object, ...], tuple[float, list[np.ndarray]]] = {}

    def begin_frame(self) -> None:
        """Forget the shapes of the frame before."""
        self._shapes.clear()
        self._emissions.clear()

    def shapes(self, model: MotionModel, package: Path, asset: Asset) -> Shapes:
        """The parts of a package's asset in motion. model: with a resolved path.

        Raises MotionError or QueryError where the motion cannot be used.
        """
        key = _key(model, package)
        if key not in self._motions:
            geometries = [part_geometry(part) for part in asset.parts]
            with Package.open(package) as opened:
                rest_frame = opened.manifest.provenance.rest_frame
            self._motions[key] = open_asset_motion(
                model.path,
                geometries,
                package.name,
                clip=model.clip,
                rate=model.rate,
                rest_frame=rest_frame,
            )
        motion = self._motions[key]
        if model.loop and key not in self._closed:
            _check_closed(motion)
            self._closed.add(key)
        frame = _frame(model, motion.frames)
        shape = id(asset), *key, frame
        if shape not in self._shapes:
            stored, positions = self._after.get(key, (-1.0, []))
            if stored != frame:
                positions = motion.positions(frame)
            pairs = zip(asset.parts, positions, strict=True)
            self._shapes[shape] = [part.deformed(p) for part, p in pairs]
        return self._shapes[shape]

    def after(self, model: MotionModel, package: Path, shapes: Shapes) -> NextFrame:
        """Where a package's asset, of these shapes, is in the next frame; after the last one it
        stays there. Raises MotionError."""
        key = _key(model, package)
        motion = self._motions[key]
        frame = _frame(model, motion.frames, 1.0)
        if self._after.get(key, (-1.0, []))[0] != frame:
            self._after[key] = frame, motion.positions(frame)
        return NextFrame(shapes, self._after[key][1])

    def check(self, model: MotionModel, package: Path) -> None:
        """Raises MotionError where a motion that is open has not the frame that is shown."""
        motion = self._motions.get(_key(model, package))
        if motion is not None:
            motion.check_frame(_frame(model, motion.frames))

    def emission(self, asset: Asset, shapes: Shapes) -> AssetEmission | None:
        """The emission of an asset in motion, made once a frame."""
        if id(shapes) not in self._emissions:
            self._emissions[id(shapes)] = emission_of(asset, shapes)
        return self._emissions[id(shapes)]


def _key(model: MotionModel, package: Path) -> tuple[object, ...]:
    """The motion source of an asset: all tiers of a package have its vertices."""
    return package, model.path, model.clip, model.rate


def _check_closed(motion: Motion) -> None:
    """Raises MotionError where the last frame is not the first: a loop would jump there."""
    last = motion.frames - 1
    first, end = (np.concatenate(motion.positions(frame)) for frame in (0, last))
    apart = float(np.linalg.norm(end - first, axis=1).max())
    if apart > _CLOSED * float(np.linalg.norm(np.ptp(first, axis=0))):
        raise MotionError(
            f"{motion.path}: loop: frame {last} is up to {apart:.3g} m from frame 0; expected the "
            "same shape"
        )


def _frame(model: MotionModel, frames: int, later: float = 0.0) -> float:
    """The frame that a motion of so many shows; until the next one would be, the last one.

    later: 1 for the next frame, which after the last one is this.
    """
    at, last = model.start + later, float(frames - 1)
    if model.loop and frames > 1:
        return at % last
    return last if last < at < frames + later else at
