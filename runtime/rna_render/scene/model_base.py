"""Base model and value types of the scene file's schema."""

import math
import os
from pathlib import Path
from typing import Annotated

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    Field,
    field_validator,
    model_validator,
)

from rna_render.scene.limits import (
    MAX_NAME_BYTES,
    MAX_NUMBER,
    MAX_PATH_BYTES,
    MAX_SIZE,
    MIN_LENGTH,
    MIN_SIZE,
)


def _repeated(count: int) -> BeforeValidator:
    """One number stands for so many equal ones."""

    def repeat(value: object) -> object:
        return [value] * count if _is_number(value) else value

    return BeforeValidator(repeat)


def _is_number(value: object) -> bool:
    """Whether a key of one number would take it: quoted numbers are numbers there, too."""
    if not isinstance(value, int | float | str):
        return False
    try:
        return math.isfinite(float(value))
    except (ValueError, OverflowError):
        return False


def _no_truth(value: object) -> object:
    """pydantic takes true for 1."""
    if isinstance(value, bool):
        raise ValueError("must be a number, not true or false")
    return value


Real = Annotated[float, BeforeValidator(_no_truth)]
Whole = Annotated[int, BeforeValidator(_no_truth)]
Number = Annotated[Real, Field(ge=-MAX_NUMBER, le=MAX_NUMBER)]
Vector = tuple[Number, Number, Number]
Quaternion = tuple[Number, Number, Number, Number]
Nonnegative = Annotated[Real, Field(ge=0, le=MAX_NUMBER)]
Positive = Annotated[Real, Field(gt=0, le=MAX_NUMBER)]
Length = Annotated[Real, Field(ge=MIN_LENGTH, le=MAX_NUMBER)]
Scale = Annotated[Real, Field(ge=-MAX_SIZE, le=MAX_SIZE)]
Share = Annotated[Real, Field(ge=0, le=1)]
Rgb = Annotated[tuple[Nonnegative, Nonnegative, Nonnegative], _repeated(3)]
Albedo = Annotated[tuple[Share, Share, Share], _repeated(3)]
Size = Annotated[tuple[Length, Length], _repeated(2)]


def _possible(path: Path) -> Path:
    """The path, if a file can have it: else asking whether it is there raises OSError."""
    if "\0" in str(path):
        raise ValueError("must not contain a NUL character")
    names = [len(os.fsencode(name)) for name in path.parts]
    if max(names, default=0) > MAX_NAME_BYTES or len(os.fsencode(path)) > MAX_PATH_BYTES:
        raise ValueError(
            f"is too long: at most {MAX_PATH_BYTES} bytes, and {MAX_NAME_BYTES} a name"
        )
    return path


FilePath = Annotated[Path, AfterValidator(_possible)]


def is_short(vector: tuple[float, ...]) -> bool:
    """Whether the vector is zero or too short to have a direction."""
    return math.hypot(*vector) < MIN_LENGTH


class Model(BaseModel, extra="forbid", frozen=True, allow_inf_nan=False):
    """A mapping of the scene file: finite numbers, no unknown keys."""


class TransformModel(Model):
    """Object-to-world transform: scale, then rotation, then translation."""

    translation: Vector = Field(
        default=(0.0, 0.0, 0.0), description="World position of the object's origin, metres."
    )
    rotation_deg: Vector | None = Field(
        default=None,
        description="Euler angles in degrees about world x, then y, then z; positive is "
        "counter-clockwise seen from the axis's positive end.",
    )
    quaternion: Quaternion | None = Field(
        default=None,
        description="Rotation as x, y, z, w (glTF's order), of any non-zero length; replaces "
        "rotation_deg.",
    )
    scale: Scale = Field(
        default=1.0,
        description="Uniform scale; radiance is unchanged. A negative one mirrors through the "
        "object's origin.",
    )

    @field_validator("scale", mode="before")
    @classmethod
    def _one_number(cls, value: object) -> object:
        if isinstance(value, list | tuple):
            raise ValueError(
                "must be one number: an asset's light transport holds under uniform scale only"
            )
        return value

    @field_validator("scale")
    @classmethod
    def _has_size(cls, value: float) -> float:
        if abs(value) < MIN_SIZE:
            raise ValueError(f"must be at least {MIN_SIZE:g}, or at most -{MIN_SIZE:g}")
        return value

    @field_validator("quaternion")
    @classmethod
    def _has_length(cls, value: Quaternion | None) -> Quaternion | None:
        if value is not None and is_short(value):
            raise ValueError("must not be zero")
        return value

    @model_validator(mode="after")
    def _one_rotation(self) -> "TransformModel":
        if self.rotation_deg is not None and self.quaternion is not None:
            raise ValueError("has rotation_deg and quaternion; give one of them")
        return self
