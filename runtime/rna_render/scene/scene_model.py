"""The scene file's schema: one model per mapping, one field with a description per key.

World space is right-handed with +Y up, in metres. Colours are linear RGB.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import BeforeValidator, Field, model_validator

from rna_render.scene.light_models import LightModel
from rna_render.scene.limits import MAX_DEPTH, MAX_FRAMES, MAX_PIXELS_A_SIDE, MAX_SAMPLES, MAX_SEED
from rna_render.scene.material_models import DiffuseModel, MaterialModel
from rna_render.scene.model_base import (
    FilePath,
    Length,
    Model,
    Nonnegative,
    Number,
    Positive,
    Real,
    Share,
    TransformModel,
    Vector,
    Whole,
    is_short,
)

PixelCount = Annotated[Whole, Field(ge=1, le=MAX_PIXELS_A_SIDE)]


class MotionModel(Model):
    """Deformation of an asset over time; a path alone is short for it."""

    path: FilePath = Field(
        description="A motion file of `rna-motion`, or an animated .glb or .gltf, relative to the "
        "scene file."
    )
    clip: str | None = Field(
        default=None, description="Animation of a glTF by its name; its first if omitted."
    )
    rate: Positive = Field(default=24.0, description="Frames per second, of a glTF.")
    start: Annotated[Real, Field(ge=0, le=MAX_FRAMES)] = Field(
        default=0.0,
        description="Frame of the motion in frame 0 of the scene, and in a still image.",
    )
    loop: bool = Field(
        default=False,
        description="Repeats the motion; its last frame must equal the first, to 1% of the asset's "
        "size, and is left out.",
    )


def _path_of_motion(value: object) -> object:
    return {"path": value} if isinstance(value, str | Path) else value


class AssetModel(Model):
    """One instance of a package; instances of the same package share its memory."""

    path: FilePath = Field(
        description="The .rna file, or a .glb that carries one, relative to the scene file."
    )
    tier: str | None = Field(
        default=None, description="Tier of the package; its first tier if omitted."
    )
    transform: TransformModel = Field(
        default=TransformModel(), description="Placement in the world; identity if omitted."
    )
    emission: Nonnegative = Field(default=1.0, description="Scale factor on the asset's emission.")
    variant: str | None = Field(
        default=None,
        description="Variant of the base colours, as listed by `rna-info`; the default if omitted.",
    )
    maps: dict[str, FilePath] = Field(
        default={},
        description="Other images for its base colour: the label of an image, as `rna-info` lists "
        "them, and a PNG, JPEG or WebP file.",
    )
    tint: tuple[Nonnegative, Nonnegative, Nonnegative] = Field(
        default=(1.0, 1.0, 1.0), description="Factor of all its base colours, linear RGB."
    )
    alone: bool = Field(
        default=False,
        description="Of a .glb: its package once, in its own space, without the file's nodes and "
        "other meshes.",
    )
    motion: Annotated[MotionModel | None, BeforeValidator(_path_of_motion)] = Field(
        default=None,
        description="Bends the asset, frame by frame: a path, or a mapping; see below.",
    )


class CameraModel(Model):
    """A pinhole camera, or one with a thin lens."""

    position: Vector = Field(description="Position of the pinhole, or of the lens's middle.")
    look_at: Vector = Field(description="Point at the image centre.")
    up: Vector = Field(default=(0.0, 1.0, 0.0), description="Up vector of the image.")
    vertical_fov_deg: Real = Field(
        default=40.0, gt=0, lt=180, description="Vertical field of view, degrees."
    )
    aperture: Nonnegative = Field(
        default=0.0,
        description="Diameter of the lens's opening, metres: focal length / f-number. 0 is a "
        "pinhole, which has everything sharp.",
    )
    focus: Length | None = Field(
        default=None,
        description="Distance of the sharp plane from the camera, metres; the distance of "
        "look_at if omitted.",
    )

    @property
    def focus_distance(self) -> float:
        """Distance of the sharp plane, metres."""
        return self.focus or float(np.linalg.norm(np.subtract(self.look_at, self.position)))

    @model_validator(mode="after")
    def _has_axes(self) -> CameraModel:
        forward = np.subtract(self.look_at, self.position)
        side = np.linalg.norm(np.cross(forward, self.up))
        if is_short(tuple(forward)):
            raise ValueError("position and look_at are the same point")
        if side <= 1e-6 * np.linalg.norm(forward) * np.linalg.norm(self.up):
            raise ValueError("up must not be zero or along the line of sight")
        return self


class ObjectModel(Model):
    """A conventional mesh: a glTF, OBJ or PLY file."""

    path: FilePath = Field(
        description="A .glb, .gltf, .obj or .ply file, relative to the scene file."
    )
    transform: TransformModel = Field(
        default=TransformModel(), description="Placement in the world; identity if omitted."
    )
    material: MaterialModel | None = Field(
        default=None, description="Material of the whole mesh; the file's own materials if omitted."
    )
    fallbacks: bool = Field(
        default=True, description="Of a .glb with packages: whether their fallbacks are shown."
    )


class GroundModel(Model):
    """A square, horizontal plane."""

    height: Number = Field(default=0.0, description="Its y coordinate, metres.")
    size: Length | None = Field(
        default=None,
        description="Side length, metres; without end if omitted.",
    )
    material: MaterialModel = Field(
        default=DiffuseModel(type="diffuse"), description="Its material; diffuse grey if omitted."
    )


class TurnModel(Model):
    """A rotation about +y, spread over the frames."""

    degrees: Number = Field(
        default=360.0, description="Total angle; positive is counter-clockwise seen from above."
    )


class QualityModel(Model):
    """Error or time target, from which the renderer picks each asset's tier."""

    max_error: Positive | None = Field(
        default=None,
        description="Largest mean FLIP of an asset's pixels at its size in the image; each asset "
        "gets the cheapest tier that meets it.",
    )
    seconds: Positive | None = Field(
        default=None,
        description="Time limit per image, excluding asset loading. `samples` becomes the maximum; "
        "cheaper tiers are used if fewer than 16 samples would fit.",
    )

    @model_validator(mode="after")
    def _asks_for_something(self) -> QualityModel:
        if self.max_error is None and self.seconds is None:
            raise ValueError("quality is empty: give max_error, seconds or both")
        return self


