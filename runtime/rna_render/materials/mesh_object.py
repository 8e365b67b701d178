"""A mesh that is not neural, with its materials."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numba import prange

from rna_render.materials.bsdf import Scattering
from rna_render.materials.ggx import MIN_ALPHA
from rna_render.materials.material import Material
from rna_render.materials.textures import Texture
from rna_sdk.compiled import compiled

# Luminance of linear sRGB: ITU-R BT.709-6, section 3.2.
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])

# Parts of each side of a triangle when it is divided to estimate what a texture makes it emit,
# and the part of the texture's mean that is added: small bright spots may miss all points, and a
# triangle that counts as black would never be chosen.
EMISSION_DIVISIONS = 4
EMISSION_FLOOR = 0.05


@dataclass(frozen=True, eq=False)
class MeshObject:
    """A mesh, and what each of its triangles is made of.

    positions, normals: (v, 3) float32; normals are unit, or 0 where the file's are unusable.
    uvs: (v, 2) float32, (0, 0) the upper left corner of images; None if no part has any.
    triangles: (t, 3) uint32, counter-clockwise seen from the front.
    material_numbers: (t,) int32, places in `materials`.
    materials: at least one.
    catches_shadows: it shows nothing but the shadows on it, and its materials mean nothing.
    """

    positions: np.ndarray
    normals: np.ndarray
    uvs: np.ndarray | None
    triangles: np.ndarray
    material_numbers: np.ndarray
    materials: tuple[Material, ...]
    catches_shadows: bool = False

    def scattering(self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray) -> Scattering:
        """The material at barycentrics (u, v) of the given triangles.

        triangle: (n,) int32, each within [0, t). u, v: (n,) float32. glTF 2.0, section 3.9.2:
        textures multiply the factors.
        """
        number, uv = self.material_numbers[triangle], self._uv(triangle, u, v)
        base_color = self._factors["base_color"][number]
        metallic = self._factors["metallic"][number]
        roughness = self._factors["roughness"][number]
        for row, texture in self._textured("base_color_texture", number):
            base_color[row] *= texture.lookup(uv[row])
        for row, texture in self._textured("metallic_roughness_texture", number):
            values = texture.lookup(uv[row])
            roughness[row] *= values[:, 1]
            metallic[row] *= values[:, 2]
        alpha = np.maximum(roughness * roughness, np.float32(MIN_ALPHA))
        coat_f0 = self._factors["coat_f0"][number]
        return Scattering(base_color, alpha, metallic, coat_f0, self._emission(number, uv))

    def emission(self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray:
        """Radiance to both sides, (n, 3) float32, W/(m^2 sr); arguments as in `scattering`."""
        return self._emission(self.material_numbers[triangle], self._uv(triangle, u, v))

    def _emission(self, number: np.ndarray, uv: np.ndarray) -> np.ndarray:
        emission = self._factors["emission"][number]
        for row, texture in self._textured("emission_texture", number):
            emission[row] *= texture.lookup(uv[row])
        return emission

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
            at = np.full(len(row), u, np.float32), np.full(len(row), v, np.float32)
            part = self.emission(row, *at) @ LUMINANCE
            luminance[row] += (1 - EMISSION_FLOOR) / len(points) * part
        return luminance.astype(np.float32)

    @cached_property
    def _factors(self) -> dict[str, np.ndarray]:
        names = "base_color", "metallic", "roughness", "coat_f0", "emission"
        return {
            name: np.array([getattr(material, name) for material in self.materials], np.float32)
            for name in names
        }

    def _textured(self, name: str, number: np.ndarray) -> Iterator[tuple[np.ndarray, Texture]]:
        """Rows that share a texture, and the texture."""
        textures = [getattr(material, name) for material in self.materials]
        if any(texture is not None for texture in textures):
            for place in np.flatnonzero(np.bincount(number)):
                if textures[place] is not None:
                    yield np.flatnonzero(number == place), textures[place]

    def _uv(self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray:
        """Texture coordinates, (n, 2) float32; 0 where no material has use for them."""
        uv = np.zeros((len(triangle), 2), np.float32)
        if self.uvs is not None and any(material.has_textures for material in self.materials):
            _interpolate(self.uvs, self.triangles, triangle, u, v, uv)
        return uv


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


@compiled(parallel=True, fastmath=())
def _interpolate(uvs, triangles, triangle, u, v, result):
    for i in prange(len(triangle)):
        row = triangle[i]
        a, b, c = triangles[row, 0], triangles[row, 1], triangles[row, 2]
        fu, fv = np.float64(u[i]), np.float64(v[i])
        for axis in range(2):
            value = (1.0 - fu - fv) * uvs[a, axis] + fu * uvs[b, axis] + fv * uvs[c, axis]
            result[i, axis] = value
