"""Normals with the relief of a normal texture: glTF 2.0, sections 3.7.2.1 and 3.9.3.

Tangents are the file's, interpolated; where there are none they follow from the texture
coordinates of each triangle, not from MikkTSpace, which smooths them over the corners.
"""

import numpy as np

from rna_sdk.machine.compiled import compiled
from rna_trace.normal_maps import derived_tangent
from rna_trace.vectors import Vector, cross, dot, plus, unit, vector_at

# A mirror direction keeps this cosine to the geometric normal, or 0.9 of wo's if that is less, as
# in Cycles: else relief that leans away from the viewer would mirror the inside of the surface.
MIN_MIRROR_COSINE = 0.01


def bumped_normals(
    texture: np.ndarray,
    scale: float,
    mesh: tuple[np.ndarray, np.ndarray, np.ndarray | None, np.ndarray],
    hits: tuple[np.ndarray, np.ndarray, np.ndarray],
    n: np.ndarray,
    ng: np.ndarray,
    wo: np.ndarray,
) -> np.ndarray:
    """Unit normals, (m, 3) float32, on the side that n is on.

    texture: (m, 3) float32 in [0, 1]. scale: of its x and y. mesh: positions, the texture's
    coordinates, tangents and triangles, as in MeshObject. hits: triangle, u and v, (m,) each.
    n, ng, wo: (m, 3) float32, unit: interpolated and geometric normals and directions to the
    viewer.
    """
    positions, uvs, tangents, triangles = mesh
    tangents = np.zeros((0, 4), np.float32) if tangents is None else tangents
    result = np.empty_like(n)
    _bump(texture, scale, positions, uvs, tangents, triangles, *hits, n, ng, wo, result)
    return result


@compiled(fastmath=())
def _given(tangents: np.ndarray, corners: np.ndarray, u: float, v: float) -> tuple[Vector, float]:
    """The interpolated tangent and its sign; a sign of 0 where a corner has none."""
    if len(tangents) == 0:
        return (0.0, 0.0, 0.0), 0.0
    t, sign = (0.0, 0.0, 0.0), float(tangents[corners[0], 3])
    for k in range(3):
        weight = 1.0 - u - v if k == 0 else (u if k == 1 else v)
        t = plus(t, weight, vector_at(tangents, corners[k]))
        sign = sign if tangents[corners[k], 3] != 0.0 else 0.0
    return t, sign


@compiled(fastmath=())
def _raised_above(m: Vector, g: Vector, o: Vector) -> Vector:
    """m, or the nearest normal that mirrors o above the surface; g is on o's side."""
    twice = 2.0 * dot(m, o)
    mirror = (twice * m[0] - o[0], twice * m[1] - o[1], twice * m[2] - o[2])
    missing = min(0.9 * dot(g, o), MIN_MIRROR_COSINE) - dot(g, mirror)
    if missing <= 0.0:
        return m
    return unit(plus(o, 1.0, unit(plus(mirror, missing, g))))


@compiled(fastmath=())
def bumped_normal(
    texel: Vector,
    scale: float,
    positions: np.ndarray,
    uvs: np.ndarray,
    tangents: np.ndarray,
    corners: np.ndarray,
    u: float,
    v: float,
    m: Vector,
    g: Vector,
    o: Vector,
) -> Vector:
    """The normal m with relief: three float64.

    texel: red, green, blue. tangents: (0, 4) where there are none. corners: of the triangle. g, o:
    geometric normal, and unit direction to the viewer.
    """
    t, sign = _given(tangents, corners, u, v)
    if sign == 0.0:
        t, sign = derived_tangent(positions, uvs, corners, m)
    t = unit(plus(t, -dot(t, m), m))
    x, y = scale * (2.0 * texel[0] - 1.0), scale * (2.0 * texel[1] - 1.0)
    z = 2.0 * texel[2] - 1.0
    if sign == 0.0 or dot(t, t) == 0.0:
        return m
    bent = unit(plus(plus((z * m[0], z * m[1], z * m[2]), x, t), y * sign, cross(m, t)))
    # All on the side of the surface that wo is on, and back.
    side = -1.0 if dot(g, o) < 0.0 else 1.0
    facing = side if dot(m, g) >= 0.0 else -side
    g = (side * g[0], side * g[1], side * g[2])
    bent = _raised_above((facing * bent[0], facing * bent[1], facing * bent[2]), g, o)
    return facing * bent[0], facing * bent[1], facing * bent[2]


@compiled(rows="texture triangle u v n ng wo result", fastmath=())
def _bump(
    texture: np.ndarray,
    scale: float,
    positions: np.ndarray,
    uvs: np.ndarray,
    tangents: np.ndarray,
    triangles: np.ndarray,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
    n: np.ndarray,
    ng: np.ndarray,
    wo: np.ndarray,
    result: np.ndarray,
) -> None:
    for i in range(len(n)):
        mesh = positions, uvs, tangents, triangles[triangle[i]]
        m, g, o = vector_at(n, i), vector_at(ng, i), unit(vector_at(wo, i))
        at = np.float64(u[i]), np.float64(v[i])
        texel = vector_at(texture, i)
        bent = bumped_normal(
            texel, scale, mesh[0], mesh[1], mesh[2], mesh[3], at[0], at[1], m, g, o
        )
        result[i, 0], result[i, 1], result[i, 2] = bent
