"""The scene file's schema of lights."""

from __future__ import annotations

import math
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, field_validator, model_validator

from rna_render.scene.limits import MIN_LENGTH
from rna_render.scene.model_base import (
    FilePath,
    Length,
    Model,
    Number,
    Real,
    Rgb,
    Size,
    Vector,
    is_short,
)

Angle = Annotated[Real, Field(ge=0, le=180)]


def _check_aim(position: Vector, look_at: Vector) -> None:
    if math.dist(position, look_at) < MIN_LENGTH:
        raise ValueError("position and look_at are the same point")


class _LightModel(Model):
    group: str = Field(
        default="",
        pattern=r"^[A-Za-z0-9_]*$",
        description="Light group: its contribution is also written to `light.<group>.R`, `.G` and "
        "`.B`. Several lights may share a group.",
    )

    @property
    def bounding_radius(self) -> float:
        """Radius of a sphere about the light's position that contains the light, metres."""
        return 0.0


class _DirectedModel(_LightModel):
    direction: Vector = Field(description="Direction towards the light; any non-zero length.")

    @field_validator("direction")
    @classmethod
    def _has_length(cls, value: Vector) -> Vector:
        if is_short(value):
            raise ValueError("must not be zero")
        return value


class DirectionalModel(_DirectedModel):
    """Light from one direction, as from a distant sun; invisible to the camera."""

    type: Literal["directional"] = Field(description="`directional`")
    irradiance: Rgb = Field(description="Irradiance on a plane facing the light, W/m^2.")
    angular_diameter_deg: Angle = Field(
        default=0.0,
        description="Angular diameter; 0.53 for the sun. It softens shadows and leaves the "
        "irradiance unchanged.",
    )


class PointModel(_LightModel):
    """An isotropic point light."""

    type: Literal["point"] = Field(description="`point`")
    position: Vector = Field(description="Position, metres.")
    intensity: Rgb = Field(
        description="Radiant intensity, W/sr; irradiance at distance r is intensity / r^2."
    )


class SpotModel(_LightModel):
    """A point light restricted to a cone."""

    type: Literal["spot"] = Field(description="`spot`")
    position: Vector = Field(description="Position, metres.")
    look_at: Vector = Field(description="Point on the cone axis.")
    intensity: Rgb = Field(description="Radiant intensity within the inner cone, W/sr.")
    outer_angle_deg: Real = Field(default=45.0, gt=0, le=90, description="Half angle of the cone.")
    inner_angle_deg: Real = Field(
        default=30.0,
        ge=0,
        le=90,
        description="Half angle of full intensity, at most the outer angle. The falloff is a "
        "smoothstep of the cosine, as in Blender.",
    )

    @model_validator(mode="after")
    def _has_cone(self) -> SpotModel:
        _check_aim(self.position, self.look_at)
        if self.inner_angle_deg > self.outer_angle_deg:
            raise ValueError(
                f"inner_angle_deg, {self.inner_angle_deg:g}, must not be more than "
                f"outer_angle_deg, {self.outer_angle_deg:g}"
            )
        return self


class AreaModel(_LightModel):
    radiance: Rgb = Field(
        description="Emitted radiance, W/(m^2 sr), uniform over position and direction."
    )
    visible_to_camera: bool = Field(
        default=True, description="Whether the camera sees the emitter."
    )


class RectangleModel(AreaModel):
    """A rectangular area light that emits from its front."""

    type: Literal["rectangle"] = Field(description="`rectangle`")
    position: Vector = Field(description="Its middle.")
    look_at: Vector = Field(description="A point straight before it.")
    up: Vector = Field(default=(0.0, 1.0, 0.0), description="Direction of its height.")
    size: Size = Field(description="Width and height, metres.")

    @property
    def bounding_radius(self) -> float:
        return float(np.hypot(*self.size)) / 2.0

    @model_validator(mode="after")
    def _has_axes(self) -> RectangleModel:
        _check_aim(self.position, self.look_at)
        forward = np.subtract(self.look_at, self.position)
        side = np.linalg.norm(np.cross(forward, self.up))
        if side <= 1e-6 * np.linalg.norm(forward) * np.linalg.norm(self.up):
            raise ValueError("up must not be zero or along the line from position to look_at")
        return self


class DiskModel(AreaModel):
    """A disk-shaped area light that emits from its front."""

    type: Literal["disk"] = Field(description="`disk`")
    position: Vector = Field(description="Its middle.")
    look_at: Vector = Field(description="A point straight before it.")
    radius: Length = Field(description="Metres.")

    @property
    def bounding_radius(self) -> float:
        return self.radius

    @model_validator(mode="after")
    def _has_aim(self) -> DiskModel:
        _check_aim(self.position, self.look_at)
        return self


class SphereModel(AreaModel):
    """A spherical area light."""

    type: Literal["sphere"] = Field(description="`sphere`")
    position: Vector = Field(description="Its middle.")
    radius: Length = Field(description="Metres.")

    @property
    def bounding_radius(self) -> float:
        return self.radius


class EnvironmentModel(_LightModel):
    """An environment light: constant, or an image."""

    type: Literal["environment"] = Field(description="`environment`")
    radiance: Rgb = Field(
        default=(1.0, 1.0, 1.0), description="Radiance, W/(m^2 sr); scales the image, if any."
    )
    path: FilePath | None = Field(
        default=None,
        description="Equirectangular image, EXR or HDR, relative to the scene file. Its centre is "
        "direction -z, its top edge +y, its right half +x. Negative values are clamped to 0. "
        "Infinite ones, as a sun above 65,504 is in half floats, are cut to 65,504 with a warning; "
        "values above 1e18 and NaN are rejected.",
    )
    rotation_deg: Number = Field(
        default=0.0,
        description="Rotation of the image about +y, counter-clockwise seen from above.",
    )
    visible_to_camera: bool = Field(
        default=True,
        description="Whether the camera sees it as background; if not, alpha is 0 there.",
    )


LightModel = Annotated[
    DirectionalModel
    | PointModel
    | SpotModel
    | RectangleModel
    | DiskModel
    | SphereModel
    | EnvironmentModel,
    Field(discriminator="type"),
]