class AnimationModel(Model):
    """An image sequence of the same scene."""

    frames: Whole = Field(ge=1, le=MAX_FRAMES, description="Number of frames, numbered from 0.")
    turntable: TurnModel | None = Field(
        default=None, description="Orbits the camera about its look_at point."
    )
    light_sweep: TurnModel | None = Field(
        default=None, description="Rotates directional lights and environments."
    )
    shutter: Share = Field(
        default=0.0,
        description="Motion blur: how long the shutter is open from each frame on, as a share of "
        "the time to the next; 0 for none.",
    )
    subframes: Whole = Field(
        default=8,
        ge=1,
        le=256,
        description="Number of times at which the open shutter sees the scene; its samples are "
        "shared among them.",
    )
    fixed_seed: bool = Field(
        default=False,
        description="The same noise in every frame; by default frame i has the seed `seed` + i.",
    )


class Scene(Model):
    """A scene file."""

    assets: tuple[AssetModel, ...] = Field(default=(), description="Neural assets.")
    objects: tuple[ObjectModel, ...] = Field(default=(), description="Conventional meshes.")
    ground: GroundModel | None = Field(default=None, description="Ground plane.")
    camera: CameraModel = Field(description="The camera.")
    lights: tuple[LightModel, ...] = Field(default=(), description="Light sources.")
    resolution: tuple[PixelCount, PixelCount] = Field(
        default=(640, 480), description="Width and height of the image, pixels."
    )
    samples: Whole = Field(default=64, ge=1, le=MAX_SAMPLES, description="Samples per pixel.")
    quality: QualityModel | None = Field(
        default=None, description="Error or time target; see below."
    )
    max_depth: Whole = Field(
        default=8,
        ge=1,
        le=MAX_DEPTH,
        description="Maximum path length in surface interactions, including the first visible one; "
        "1 is direct lighting only.",
    )
    clamp_indirect: Positive | Literal["auto"] | None = Field(
        default="auto",
        description="Clamp on per-path indirect radiance. Removes fireflies and their energy. "
        "`auto` is 10 times the mean radiance of a white sphere as large as the scene, without "
        "objects beyond 100 times the distance of `look_at`, under its lights; null disables "
        "the clamp and its bias. `rna-run` says how much light it took, above 0.1%; not with "
        "`--device gpu`.",
    )
    seed: Whole = Field(
        default=0, ge=0, le=MAX_SEED, description="Random seed; the same seed gives the same image."
    )
    view: Literal["srgb", "filmic"] = Field(
        default="srgb",
        description="View transform of the PNG: clamped, or filmic with shoulder and toe.",
    )
    exposure: Real = Field(
        default=0.0,
        ge=-64,
        le=64,
        description="Exposure of the PNG in stops; radiance is scaled by 2^exposure.",
    )

    animation: AnimationModel | None = Field(
        default=None, description="Animation, for `rna-run --frames`."
    )

    @model_validator(mode="after")
    def _has_something(self) -> Scene:
        if not (self.assets or self.objects or self.ground):
            raise ValueError("the scene is empty: it has no assets, objects or ground")
        return self

    @model_validator(mode="after")
    def _something_moves(self) -> Scene:
        animation = self.animation
        still = animation is not None and animation.turntable is animation.light_sweep is None
        if still and all(asset.motion is None for asset in self.assets):
            raise ValueError(
                "animation: nothing moves: give turntable, light_sweep, or an asset's motion"
            )
        return self

    @model_validator(mode="after")
    def _sweep_has_lights(self) -> Scene:
        swept = self.animation is not None and self.animation.light_sweep is not None
        if swept and not any(light.type in ("directional", "environment") for light in self.lights):
            raise ValueError(
                "animation.light_sweep rotates directional lights and environments, and the scene "
                "has none"
            )
        return self
