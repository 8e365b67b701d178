"""Objects, their placement and their emission."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import cast

import numpy as np

from rna_render.lights import AssetEmission, AssetLight, MeshLight, PlacedLight, ShapeLight
from rna_render.materials import MeshObject
from rna_render.world.next_frame import NextFrame
from rna_sdk.runtime import Asset
from rna_trace.asset_parts import Shape, part_geometry, shaped_parts

SceneObject = Asset | MeshObject | PlacedLight


@dataclass(frozen=True)
class Placement:
    """An object, and where it stands.

    light: what it shines with, if it does. boundless: whether it says nothing about the size of
    the scene, as a ground. indirect: the same asset with another tier, which answers what the
    camera does not see directly; None for `object` itself. shapes: of the parts of an asset in
    motion. after: where these are in the next frame.
    """

    object: SceneObject
    world_from_object: np.ndarray  # (4, 4), a similarity
    light: ShapeLight | None = None
    boundless: bool = False
    indirect: Asset | None = None
    shapes: Sequence[Shape] | None = None
    after: NextFrame | None = None

    @cached_property
    def own_box(self) -> tuple[np.ndarray, np.ndarray]:
        """Lower and upper corner, each (3,), of its box in its own space."""
        return _box(self.object, self.shapes)


def _box(
    scene_object: SceneObject, shapes: Sequence[Shape] | None
) -> tuple[np.ndarray, np.ndarray]:
    if isinstance(scene_object, MeshObject):
        return scene_object.positions.min(axis=0), scene_object.positions.max(axis=0)
    pairs = shaped_parts(cast(Asset, scene_object), shapes)
    boxes = [part_geometry(*pair).box() for pair in pairs]
    low, high = zip(*boxes, strict=True)
    return np.min(low, axis=0), np.max(high, axis=0)


def place_asset(
    asset: Asset,
    world_from_object: np.ndarray,
    emission: AssetEmission | None = None,
    factor: float = 1.0,
    indirect: Asset | None = None,
    shapes: Sequence[Shape] | None = None,
    after: NextFrame | None = None,
) -> Placement:
    """An asset, and the light that it sends out.

    world_from_object: (4, 4), a similarity. emission: `emission_of` the asset, for callers that
    place it several times. factor: on what it emits. indirect, shapes, after: see Placement.
    """
    emission = emission or emission_of(asset, shapes)
    light = None
    if emission is not None and factor > 0.0:
        light = AssetLight(emission, world_from_object, factor)
    return Placement(asset, world_from_object, light, False, indirect, shapes, after)


def emission_of(asset: Asset, shapes: Sequence[Shape] | None = None) -> AssetEmission | None:
    """Emission of an asset; None if it has none. shapes: see Placement."""
    return AssetEmission(asset, shapes) if any(part.emits for part in asset.parts) else None


def mesh_light(scene_object: MeshObject, world_from_object: np.ndarray) -> MeshLight | None:
    """Emission of an object; None if it has none."""
    if not scene_object.is_emissive:
        return None
    linear, translation = world_from_object[:3, :3], world_from_object[:3, 3]
    positions = (scene_object.positions @ linear.T + translation).astype(np.float32)
    opaque = None if scene_object.transmittance is None else scene_object.opaque_emission
    return MeshLight(
        positions,
        scene_object.triangles,
        luminance=scene_object.emitted_luminance,
        emission=scene_object.emission,
        opaque_emission=opaque,
    )
