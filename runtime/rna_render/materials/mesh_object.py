"""A mesh that is not neural, with its materials."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from rna_render.materials.bumps import bumped_normals
from rna_render.materials.ggx import MIN_ALPHA
from rna_render.materials.material import Material
from rna_render.materials.scattering import ClearCoat, Scattering
from rna_render.materials.textures import Texture
from rna_render.materials.transmission import object_transmittance
from rna_trace.surface import interpolate, interpolate_normals
from rna_trace.transmittance import Transmittance

# Luminance of linear sRGB: ITU-R BT.709-6, section 3.2.
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])

# Parts of each side of a triangle when it is divided to estimate what a texture makes it emit,
# and the part of the texture's mean that is added: small bright spots may miss all points, and a
# triangle that counts as black would never be chosen.
EMISSION_DIVISIONS = 4
EMISSION_FLOOR = 0.05


@dataclass(frozen=True, eq=False)
class MeshObject:
    """A mesh, and the material of each of its triangles.

    positions, normals: (v, 3) float32; normals are unit, or 0 where the file's are unusable.
    uvs: (v, 2) float32, (0, 0) the upper left corner of images; None if no part has any.
    triangles: (t, 3) uint32, counter-clockwise seen from the front.
    material_numbers: (t,) int32, places in `materials`.
    materials: at least one.
    catches_shadows: it shows nothing but the shadows on it, and its materials mean nothing.
    second_uvs: as uvs, of textures that ask for them. tangents: (v, 4) float32, unit, towards +u,
    with the sign of the bitangent; 0 or None where they follow from the texture coordinates.
    colors: (v, 3) float32, linear, factors of the base colour; None for 1.

    Attributes:
        transmittance: of its triangles; None if they are all opaque.
    """

    positions: np.ndarray
    normals: np.ndarray
    uvs: np.ndarray | None
    triangles: np.ndarray
    material_numbers: np.ndarray
    materials: tuple[Material, ...]
    catches_shadows: bool = False
    second_uvs: np.ndarray | None = None
    tangents: np.ndarray | None = None
    colors: np.ndarray | None = None
    transmittance: Transmittance | None = field(init=False)
    _factors: dict[str, np.ndarray] = field(init=False)

    def __post_init__(self) -> None:
        # Rays read the tables of transmittance by address, in all threads: made once, before them.
        object.__setattr__(self, "transmittance", object_transmittance(self))
        object.__setattr__(self, "_factors", _factors_of(self.materials))

    def uv_set(self, number: int) -> np.ndarray:
        """The first or the second texture coordinates; they exist where a texture uses them."""
        uvs = self.second_uvs if number else self.uvs
        assert uvs is not None
        return uvs

    def scattering(self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray) -> Scattering:
        """The material at barycentrics (u, v) of the given triangles.

        triangle: (n,) int32, each within [0, t). u, v: (n,) float32 or float64. glTF 2.0, section
        3.9.2: textures multiply the factors.
        """
        number = self.material_numbers[triangle]
        base_color = self._factors["base_color"][number]
        metallic = self._factors["metallic"][number]
        roughness = self._factors["roughness"][number]
        for row, values in self._looked_up("base_color_texture", number, triangle, u, v):
            base_color[row] *= values
        if self.colors is not None:
            base_color *= interpolate(self.colors, self.triangles, triangle, u, v)
        texture = "metallic_roughness_texture"
        for row, values in self._looked_up(texture, number, triangle, u, v):
            roughness[row] *= values[:, 1]
            metallic[row] *= values[:, 2]
        alpha = np.maximum(roughness * roughness, np.float32(MIN_ALPHA))
        coat_f0 = self._factors["coat_f0"][number]
        return Scattering(
            base_color,
            alpha,
            metallic,
            coat_f0,
            self._emission(number, triangle, u, v),
            self._weights(number, triangle, u, v),
            self._clear_coat(number, triangle, u, v),
        )

    def shading_normals(
        self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray, ng: np.ndarray, wo: np.ndarray
    ) -> np.ndarray:
        """Unit normals with the relief of normal textures, (n, 3) float32, not turned to wo.

        ng, wo: (n, 3) float32, unit, geometric normals and directions to the viewer. The others
        are those of `scattering`.
        """
        n = interpolate_normals(self.normals, self.triangles, triangle, u, v)
        number = self.material_numbers[triangle]
        for row, values in self._looked_up("normal_texture", number, triangle, u, v):
            material = self.materials[number[row[0]]]
            uvs = self.uv_set(material.normal_texture.uv_set)
            mesh, hits = (self.positions, uvs, self.tangents, self.triangles), (triangle, u, v)
            t, a, b, m, g, o = (values_at.take(row, axis=0) for values_at in (*hits, n, ng, wo))
            scale = material.normal_scale
            n[row] = bumped_normals(values, scale, mesh, (t, a, b), m, g, o)
        return n

    def base_share(
        self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray, ng: np.ndarray, wo: np.ndarray
    ) -> np.ndarray | None:
        """Fraction of rays that end at hits, by which scattered light is divided:
        (n, 3) float32, or None for 1.

        Less than 1 on thin glass, which scatters all the more of what does not go through; see
        `transmission`. Arguments are those of `shading_normals`.
        """
        if self.transmittance is None or not self._factors["transmission"].any():
            return None
        row = np.flatnonzero(self._factors["transmission"][self.material_numbers[triangle]])
        facing = np.sum(ng[row] * wo[row], axis=1) > 0
        result = np.ones((len(triangle), 3), np.float32)
        transmitted = self.transmittance.at(
            triangle[row],
            u[row].astype(np.float32),
            v[row].astype(np.float32),
            wo[row],
            facing,
        )
        result[row] = np.maximum(1 - transmitted, np.float32(1e-6))
        return result

    def emission(self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray:
        """Radiance to both sides, (n, 3) float32, W/(m^2 sr); arguments as in `scattering`.

        Of the surface itself, where it lets light through.
        """
        return self._emission(self.material_numbers[triangle], triangle, u, v)

    def opaque_emission(self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray:
        """`emission` times the share of the surface that is there."""
        radiance = self.emission(triangle, u, v)
        if self.transmittance is not None:
            d, thin = np.ones((len(triangle), 3), np.float32), np.ones(len(triangle), bool)
            radiance *= 1.0 - self.transmittance.at(triangle, u, v, d, thin)
        return radiance

    def _emission(
        self, number: np.ndarray, triangle: np.ndarray, u: np.ndarray, v: np.ndarray
    ) -> np.ndarray:
        emission: np.ndarray = self._factors["emission"][number]
        for row, values in self._looked_up("emission_texture", number, triangle, u, v):
            emission[row] *= values
        return emission

    def _weights(
        self, number: np.ndarray, triangle: np.ndarray, u: np.ndarray, v: np.ndarray
    ) -> np.ndarray | None:
        """Weights of the coat and of the diffuse part: `Scattering.weights`."""
        if (self._factors["coat_weight"] == 1).all() and not self._factors["transmission"].any():
            return None
        coat = self._factors["coat_weight"][number]
        transmission = self._factors["transmission"][number]
        for row, values in self._looked_up("coat_weight_texture", number, triangle, u, v):
            coat[row] *= values[:, 0]
        for row, values in self._looked_up("transmission_texture", number, triangle, u, v):
            transmission[row] *= values[:, 0]
        return np.column_stack([coat, 1 - transmission])

    def _clear_coat(
        self, number: np.ndarray, triangle: np.ndarray, u: np.ndarray, v: np.ndarray
    ) -> ClearCoat | None:
        if not self._factors["clear_coat"].any():
            return None
        weight = self._factors["clear_coat"][number]
        roughness = self._factors["clear_coat_roughness"][number]
        for row, values in self._looked_up("clear_coat_texture", number, triangle, u, v):
            weight[row] *= values[:, 0]
        for row, values in self._looked_up("clear_coat_roughness_texture", number, triangle, u, v):
            roughness[row] *= values[:, 1]
        n = interpolate_normals(self.normals, self.triangles, triangle, u, v)
        return ClearCoat(weight, roughness * roughness, n)

    @cached_property
    def solid_ior(self) -> np.ndarray:
        """Index of refraction of each material, (m,) float64; 0 without solid glass."""
        insides = (material.inside for material in self.materials)
        return np.array([0.0 if inside is None else inside.ior for inside in insides])

    @cached_property
    def solid_absorption(self) -> np.ndarray:
        """Absorption of each material's inside, (m, 3) float64, 1/m."""
        insides = (material.inside for material in self.materials)
        return np.array([(0.0,) * 3 if i is None else i.absorption for i in insides])

    @cached_property
    def solid_tint(self) -> np.ndarray:
        """Transmitted share of light at each interface of solid glass, (m, 3) float64."""
        return np.array([material.base_color for material in self.materials], np.float64)

    @property
    def has_solid_glass(self) -> bool:
        """Whether any material is solid glass."""
        return bool(self.solid_ior.any()) and not self.catches_shadows

    @cached_property
    def is_emissive(self) -> bool:
        """Whether any triangle emits light."""
        return bool(np.any(self.emitted_luminance > 0))

    @cached_property
    def emitted_luminance(self) -> np.ndarray:
        """About the mean luminance of each triangle's emission, (t,) float32.

        Exact without a texture. With one, more than 0 on all triangles of a material that emits
        anywhere. A shadow catcher emits nothing.
        """
        if self.catches_shadows:
            return np.zeros(len(self.triangles), np.float32)
        radiance = np.array([_mean_emission(material) for material in self.materials])
        textured = np.array([material.emission_texture is not None for material in self.materials])
        known = radiance @ LUMINANCE
        luminance = known[self.material_numbers]
        row = np.flatnonzero(textured[self.material_numbers] & (luminance > 0)).astype(np.int32)
        luminance[row] *= EMISSION_FLOOR
        points = points_of_a_triangle(EMISSION_DIVISIONS)
        for u, v in points:
            b1, b2 = np.full(len(row), u, np.float32), np.full(len(row), v, np.float32)
            part = self.emission(row, b1, b2) @ LUMINANCE
            luminance[row] += (1 - EMISSION_FLOOR) / len(points) * part
        return np.asarray(luminance, np.float32)

    def _looked_up(
        self, name: str, number: np.ndarray, triangle: np.ndarray, u: np.ndarray, v: np.ndarray
    ) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Rows that share a texture, and its values there, (k, 3) float32."""
        textures: list[Texture | None] = [getattr(material, name) for material in self.materials]
        if any(texture is not None for texture in textures):
            for place in np.flatnonzero(np.bincount(number)):
                if (texture := textures[place]) is not None:
                    row = np.flatnonzero(number == place)
                    uvs = self.uv_set(texture.uv_set)
                    uv = interpolate(uvs, self.triangles, triangle[row], u[row], v[row])
                    yield row, texture.lookup(uv)


def _factors_of(materials: Sequence[Material]) -> dict[str, np.ndarray]:
    """The factors of all materials by name, a row each, float32."""
    names = ["base_color", "metallic", "roughness", "coat_f0", "coat_weight", "emission"]
    names += ["clear_coat", "clear_coat_roughness", "transmission"]
    return {
        name: np.array([getattr(material, name) for material in materials], np.float32)
        for name in names
    }


def points_of_a_triangle(k: int) -> list[tuple[float, float]]:
    """Barycentric centres of its k^2 equal parts."""
    third = 1 / 3
    upright = [(i + third, j + third) for i in range(k) for j in range(k - i)]
    inverted = [(i + 2 * third, j + 2 * third) for i in range(k) for j in range(k - i - 1)]
    return [(u / k, v / k) for u, v in upright + inverted]


def _mean_emission(material: Material) -> np.ndarray:
    """Mean radiance over the whole texture: (3,) float64."""
    texture = material.emission_texture
    return np.asarray(material.emission) * (1.0 if texture is None else texture.mean())
