"""What a scene file says: one model an object, one described field a key.

World space is right-handed with +Y up, in metres. Colours are linear RGB.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, field_validator, model_validator

from rna_render.limits import MAX_PIXELS_A_SIDE, MAX_SAMPLES, MAX_SEED

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
Nonnegative = Annotated[float, Field(ge=0)]
Rgb = tuple[Nonnegative, Nonnegative, Nonnegative]
PixelCount = Annotated[int, Field(ge=1, le=MAX_PIXELS_A_SIDE)]


class _Model(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class TransformModel(_Model):
    """Places an asset in the world: scale, then rotation, then translation."""

    translation: Vector = Field(default=(0.0, 0.0, 0.0), description="Where its origin goes.")
    rotation_deg: Vector | None = Field(
        default=None,
        description="Degrees about the world's x, then y, then z axis; each turn is "
        "counter-clockwise seen from the axis's positive end.",
    )
    quaternion: Quaternion | None = Field(
        default=None,
        description="The rotation as x, y, z, w (the order of glTF), of any length but zero; "
        "instead of rotation_deg.",
    )
    scale: float = Field(
        default=1.0, gt=0, description="Uniform scale; it changes no radiance, only the size."
    )

    @field_validator("scale", mode="before")
    @classmethod
    def _one_number(cls, value: object) -> object:
        if isinstance(value, list | tuple):
            raise ValueError(
                "must be one number: an asset's light transport holds under uniform scale only"
            )
        return value

    @field_validator("quaternion")
    @classmethod
    def _has_length(cls, value: Quaternion | None) -> Quaternion | None:
        if value is not None and not any(value):
            raise ValueError("must not be zero")
        return value

    @model_validator(mode="after")
    def _one_rotation(self) -> TransformModel:
        if self.rotation_deg is not None and self.quaternion is not None:
            raise ValueError("has rotation_deg and quaternion; give one of them")
        return self


class AssetModel(_Model):
    """One instance of a package; instances of the same package share its memory."""

    path: Path = Field(description="The .rna file, relative to the scene file.")
    tier: str | None = Field(
        default=None, description="Tier of the package to use; its first tier if left out."
    )
    transform: TransformModel = Field(
        default=TransformModel(), description="Where it stands; at the origin if left out."
    )


class CameraModel(_Model):
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
        if not np.any(forward):
            raise ValueError("position and look_at are the same point")
        if side <= 1e-6 * np.linalg.norm(forward) * np.linalg.norm(self.up):
            raise ValueError("up must not be zero or along the line of sight")
        return self


class DirectionalModel(_Model):
    """Light from one direction, as from a distant sun."""

    type: Literal["directional"] = Field(description="`directional`")
    direction: Vector = Field(description="Towards the light; any length but zero.")
    irradiance: Rgb = Field(description="W/m^2 on a plane that faces the light.")

    @field_validator("direction")
    @classmethod
    def _has_length(cls, value: Vector) -> Vector:
        if not any(value):
            raise ValueError("must not be zero")
        return value


class PointModel(_Model):
    """Light from a point, the same to all sides."""

    type: Literal["point"] = Field(description="`point`")
    position: Vector = Field(description="Where it is.")
    intensity: Rgb = Field(description="W/sr; at distance r it brings irradiance intensity / r^2.")


class EnvironmentModel(_Model):
    """The same light from every direction."""

    type: Literal["environment"] = Field(description="`environment`")
    radiance: Rgb = Field(description="W/(m^2 sr).")
    visible_to_camera: bool = Field(
        default=True, description="Whether it is the background too; if not, alpha is 0 there."
    )


LightModel = Annotated[
    DirectionalModel | PointModel | EnvironmentModel, Field(discriminator="type")
]


class Scene(_Model):
    """A scene file."""

    assets: tuple[AssetModel, ...] = Field(min_length=1, description="What is in the scene.")
    camera: CameraModel = Field(description="Where it is seen from.")
    lights: tuple[LightModel, ...] = Field(default=(), description="What lights it.")
    resolution: tuple[PixelCount, PixelCount] = Field(
        default=(640, 480), description="Width and height of the image, pixels."
    )
    samples: int = Field(default=64, ge=1, le=MAX_SAMPLES, description="Samples a pixel.")
    seed: int = Field(
        default=0,
        ge=0,
        le=MAX_SEED,
        description="Start of the random numbers; same seed, same image.",
    )
    exposure: float = Field(
        default=0.0, ge=-64, le=64, description="Stops: the PNG shows radiance times 2^exposure."
    )
