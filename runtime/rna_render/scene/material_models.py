"""The scene file's schema of materials: materials of glTF 2.0, and the shadow catcher."""

from typing import Annotated, Literal

from pydantic import Field

from rna_render.scene.model_base import Albedo, FilePath, Model, Real, Rgb, Share


class _ColouredModel(Model):
    color: Albedo = Field(
        default=(0.8, 0.8, 0.8), description="Base colour, linear; multiplies the texture."
    )
    texture: FilePath | None = Field(
        default=None,
        description="Base colour texture, sRGB, relative to the scene file; needs UVs.",
    )
    emission: Rgb = Field(default=(0.0, 0.0, 0.0), description="Emitted radiance, W/(m^2 sr).")


class DiffuseModel(_ColouredModel):
    """A Lambertian material."""

    type: Literal["diffuse"] = Field(description="`diffuse`")


class ConductorModel(_ColouredModel):
    """A rough metal; `color` is its reflectance at normal incidence."""

    type: Literal["conductor"] = Field(description="`conductor`")
    roughness: Share = Field(default=0.3, description="As in glTF: the square root of GGX's alpha.")


class CoatedModel(_ColouredModel):
    """A diffuse base under a rough dielectric coat, such as paint or plastic."""

    type: Literal["coated"] = Field(description="`coated`")
    roughness: Share = Field(default=0.3, description="As in glTF: the square root of GGX's alpha.")
    ior: Real = Field(default=1.5, ge=1, le=4, description="Index of refraction of the coat.")


class ShadowCatcherModel(Model):
    """Visible to camera rays only; shows received shadows as alpha, and nothing else."""

    type: Literal["shadow_catcher"] = Field(description="`shadow_catcher`")


MaterialModel = Annotated[
    DiffuseModel | ConductorModel | CoatedModel | ShadowCatcherModel, Field(discriminator="type")
]
