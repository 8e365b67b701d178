"""How points of a mesh reflect light: the metallic-roughness material of glTF 2.0.

Appendix B of the glTF 2.0 specification mixes a metal and a dielectric:

    f          = metallic * metal + (1 - metallic) * dielectric
    metal      = V D (base + (1 - base) s)
    dielectric = V D (F0 + (1 - F0) s) + base / pi * C

with GGX's D of alpha = roughness^2, Smith's V = G / (4 |n.wo| |n.wi|), and s = (1 - wo.h)^5.
Two things differ from the letter of the appendix:

- V is height-correlated, as in the Khronos sample renderer; the appendix separates it.
- The appendix weights the diffuse part by C = 1 - F(wo.h), which hands out more light than
  arrives: a white material reflects up to 1.9 times the light that grazes it. Here

      C = (1 - E(wo)) (1 - E(wi)) / (1 - E_mean),

  where E is the part that the coat reflects by itself. It is reciprocal, and a white material
  reflects exactly what arrives. Kelemen and Szirmay-Kalos, A Microfacet Based Coupled
  Specular-Matte BRDF Model with Importance Sampling (Eurographics 2001).

Both sides of a surface reflect alike. F0 = 0 is no coat at all: Lambert's material. Extensions
of glTF add to this:

- KHR_materials_specular multiplies the coat by a weight.
- KHR_materials_clearcoat puts a second coat, of F0 = 0.04, on all of it, with a normal of its own.
  With E_c the part that it reflects by itself, metal and dielectric coat below are multiplied by
  min(1 - E_c(wo), 1 - E_c(wi)), which is reciprocal and adds no light; of the diffuse part C is
  that of both coats together.
- KHR_materials_transmission takes a share off the diffuse part; see `transmission`.
"""

import numpy as np

from rna_render.materials.ggx import (
    MIN_ALPHA,
    distribution,
    reflected_density,
    sample_reflection,
    schlick,
    visibility,
)
from rna_render.materials.ggx_albedo import albedo_terms, albedo_views, mean_albedo_terms
from rna_sdk.machine.compiled import compiled
from rna_trace.angles import sine_and_cosine
from rna_trace.vectors import Vector, dot, half_cosines, tangents_of, turned_normal, unit, vector_at

# Reflectance of the clear coat seen straight on: KHR_materials_clearcoat, of index 1.5.
CLEAR_F0 = 0.04

# Points and weights of Gauss and Legendre for means over sqrt(cosine), weighted by 2 cosine.
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
_NODES = 0.5 * (_NODES + 1.0)
_WEIGHTS = 0.5 * _WEIGHTS * 4.0 * _NODES**3


Point = tuple[Vector, float, float, float, float, float, float, float]
"""The results of `bsdf_point`."""

Parameters = tuple[np.ndarray, ...]
"""Parameters of Scattering: an array per value of a point, and `ggx_albedo.ALBEDO_ADDRESSES`."""


@compiled(inline=True, fastmath=())
def bsdf_point(
    base: Vector,
    alpha: float,
    metallic: float,
    coat_f0: float,
    coat: float,
    diffuse: float,
    clear: float,
    clear_alpha: float,
) -> Point:
    """Parameters of a point for the functions below: base colour, three float64; alpha,
    metallic, F0; weights of coat and diffuse part; weight and alpha of the clear coat."""
    coat = coat if coat_f0 > 0.0 else 0.0
    alpha, clear_alpha = max(alpha, MIN_ALPHA), max(clear_alpha, MIN_ALPHA)
    return base, alpha, metallic, coat_f0, coat, diffuse, clear, clear_alpha


@compiled(inline=True, fastmath=())
def bsdf_frame(
    point: Point, n: Vector, clear_n: Vector, g: Vector, o: Vector
) -> tuple[Vector, Vector]:
    """The normals that a point scatters about: of its surface, and of its clear coat."""
    m = turned_normal(n, g, o)
    return m, (turned_normal(clear_n, g, o) if point[6] > 0.0 else m)


