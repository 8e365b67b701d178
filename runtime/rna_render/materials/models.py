"""What a scene file says of materials: those of glTF 2.0, and the shadow catcher."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field

from rna_render.model_base import Albedo, Model, Rgb, Share


class _ColouredModel(Model):
    color: Albedo = Field(default=(0.8, 0.8, 0.8), description="Linear; multiplies the texture.")
    texture: Path | None = Field(
        default=None,
        description="Image of the colour, sRGB, relative to the scene file; needs UVs.",
    )
    emission: Rgb = Field(
        default=(0.0, 0.0, 0.0), description="Radiance that it sends out by itself, W/(m^2 sr)."
    )


class DiffuseModel(_ColouredModel):
    """Lambert's material."""

    type: Literal["diffuse"] = Field(description="`diffuse`")


class ConductorModel(_ColouredModel):
    """A rough metal; `color` is its reflectance seen straight on."""

    type: Literal["conductor"] = Field(description="`conductor`")
    roughness: Share = Field(default=0.3, description="As in glTF: the square root of GGX's alpha.")


class CoatedModel(_ColouredModel):
    """A diffuse material below a rough dielectric surface, as painted or plastic things have."""

    type: Literal["coated"] = Field(description="`coated`")
    roughness: Share = Field(default=0.3, description="As in glTF: the square root of GGX's alpha.")
    ior: float = Field(default=1.5, ge=1, le=4, description="Index of refraction of the coat.")


class ShadowCatcherModel(Model):
    """Seen by the camera alone; it shows nothing but the shadows that fall on it, as alpha."""

    type: Literal["shadow_catcher"] = Field(description="`shadow_catcher`")


MaterialModel = Annotated[
    DiffuseModel | ConductorModel | CoatedModel | ShadowCatcherModel, Field(discriminator="type")
]
