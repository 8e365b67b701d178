"""Transmittance of triangles: textures, in tables that compiled code reads.

The light that leaves a hit is (1 - tau) times that of the surface plus tau times that from behind,
where tau is a texture's value, without its parts below a cutoff, times what a smooth interface
does not reflect.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from rna_sdk.arrays import check_numbers
from rna_sdk.machine.compiled import compiled
from rna_trace.bilinear import REPEAT, texels_around
from rna_trace.memory import load_f32, load_f64, load_i32, load_u8, load_u32, load_u64, signed
from rna_trace.vectors import Vector

# The table of a geometry, its user data in Embree, as 64-bit words: addresses, or 0 for none.
STRANDS, NUMBERS, TRIANGLES, UVS, NORMALS, TEXTURES = range(6)
GEOMETRY_WORDS = 6

# A texture in the table of textures, as 64-bit words; the last four are float64.
TEXELS, HEIGHT, WIDTH, CHANNELS, WRAP_U, WRAP_V, CUTOFF, FRONT, BACK, SCHLICK = range(10)
TEXTURE_WORDS = 10


@dataclass(frozen=True, slots=True, eq=False)
class TransmittanceTexture:
    """Transmittance over texture coordinates, looked up bilinearly in the image itself.

    texels: (h, w, 1) or (h, w, 3) uint8, the upper row, v = 0, first; 255 lets all light through.
    cutoff: each channel is 1 where its value is more than this, else 0; None to keep the value.
    wrap: what is outside [0, 1] in u and in v. ior: relative index of refraction of a smooth
    interface, as met from the side that the triangle's normal points to, and from the other; its
    exact, unpolarised reflectance is taken off. f0: the same by Schlick's approximation, for both
    sides. At most one of the two is given.
    """

    texels: np.ndarray
    cutoff: float | None = None
    wrap: tuple[int, int] = (REPEAT, REPEAT)
    ior: tuple[float, float] | None = None
    f0: float | None = None


class Transmittance:
    """The transmittance of a mesh's triangles, in memory that stays where it is.

    triangles: (t, 3) uint32. uvs: (v, 2) float32, finite. normals: (v, 3) float32, unit: those
    that reflectance is reckoned with. number: (t,) int32, the place of each triangle's texture in
    `textures`, or -1 where it is opaque.

    Attributes:
        address: of the geometry's table, valid as long as this object.
        coloured: whether a texture has three channels.
    """

    def __init__(
        self,
        triangles: np.ndarray,
        uvs: np.ndarray,
        normals: np.ndarray,
        number: np.ndarray,
        textures: Sequence[TransmittanceTexture],
    ) -> None:
        self._held: list[np.ndarray] = [
            np.ascontiguousarray(number, np.int32),
            np.ascontiguousarray(triangles, np.uint32),
            np.ascontiguousarray(uvs, np.float32),
            np.ascontiguousarray(normals, np.float32),
        ]
        self._texels = [np.ascontiguousarray(texture.texels, np.uint8) for texture in textures]
        rows = zip(textures, self._texels, strict=True)
        self._textures = np.array([_texture_row(*row) for row in rows], np.uint64)
        self._held.append(self._textures)
        self._table = geometry_table()
        self._table[NUMBERS:] = [array.ctypes.data for array in self._held]
        self.address: int = self._table.ctypes.data
        self.coloured = any(texels.shape[2] == 3 for texels in self._texels)

    def at(
        self,
        triangle: np.ndarray,
        u: np.ndarray,
        v: np.ndarray,
        directions: np.ndarray,
        facing: np.ndarray,
    ) -> np.ndarray:
        """The transmittance of hits by rays in the mesh's space: (n, 3) float32.

        triangle: (n,) int32, each within [0, t). u, v: (n,) float32, barycentrics. directions:
        (n, 3) float32, of the rays, of any length but zero. facing: (n,) bool, whether they meet
        the side that the geometric normal points to.
        """
        check_numbers("triangle", triangle, len(self._held[0]))
        result = np.empty((len(triangle), 3), np.float32)
        _at(self.address, triangle, u, v, directions, facing, result)
        return result


def geometry_table(strands: int = 0) -> np.ndarray:
    """The table of a geometry, (6,) uint64. strands: address of each segment's strand, uint32."""
    table = np.zeros(GEOMETRY_WORDS, np.uint64)
    table[STRANDS] = strands
    return table


def _texture_row(texture: TransmittanceTexture, texels: np.ndarray) -> np.ndarray:
    row = np.zeros(TEXTURE_WORDS, np.uint64)
    row[:CUTOFF] = [texels.ctypes.data, *texels.shape, *texture.wrap]
    front, back = texture.ior or (0.0, 0.0)
    cutoff = np.nan if texture.cutoff is None else texture.cutoff
    schlick = np.nan if texture.f0 is None else texture.f0
    row[CUTOFF:] = np.array([cutoff, front, back, schlick], np.float64).view(np.uint64)
    return row


@compiled(fastmath=())
def dielectric_reflectance(eta: float, cosine: float) -> float:
    """Unpolarised Fresnel reflectance of an interface of relative index eta."""
    squared = 1.0 - (1.0 - cosine * cosine) / (eta * eta)
    if squared <= 0.0:
        return 1.0
    root = np.sqrt(squared)
    s = (cosine - eta * root) / (cosine + eta * root)
    p = (eta * cosine - root) / (eta * cosine + root)
    return float(0.5 * (s * s + p * p))