@compiled(inline=True, fastmath=())
def _row(
    parameters: Parameters, p: int, n: Vector, g: Vector, o: Vector
) -> tuple[Point, tuple[Vector, Vector]]:
    """The point of a row of Scattering's parameters, and its frame."""
    base_color, alpha, metallic, coat_f0, weights, clear, clear_alpha, clear_n = parameters[:8]
    q, r = min(p, len(weights) - 1), min(p, len(clear) - 1)
    point = bsdf_point(
        vector_at(base_color, p),
        np.float64(alpha[p]),
        np.float64(metallic[p]),
        np.float64(coat_f0[p]),
        np.float64(weights[q, 0]),
        np.float64(weights[q, 1]),
        np.float64(clear[r]),
        np.float64(clear_alpha[r]),
    )
    return point, bsdf_frame(point, n, vector_at(clear_n, r), g, o)


@compiled(fastmath=())
def _albedo(weight: float, f0: float, alpha: float, table: np.ndarray, cosine: float) -> float:
    """The part that a coat reflects by itself."""
    if weight == 0.0:
        return 0.0
    a, b = albedo_terms(table, alpha, cosine)
    return weight * (f0 * a + b)


@compiled(fastmath=())
def _mean_passed(point: Point, table: np.ndarray, mean: np.ndarray) -> float:
    """Mean transmittance of both coats."""
    _, alpha, _, f0, coat, _, clear, clear_alpha = point
    if clear == 0.0:
        a, b = mean_albedo_terms(mean, alpha)
        return 1.0 - coat * (f0 * a + b)
    result = 0.0
    for k in range(len(_NODES)):
        cosine = _NODES[k] * _NODES[k]
        passed = 1.0 - _albedo(coat, f0, alpha, table, cosine)
        passed *= 1.0 - _albedo(clear, CLEAR_F0, clear_alpha, table, cosine)
        result += _WEIGHTS[k] * passed
    return result


@compiled(inline=True, fastmath=())
def _shares(
    point: Point, table: np.ndarray, cos_o: float, clear_cos_o: float
) -> tuple[float, float]:
    """Parts of the samples for the clear coat and for the microfacets below it: their parts of the
    albedo, mean of the colours."""
    base, alpha, metallic, f0, coat_weight, diffuse_weight, clear, clear_alpha = point
    if metallic == 0.0 and coat_weight == 0.0 and clear == 0.0:
        return 0.0, 0.0
    mean = (base[0] + base[1] + base[2]) / 3.0
    a, b = albedo_terms(table, alpha, cos_o)
    coat = coat_weight * (f0 * a + b)
    specular = metallic * (mean * a + b) + (1.0 - metallic) * coat
    diffuse = (1.0 - metallic) * mean * (1.0 - coat) * diffuse_weight
    top = _albedo(clear, CLEAR_F0, clear_alpha, table, clear_cos_o)
    specular, diffuse = specular * (1.0 - top), diffuse * (1.0 - top)
    total = top + specular + diffuse
    return (top / total, specular / total) if total > 0.0 else (0.0, 0.0)


@compiled(fastmath=())
def _lobe(alpha: float, m: Vector, o: Vector, i: Vector) -> tuple[float, float]:
    """V D, and Schlick's weight, about the normal m."""
    nh, oh = half_cosines(m, o, i)
    surface = distribution(alpha, nh) * visibility(alpha, dot(m, o), dot(m, i))
    return surface, schlick(oh)


@compiled(inline=True, fastmath=())
def bsdf_value(
    point: Point,
    frame: tuple[Vector, Vector],
    g: Vector,
    o: Vector,
    i: Vector,
    table: np.ndarray,
    mean: np.ndarray,
) -> Vector:
    """f(o, i) |n.i|: red, green, blue. o, i: unit. frame: of `bsdf_frame`. table, mean: of
    `ggx_albedo.ALBEDO_TABLE`."""
    m, c = frame
    cos_o, cos_i = dot(m, o), max(dot(m, i), 0.0)
    if dot(g, o) * dot(g, i) <= 0.0 or (cos_i == 0.0 and point[6] == 0.0):
        return 0.0, 0.0, 0.0
    base, alpha, metal, f0, coat_weight, diffuse, clear, clear_alpha = point
    passed, surface, s, coat, below, top = 1.0, 0.0, 0.0, 0.0, diffuse, 0.0
    if clear > 0.0:
        clear_o, clear_i = dot(c, o), max(dot(c, i), 0.0)
        if clear_i > 0.0:
            lobe, weight = _lobe(clear_alpha, c, o, i)
            top = clear * lobe * (CLEAR_F0 + (1.0 - CLEAR_F0) * weight) * clear_i
        way_out = 1.0 - _albedo(clear, CLEAR_F0, clear_alpha, table, clear_o)
        way_in = 1.0 - _albedo(clear, CLEAR_F0, clear_alpha, table, clear_i)
        passed = min(way_out, way_in)
        below *= way_out * way_in
    if metal > 0.0 or coat_weight > 0.0 or clear > 0.0:  # else it is Lambert's
        surface, s = _lobe(alpha, m, o, i)
        coat = coat_weight * (f0 + (1.0 - f0) * s)
        below *= 1.0 - _albedo(coat_weight, f0, alpha, table, cos_o)
        below *= 1.0 - _albedo(coat_weight, f0, alpha, table, cos_i)
        below /= max(_mean_passed(point, table, mean), 1e-9)
    mirror = passed * surface
    diffuse_part = (1.0 - metal) / np.pi * below
    rest = (1.0 - metal) * coat
    r = mirror * (metal * (base[0] + (1.0 - base[0]) * s) + rest) + base[0] * diffuse_part
    g_ = mirror * (metal * (base[1] + (1.0 - base[1]) * s) + rest) + base[1] * diffuse_part
    b = mirror * (metal * (base[2] + (1.0 - base[2]) * s) + rest) + base[2] * diffuse_part
    return r * cos_i + top, g_ * cos_i + top, b * cos_i + top


