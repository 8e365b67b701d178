"""What a scene file says of lights."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, field_validator, model_validator

from rna_render.limits import MIN_LENGTH
from rna_render.model_base import Length, Model, Number, Rgb, Vector, is_short

Angle = Annotated[float, Field(ge=0, le=180)]


def _check_aim(position: Vector, look_at: Vector) -> None:
    if math.dist(position, look_at) < MIN_LENGTH:
        raise ValueError("position and look_at are the same point")


class _LightModel(Model):
    group: str = Field(
        default="",
        pattern=r"^[A-Za-z0-9_]*$",
        description="Its light alone goes to the channels `light.<group>.R`, `.G` and `.B` too; "
        "several lights may share a group.",
    )


class _DirectedModel(_LightModel):
    direction: Vector = Field(description="Towards the light; any length but zero.")

    @field_validator("direction")
    @classmethod
    def _has_length(cls, value: Vector) -> Vector:
        if is_short(value):
            raise ValueError("must not be zero")
        return value


class DirectionalModel(_DirectedModel):
    """Light from one direction, as from a distant sun; no camera sees it."""

    type: Literal["directional"] = Field(description="`directional`")
    irradiance: Rgb = Field(description="W/m^2 on a plane that faces the light.")
    angular_diameter_deg: Angle = Field(
        default=0.0,
        description="How large it looks; the sun 0.53. It softens shadows, and the irradiance "
        "stays as it is.",
    )


class PointModel(_LightModel):
    """Light from a point, the same to all sides."""

    type: Literal["point"] = Field(description="`point`")
    position: Vector = Field(description="Where it is.")
    intensity: Rgb = Field(description="W/sr; at distance r it brings irradiance intensity / r^2.")


class SpotModel(_LightModel):
    """Light from a point, within a cone."""

    type: Literal["spot"] = Field(description="`spot`")
    position: Vector = Field(description="Where it is.")
    look_at: Vector = Field(description="A point on the axis of its cone.")
    intensity: Rgb = Field(description="W/sr within the inner cone.")
    outer_angle_deg: float = Field(
        default=45.0, gt=0, le=90, description="From the axis to where its light ends."
    )
    inner_angle_deg: float = Field(
        default=30.0,
        ge=0,
        le=90,
        description="From the axis to where it begins to fall, by a smoothstep of the cosine, as "
        "Blender's spot lamp; at most the outer angle.",
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
    radiance: Rgb = Field(description="W/(m^2 sr), from every point to every direction.")
    visible_to_camera: bool = Field(
        default=True, description="Whether the camera sees the light itself."
    )


class RectangleModel(AreaModel):
    """A rectangle that sends light from its front."""

    type: Literal["rectangle"] = Field(description="`rectangle`")
    position: Vector = Field(description="Its middle.")
    look_at: Vector = Field(description="A point straight before it.")
    up: Vector = Field(default=(0.0, 1.0, 0.0), description="Where its height points to.")
    size: tuple[Length, Length] = Field(description="Width and height, metres.")

    @model_validator(mode="after")
    def _has_axes(self) -> RectangleModel:
        _check_aim(self.position, self.look_at)
        forward = np.subtract(self.look_at, self.position)
        side = np.linalg.norm(np.cross(forward, self.up))
        if side <= 1e-6 * np.linalg.norm(forward) * np.linalg.norm(self.up):
            raise ValueError("up must not be zero or along the line from position to look_at")
        return self


class DiskModel(AreaModel):
    """A disk that sends light from its front."""

    type: Literal["disk"] = Field(description="`disk`")
    position: Vector = Field(description="Its middle.")
    look_at: Vector = Field(description="A point straight before it.")
    radius: Length = Field(description="Metres.")

    @model_validator(mode="after")
    def _has_aim(self) -> DiskModel:
        _check_aim(self.position, self.look_at)
        return self


class SphereModel(AreaModel):
    """A sphere that sends light outwards."""

    type: Literal["sphere"] = Field(description="`sphere`")
    position: Vector = Field(description="Its middle.")
    radius: Length = Field(description="Metres.")


class EnvironmentModel(_LightModel):
    """Light from all around: one colour, or an image."""

    type: Literal["environment"] = Field(description="`environment`")
    radiance: Rgb = Field(
        default=(1.0, 1.0, 1.0), description="W/(m^2 sr); with an image, what multiplies it."
    )
    path: Path | None = Field(
        default=None,
        description="An equirectangular image, EXR or HDR, relative to the scene file. Its middle "
        "is seen in direction -z, its upper edge is +y, its right half lies towards +x. Negative "
        "values count as 0; values that are not finite, or above 1e18, are refused.",
    )
    rotation_deg: Number = Field(
        default=0.0, description="Turns the image about +y, counter-clockwise seen from above."
    )
    visible_to_camera: bool = Field(
        default=True, description="Whether it is the background too; if not, alpha is 0 there."
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
