"""What a scene file says: one model an object, one described field a key.

World space is right-handed with +Y up, in metres. Colours are linear RGB.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, model_validator

from rna_render.lights.models import LightModel
from rna_render.limits import MAX_DEPTH, MAX_FRAMES, MAX_PIXELS_A_SIDE, MAX_SAMPLES, MAX_SEED
from rna_render.materials.models import DiffuseModel, MaterialModel
from rna_render.model_base import (
    Length,
    Model,
    Nonnegative,
    Number,
    Positive,
    TransformModel,
    Vector,
    is_short,
)

PixelCount = Annotated[int, Field(ge=1, le=MAX_PIXELS_A_SIDE)]


class AssetModel(Model):
    """One instance of a package; instances of the same package share its memory."""

    path: Path = Field(description="The .rna file, relative to the scene file.")
    tier: str | None = Field(
        default=None, description="Tier of the package to use; its first tier if left out."
    )
    transform: TransformModel = Field(
        default=TransformModel(), description="Where it stands; at the origin if left out."
    )
    emission: Nonnegative = Field(
        default=1.0, description="Factor on the light that it sends out itself, if it does."
    )


class CameraModel(Model):
    """A pinhole camera."""

    position: Vector = Field(description="Where the pinhole is.")
    look_at: Vector = Field(description="The point in the middle of the image.")
    up: Vector = Field(default=(0.0, 1.0, 0.0), description="What is up in the image.")
    vertical_fov_deg: float = Field(
        default=40.0, gt=0, lt=180, description="Angle from the top edge to the bottom edge."
    )

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
    """A mesh that is not neural: a glTF, OBJ or PLY file."""

    path: Path = Field(description="A .glb, .gltf, .obj or .ply file, relative to the scene file.")
    transform: TransformModel = Field(
        default=TransformModel(), description="Where it stands; at the origin if left out."
    )
    material: MaterialModel | None = Field(
        default=None, description="For the whole mesh; the file's own materials if left out."
    )


class GroundModel(Model):
    """A square, level plane."""

    height: Number = Field(default=0.0, description="Its y.")
    size: Length = Field(default=100.0, description="Length of its sides, metres.")
    material: MaterialModel = Field(
        default=DiffuseModel(type="diffuse"), description="What it is made of; grey if left out."
    )


class TurnModel(Model):
    """A turn about +y, spread over the frames."""

    degrees: Number = Field(
        default=360.0,
        description="How far in all; positive is counter-clockwise seen from above.",
    )


class QualityModel(Model):
    """What the image has to be, for which the renderer picks each asset's tier."""

    max_error: Positive | None = Field(
        default=None,
        description="Largest error of an asset, as mean FLIP at its size in the image; each asset "
        "gets the cheapest tier that meets it.",
    )
    seconds: Positive | None = Field(
        default=None,
        description="Longest time to render an image, once its assets are loaded. `samples` is "
        "then the most; cheaper tiers are taken where fewer than 16 would fit.",
    )

    @model_validator(mode="after")
    def _has_limit(self) -> QualityModel:
        if self.max_error is None and self.seconds is None:
            raise ValueError("nothing is asked for: give max_error or seconds, or both")
        return self


class AnimationModel(Model):
    """A sequence of images of the same things."""

    frames: int = Field(ge=1, le=MAX_FRAMES, description="How many images, numbered from 0.")
    turntable: TurnModel | None = Field(
        default=None, description="The camera goes around the point that it looks at."
    )
    light_sweep: TurnModel | None = Field(
        default=None, description="Directional lights and environments turn."
    )

    @model_validator(mode="after")
    def _has_motion(self) -> AnimationModel:
        if self.turntable is None and self.light_sweep is None:
            raise ValueError("nothing moves: give turntable or light_sweep, or both")
        return self


class Scene(Model):
    """A scene file."""

    assets: tuple[AssetModel, ...] = Field(default=(), description="The neural assets.")
    objects: tuple[ObjectModel, ...] = Field(default=(), description="Meshes beside them.")
    ground: GroundModel | None = Field(default=None, description="What they stand on.")
    camera: CameraModel = Field(description="Where it is seen from.")
    lights: tuple[LightModel, ...] = Field(default=(), description="What lights it.")
    resolution: tuple[PixelCount, PixelCount] = Field(
        default=(640, 480), description="Width and height of the image, pixels."
    )
    samples: int = Field(default=64, ge=1, le=MAX_SAMPLES, description="Samples a pixel.")
    quality: QualityModel | None = Field(
        default=None, description="An error or a time to keep; see below."
    )
    max_depth: int = Field(
        default=8,
        ge=1,
        le=MAX_DEPTH,
        description="Things that light may meet on its way to the camera, the first one seen "
        "included; 1 is direct light alone.",
    )
    clamp_indirect: Positive | Literal["auto"] | None = Field(
        default="auto",
        description="Clamp on per-path indirect radiance. It removes specks, and the light that "
        "was in them. `auto` is 10 times what a white ball in "
        "the scene's light would send on average; null for no clamp, and no bias.",
    )
    seed: int = Field(
        default=0,
        ge=0,
        le=MAX_SEED,
        description="Start of the random numbers; same seed, same image.",
    )
    view: Literal["srgb", "filmic"] = Field(
        default="srgb",
        description="How the PNG shows radiance: clamped, or with a filmic shoulder and toe.",
    )
    exposure: float = Field(
        default=0.0, ge=-64, le=64, description="Stops: the PNG shows radiance times 2^exposure."
    )

    animation: AnimationModel | None = Field(
        default=None, description="What moves from frame to frame, for `rna-run --frames`."
    )

    @model_validator(mode="after")
    def _has_something(self) -> Scene:
        if not (self.assets or self.objects or self.ground):
            raise ValueError("there is nothing in the scene: it has no assets, objects or ground")
        return self

    @model_validator(mode="after")
    def _sweep_has_lights(self) -> Scene:
        swept = self.animation is not None and self.animation.light_sweep is not None
        if swept and not any(light.type in ("directional", "environment") for light in self.lights):
            raise ValueError(
                "animation.light_sweep turns directional lights and environments: there are none"
            )
        return self
