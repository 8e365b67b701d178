"""Material of a part of a mesh: factors and textures, as in glTF 2.0, section 3.9."""

from dataclasses import dataclass, fields, replace
from typing import assert_never

from rna_render.materials.textures import SRGB, Texture, read_texels
from rna_render.scene.material_models import (
    CoatedModel,
    ConductorModel,
    DiffuseModel,
    MaterialModel,
    ShadowCatcherModel,
)
from rna_render.scene.model_base import Vector


@dataclass(frozen=True, slots=True)
class Inside:
    """The inside of solid glass: its index of refraction, and its absorption, 1/m."""

    ior: float
    absorption: Vector


@dataclass(frozen=True, slots=True, eq=False)
class Material:
    """One material; each texture multiplies the factors it stands beside.

    base_color: linear, in [0, 1]. roughness: the square root of GGX's alpha. coat_f0, coat_weight:
    reflectance of the coat of what is not metallic, seen straight on, 0 for none, and how much of
    the coat there is. emission: radiance, W/(m^2 sr). clear_coat: weight of a second coat.
    transmission: share of what is not metallic nor reflected that goes straight through. opacity:
    share of light that meets the surface; with a cutoff all of it where opacity is at least that,
    else none.

    Channels of the textures: metallic in blue, roughness in green, coat weight, opacity, clear coat
    and transmission in red, roughness of the clear coat in green. normal_texture: normals in
    tangent space, +Y up in the image, (x, y) times normal_scale. inside: of solid glass, which
    refracts, with the base colour at each interface; None for thin walls.
    """

    base_color: Vector = (1.0, 1.0, 1.0)
    metallic: float = 0.0
    roughness: float = 1.0
    coat_f0: float = 0.0
    emission: Vector = (0.0, 0.0, 0.0)
    coat_weight: float = 1.0
    clear_coat: float = 0.0
    clear_coat_roughness: float = 0.0
    transmission: float = 0.0
    opacity: float = 1.0
    cutoff: float | None = None
    normal_scale: float = 1.0
    base_color_texture: Texture | None = None
    metallic_roughness_texture: Texture | None = None
    coat_weight_texture: Texture | None = None
    emission_texture: Texture | None = None
    clear_coat_texture: Texture | None = None
    clear_coat_roughness_texture: Texture | None = None
    transmission_texture: Texture | None = None
    opacity_texture: Texture | None = None
    normal_texture: Texture | None = None
    inside: Inside | None = None

    @property
    def textures(self) -> list[Texture]:
        values = (getattr(self, item.name) for item in fields(self))
        return [value for value in values if isinstance(value, Texture)]


def reflectance_of_ior(ior: float) -> float:
    """Reflectance of a surface between air and a dielectric, seen straight on."""
    return ((ior - 1.0) / (ior + 1.0)) ** 2


def make_material(model: MaterialModel) -> Material:
    """The material that a scene file describes.

    A shadow catcher is white and Lambertian here. Raises SceneError if its texture cannot be read.
    """
    if isinstance(model, ShadowCatcherModel):
        return Material()
    texture = None
    if model.texture is not None:
        texture = Texture(read_texels(model.texture, model.texture), SRGB)
    plain = Material(model.color, emission=model.emission, base_color_texture=texture)
    match model:
        case DiffuseModel():
            return plain
        case ConductorModel():
            return replace(plain, metallic=1.0, roughness=model.roughness)
        case CoatedModel():
            f0 = reflectance_of_ior(model.ior)
            return replace(plain, roughness=model.roughness, coat_f0=f0)
    assert_never(model)