@compiled(inline=True, fastmath=())
def bsdf_sample(
    point: Point,
    frame: tuple[Vector, Vector],
    o: Vector,
    u1: float,
    u2: float,
    u3: float,
    table: np.ndarray,
) -> Vector:
    """A direction, as often as `bsdf_density` says. u3: chooses the lobe."""
    m, c = frame
    clear, specular = _shares(point, table, dot(m, o), dot(c, o))
    axis = c if u3 < clear else m
    s, t = tangents_of(axis)
    if u3 < clear + specular:
        alpha = point[7] if u3 < clear else point[1]
        ix, iy, iz = sample_reflection(alpha, dot(s, o), dot(t, o), dot(axis, o), u1, u2)
    else:
        iz, radius = np.sqrt(1.0 - u1), np.sqrt(u1)
        sine, cosine = sine_and_cosine(u2)
        ix, iy = radius * cosine, radius * sine
    return (
        ix * s[0] + iy * t[0] + iz * axis[0],
        ix * s[1] + iy * t[1] + iz * axis[1],
        ix * s[2] + iy * t[2] + iz * axis[2],
    )


@compiled(inline=True, fastmath=())
def bsdf_density(
    point: Point, frame: tuple[Vector, Vector], o: Vector, i: Vector, table: np.ndarray
) -> float:
    """Density of `bsdf_sample` in i, per steradian."""
    m, c = frame
    clear, specular = _shares(point, table, dot(m, o), dot(c, o))
    density = (1.0 - clear - specular) * max(0.0, dot(m, i)) / np.pi
    if specular > 0.0:
        nh, _ = half_cosines(m, o, i)
        density += specular * reflected_density(point[1], dot(m, o), nh) if nh > 0.0 else 0.0
    if clear > 0.0:
        nh, _ = half_cosines(c, o, i)
        density += clear * reflected_density(point[7], dot(c, o), nh) if nh > 0.0 else 0.0
    return density


@compiled(fastmath=())
def scatter(
    parameters: Parameters,
    row: np.ndarray,
    n: np.ndarray,
    ng: np.ndarray,
    wo: np.ndarray,
    u: np.ndarray | None,
    wi: np.ndarray,
    value: np.ndarray | None,
    density: np.ndarray | None,
) -> None:
    """Fill directions wi sampled with u, unless that is None; then values and densities of wi.

    Compiled for each choice of what is None. Neighbours with the same row share what the functions
    above take for it.
    """
    table, mean = albedo_views(parameters[8])
    k = 0
    while k < len(wi):
        p = row[k]
        g, o = vector_at(ng, p), unit(vector_at(wo, p))
        point, frame = _row(parameters, p, vector_at(n, p), g, o)
        while k < len(wi) and row[k] == p:
            if u is not None:
                i = bsdf_sample(point, frame, o, u[k, 0], u[k, 1], u[k, 2], table)
                wi[k, 0], wi[k, 1], wi[k, 2] = i
            if value is not None:
                f = bsdf_value(point, frame, g, o, unit(vector_at(wi, k)), table, mean)
                value[k, 0], value[k, 1], value[k, 2] = f
            if density is not None:
                density[k] = bsdf_density(point, frame, o, unit(vector_at(wi, k)), table)
            k += 1
