"""Normals with the relief of a part's normal maps: spec/RNA.md, 4.5.

`rna_sdk.runtime.normal_maps` says the same in numpy and is what tests compare with.
"""

from collections.abc import Sequence
from copy import copy

import numpy as np

from rna_sdk.machine.compiled import compiled
from rna_sdk.package import Mesh, NormalMap, Transmittance
from rna_trace.bilinear import REPEAT, texels_around
from rna_trace.vectors import Vector, cross, dot, minus, plus, unit, vector_at


def texture_numbers(mesh: Mesh, records: Sequence[NormalMap | Transmittance]) -> np.ndarray:
    """(t,) int32, the place of each triangle's record; -1 for none."""
    number = np.full(len(mesh.triangles), -1, np.int32)
    for k, record in enumerate(records):
        number[record.first : record.first + record.count] = k
    return number


class NormalMaps:
    """The normal maps of a mesh with texture coordinates, ready to be looked up; one at least."""

    def __init__(self, mesh: Mesh, maps: Sequence[NormalMap]) -> None:
        assert mesh.uvs is not None  # the format asks for them
        self._mesh = mesh.positions, mesh.uvs, mesh.triangles
        self._number = texture_numbers(mesh, maps)
        self._texels = np.concatenate([record.texture.reshape(-1, 2) for record in maps])
        sizes = [record.texture.shape[:2] for record in maps]
        starts = np.cumsum([0, *(h * w for h, w in sizes)])[:-1]
        self._sizes = np.column_stack([starts, sizes]).astype(np.int64)

    def on(self, mesh: Mesh) -> "NormalMaps":
        """The same maps on a mesh in motion, with the same triangles and coordinates."""
        result = copy(self)
        result._mesh = mesh.positions, *self._mesh[1:]
        return result

    def at(self, n: np.ndarray, triangle: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The mapped normals, (m, 3) float32, unit.

        n: (m, 3) float32, interpolated normals. triangle, u, v: (m,), those of a hit.
        """
        result = np.empty_like(n)
        _mapped(n, triangle, u, v, *self._mesh, self._number, self._texels, self._sizes, result)
        return result


@compiled(fastmath=())
def derived_tangent(
    positions: np.ndarray, uvs: np.ndarray, corners: np.ndarray, n: Vector
) -> tuple[Vector, float]:
    """The direction of u on the triangle, and the sign that makes the bitangent go against v."""
    e1 = minus(vector_at(positions, corners[1]), vector_at(positions, corners[0]))
    e2 = minus(vector_at(positions, corners[2]), vector_at(positions, corners[0]))
    du1 = np.float64(uvs[corners[1], 0]) - uvs[corners[0], 0]
    dv1 = np.float64(uvs[corners[1], 1]) - uvs[corners[0], 1]
    du2 = np.float64(uvs[corners[2], 0]) - uvs[corners[0], 0]
    dv2 = np.float64(uvs[corners[2], 1]) - uvs[corners[0], 1]
    area = du1 * dv2 - du2 * dv1
    along_u = plus((dv2 * e1[0], dv2 * e1[1], dv2 * e1[2]), -dv1, e2)
    along_v = plus((du1 * e2[0], du1 * e2[1], du1 * e2[2]), -du2, e1)
    if area < 0.0:
        along_u = -along_u[0], -along_u[1], -along_u[2]
        along_v = -along_v[0], -along_v[1], -along_v[2]
    sign = -1.0 if dot(cross(n, along_u), along_v) > 0.0 else 1.0
    return along_u, (sign if area != 0.0 else 0.0)


@compiled(fastmath=())
def _decoded(value: float) -> float:
    return (value - 127.0) / 127.0


@compiled(fastmath=())
def _looked_up(
    texels: np.ndarray, start: int, height: int, width: int, s: float, t: float
) -> tuple[float, float]:
    """x and y of the map at texture coordinates (s, t); bilinear, repeated."""
    left, right, a = texels_around(s, width, REPEAT)
    upper, lower, b = texels_around(t, height, REPEAT)
    upper, lower = start + upper * width, start + lower * width
    corners = upper + left, upper + right, lower + left, lower + right
    weights = (1.0 - a) * (1.0 - b), a * (1.0 - b), (1.0 - a) * b, a * b
    x, y = 0.0, 0.0
    for k in range(4):
        x += weights[k] * texels[corners[k], 0]
        y += weights[k] * texels[corners[k], 1]
    return _decoded(x), _decoded(y)


@compiled(rows="n triangle u v result", fastmath=())
def _mapped(
    n: np.ndarray,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
    positions: np.ndarray,
    uvs: np.ndarray,
    triangles: np.ndarray,
    number: np.ndarray,
    texels: np.ndarray,
    sizes: np.ndarray,
    result: np.ndarray,
) -> None:
    for i in range(len(n)):
        k, m = number[triangle[i]], vector_at(n, i)
        bent = m
        if k >= 0:
            corners = triangles[triangle[i]]
            t, sign = derived_tangent(positions, uvs, corners, m)
            along = np.sqrt(dot(t, t))
            lean = dot(t, m)
            t = (t[0] - lean * m[0], t[1] - lean * m[1], t[2] - lean * m[2])
            length = np.sqrt(dot(t, t))
            if sign != 0.0 and length > 1e-6 * along:
                t = (t[0] / length, t[1] / length, t[2] / length)
                fu, fv = np.float64(u[i]), np.float64(v[i])
                s, r = 0.0, 0.0
                for c in range(3):
                    weight = 1.0 - fu - fv if c == 0 else (fu if c == 1 else fv)
                    s += weight * uvs[corners[c], 0]
                    r += weight * uvs[corners[c], 1]
                x, y = _looked_up(texels, sizes[k, 0], sizes[k, 1], sizes[k, 2], s, r)
                z = np.sqrt(max(0.0, 1.0 - x * x - y * y))
                y *= sign
                b = cross(m, t)
                total = (
                    x * t[0] + y * b[0] + z * m[0],
                    x * t[1] + y * b[1] + z * m[1],
                    x * t[2] + y * b[2] + z * m[2],
                )
                if dot(total, total) > 1e-12:
                    bent = unit(total)
        result[i, 0], result[i, 1], result[i, 2] = bent
