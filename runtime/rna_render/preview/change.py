"""Requests that the page may send."""

from typing import Annotated, Literal

from pydantic import BaseModel, Field

Turn = Annotated[float, Field(ge=-3600, le=3600)]
Shift = Annotated[float, Field(ge=-10, le=10)]


class Change(BaseModel, extra="forbid", frozen=True, allow_inf_nan=False, strict=True):
    """A change of the view; absent fields stay unchanged. Reset is applied first."""

    reset: bool = Field(default=False, description="Back to the scene's own camera.")
    orbit_deg: tuple[Turn, Turn] = Field(
        default=(0.0, 0.0), description="Further round and further up, degrees."
    )
    dolly: float = Field(default=1.0, ge=0.01, le=100, description="Times the distance.")
    pan: tuple[Shift, Shift] = Field(
        default=(0.0, 0.0), description="To the right and up, heights of the image."
    )
    light_rotation_deg: Turn | None = Field(
        default=None, description="How far the lights are turned, from where the scene has them."
    )
    lighting: str | None = Field(default=None, max_length=64, description="Key of the choice.")
    exposure: float | None = Field(default=None, ge=-64, le=64, description="Stops.")
    view: Literal["srgb", "filmic"] | None = Field(default=None, description="View transform.")
    denoise: bool | None = Field(default=None, description="Whether noise is taken out.")