@compiled(fastmath=())
def _mixed(
    values: Any, width: int, triangles: Any, triangle: int, u: float, v: float, axis: int
) -> float:
    """A number of the corners, at barycentrics. values: address of rows of that many float32."""
    corner = triangles + np.uint64(triangle) * np.uint64(12)
    place = np.uint64(width * 4), np.uint64(axis * 4)
    a = load_f32(values + np.uint64(load_u32(corner)) * place[0] + place[1])
    b = load_f32(values + np.uint64(load_u32(corner + np.uint64(4))) * place[0] + place[1])
    c = load_f32(values + np.uint64(load_u32(corner + np.uint64(8))) * place[0] + place[1])
    return float((1.0 - u - v) * a + u * b + v * c)


@compiled(fastmath=())
def _word(table: Any, number: int) -> np.uint64:
    return load_u64(table + np.uint64(8 * number))


@compiled(fastmath=())
def _texel(texture: Any, row: int, column: int, channel: int) -> float:
    width, channels = signed(_word(texture, WIDTH)), signed(_word(texture, CHANNELS))
    place = (row * width + column) * channels + min(channel, channels - 1)
    return load_u8(_word(texture, TEXELS) + np.uint64(place)) / 255.0


@compiled(fastmath=())
def _passed_interface(
    texture: Any, table: Any, triangle: int, u: float, v: float, direction: Vector, facing: bool
) -> float:
    """1 - F of the texture's interface; 1 where it has none."""
    schlick = load_f64(texture + np.uint64(8 * SCHLICK))
    eta = load_f64(texture + np.uint64(8 * (FRONT if facing else BACK)))
    if eta == 0.0 and np.isnan(schlick):
        return 1.0
    along, n2, d2 = 0.0, 0.0, 0.0
    for axis in range(3):
        normals, triangles = _word(table, NORMALS), _word(table, TRIANGLES)
        n = _mixed(normals, 3, triangles, triangle, u, v, axis)
        along += n * direction[axis]
        n2 += n * n
        d2 += direction[axis] * direction[axis]
    cosine = min(abs(along) / max(np.sqrt(n2 * d2), 1e-30), 1.0)
    if eta != 0.0:
        return 1.0 - dielectric_reflectance(eta, cosine)
    return float((1.0 - schlick) * (1.0 - (1.0 - cosine) ** 5))


@compiled(fastmath=())
def transmittance(
    table: Any, triangle: Any, u: float, v: float, direction: Vector, facing: bool
) -> Vector:
    """(red, green, blue) of a hit; (0, 0, 0) on an opaque triangle.

    table: address of the geometry's table, or 0. direction: of the ray, three float64. facing:
    whether it meets the side that the triangle's normal points to.
    """
    if table == np.uint64(0) or _word(table, NUMBERS) == np.uint64(0):
        return 0.0, 0.0, 0.0
    number = load_i32(_word(table, NUMBERS) + np.uint64(triangle) * np.uint64(4))
    if number < 0:
        return 0.0, 0.0, 0.0
    texture = _word(table, TEXTURES) + np.uint64(number) * np.uint64(8 * TEXTURE_WORDS)
    height, width = signed(_word(texture, HEIGHT)), signed(_word(texture, WIDTH))
    uvs, triangles = _word(table, UVS), _word(table, TRIANGLES)
    s = _mixed(uvs, 2, triangles, triangle, u, v, 0)
    t = _mixed(uvs, 2, triangles, triangle, u, v, 1)
    left, right, a = texels_around(s, width, signed(_word(texture, WRAP_U)))
    top, bottom, b = texels_around(t, height, signed(_word(texture, WRAP_V)))
    cutoff = load_f64(texture + np.uint64(8 * CUTOFF))
    passed = _passed_interface(texture, table, triangle, u, v, direction, facing)
    red, green, blue = 0.0, 0.0, 0.0
    for channel in range(3):
        upper = (1.0 - a) * _texel(texture, top, left, channel)
        upper += a * _texel(texture, top, right, channel)
        lower = (1.0 - a) * _texel(texture, bottom, left, channel)
        lower += a * _texel(texture, bottom, right, channel)
        value = (1.0 - b) * upper + b * lower
        if not np.isnan(cutoff):
            value = 1.0 if value > cutoff else 0.0
        value = min(value * passed, 1.0)
        if channel == 0:
            red = value
        elif channel == 1:
            green = value
        else:
            blue = value
    return red, green, blue


@compiled(rows="triangle u v directions facing result", fastmath=())
def _at(
    table: int,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
    directions: np.ndarray,
    facing: np.ndarray,
    result: np.ndarray,
) -> None:
    for i in range(len(triangle)):
        d = directions[i]
        direction = np.float64(d[0]), np.float64(d[1]), np.float64(d[2])
        at = triangle[i], np.float64(u[i]), np.float64(v[i])
        tau = transmittance(np.uint64(table), at[0], at[1], at[2], direction, facing[i])
        result[i, 0], result[i, 1], result[i, 2] = tau
