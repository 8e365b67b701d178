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

Both sides of a surface reflect alike. F0 = 0 is no coat at all: Lambert's material.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import prange

from rna_render.materials.ggx import (
    MIN_ALPHA,
    albedo_table,
    albedo_terms,
    distribution,
    mean_albedo_terms,
    reflected_density,
    sample_reflection,
    schlick,
    visibility,
)
from rna_sdk.compiled import compiled

# A shading normal that faces away from the viewer, as interpolated ones do at silhouettes, is
# tilted until its cosine with wo is this.
MIN_COSINE = 1e-4


@dataclass(frozen=True, slots=True)
class Scattering:
    """Parameters of the material at n points.

    base_color: (n, 3) float32, in [0, 1]: albedo below the coat, or reflectance of the metal.
    alpha: (n,) float32, roughness^2; what is below MIN_ALPHA counts as MIN_ALPHA.
    metallic: (n,) float32, in [0, 1].
    coat_f0: (n,) float32, in [0, 1): reflectance of the coat seen straight on; 0 for no coat.
    emission: (n, 3) float32, radiance to both sides, W/(m^2 sr).

    The methods take unit vectors, float32, in one space: n and ng, (n, 3), the shading and the
    geometric normal, of either sign; wo, (n, 3), to the viewer; wi, (k, 3), to the light. row: (k,)
    which points they are for; None for all, in order. The shading normal is turned to the side of
    the surface that wo is on; a zero one is replaced by ng.
    """

    base_color: np.ndarray
    alpha: np.ndarray
    metallic: np.ndarray
    coat_f0: np.ndarray
    emission: np.ndarray

    def evaluate(
        self,
        n: np.ndarray,
        ng: np.ndarray,
        wo: np.ndarray,
        wi: np.ndarray,
        row: np.ndarray | None = None,
    ) -> np.ndarray:
        """f(wo, wi) |n.wi|: (k, 3) float32; 0 for a wi behind the shading normal or on the other
        side of the surface than wo."""
        result = np.empty((len(wi), 3), np.float32)
        at = _rows(row, wo), n, ng, wo, wi
        _evaluate(*self._parameters(), *albedo_table(), *at, result)
        return result

    def sample(
        self,
        n: np.ndarray,
        ng: np.ndarray,
        wo: np.ndarray,
        u: np.ndarray,
        row: np.ndarray | None = None,
    ) -> np.ndarray:
        """Unit directions wi, (k, 3) float32, with density `pdf`; a pure function of u.

        u: (k, 3) float64 in [0, 1). The third number chooses between the cosine about the normal
        and reflection at a visible microfacet, in proportion to their albedos. Some wi are
        behind the surface, where `evaluate` is 0.
        """
        wi = np.empty((len(u), 3), np.float32)
        at = _rows(row, wo), n, ng, wo, u
        _sample(*self._parameters(), *albedo_table(), *at, wi)
        return wi

    def pdf(
        self,
        n: np.ndarray,
        ng: np.ndarray,
        wo: np.ndarray,
        wi: np.ndarray,
        row: np.ndarray | None = None,
    ) -> np.ndarray:
        """Density of `sample` in wi, per steradian: (k,) float32; it integrates to 1 over the
        whole sphere."""
        result = np.empty(len(wi), np.float32)
        at = _rows(row, wo), n, ng, wo, wi
        _pdf(*self._parameters(), *albedo_table(), *at, result)
        return result

    def _parameters(self):
        return self.base_color, self.alpha, self.metallic, self.coat_f0


def _rows(row: np.ndarray | None, points: np.ndarray) -> np.ndarray:
    return np.arange(len(points)) if row is None else row


@compiled(fastmath=())
def _row(vectors, i):
    return np.float64(vectors[i, 0]), np.float64(vectors[i, 1]), np.float64(vectors[i, 2])


@compiled(fastmath=())
def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@compiled(fastmath=())
def _unit(a):
    length = np.sqrt(_dot(a, a))
    scale = 1.0 / length if length > 0.0 else 0.0
    return a[0] * scale, a[1] * scale, a[2] * scale


@compiled(fastmath=())
def _turned_normal(n, ng, o):
    """The unit shading normal on wo's side of the surface, with at least MIN_COSINE to wo."""
    side = _dot(ng, o)
    m = n if _dot(n, n) > 0.0 else ng
    m = _unit(m) if _dot(m, m) > 0.0 else o
    away = _dot(m, ng) * side if side != 0.0 else _dot(m, o)
    if away < 0.0:
        m = (-m[0], -m[1], -m[2])
    missing = MIN_COSINE - _dot(m, o)
    if missing > 0.0:
        m = _unit((m[0] + missing * o[0], m[1] + missing * o[1], m[2] + missing * o[2]))
    return m


@compiled(fastmath=())
def _half_cosines(m, o, i):
    """Cosines of the half vector with the normal and with wo; (0, 0) where there is none."""
    h = (o[0] + i[0], o[1] + i[1], o[2] + i[2])
    length = np.sqrt(_dot(h, h))
    if length < 1e-12:
        return 0.0, 0.0
    return min(_dot(m, h) / length, 1.0), _dot(o, h) / length


@compiled(fastmath=())
def _coat_albedo(coat_f0, a, b):
    return coat_f0 * a + b if coat_f0 > 0.0 else 0.0


@compiled(fastmath=())
def _specular_share(base, alpha, metallic, coat_f0, table, cos_o):
    """Part of the samples for the microfacets: their part of the albedo, mean of the colours."""
    if metallic == 0.0 and coat_f0 == 0.0:
        return 0.0
    mean = (base[0] + base[1] + base[2]) / 3.0
    a, b = albedo_terms(table, alpha, cos_o)
    coat = _coat_albedo(coat_f0, a, b)
    specular = metallic * (mean * a + b) + (1.0 - metallic) * coat
    diffuse = (1.0 - metallic) * mean * (1.0 - coat)
    return specular / (specular + diffuse) if specular > 0.0 else 0.0


@compiled(fastmath=())
def _density(m, o, i, alpha, share):
    nh, _ = _half_cosines(m, o, i)
    density = (1.0 - share) * max(0.0, _dot(m, i)) / np.pi
    if share > 0.0 and nh > 0.0:
        density += share * reflected_density(alpha, _dot(m, o), nh)
    return density


@compiled(parallel=True, fastmath=())
def _evaluate(base_color, alpha, metallic, coat_f0, table, mean, row, n, ng, wo, wi, result):
    for k in prange(len(wi)):
        p = row[k]
        g, o, i = _row(ng, p), _unit(_row(wo, p)), _unit(_row(wi, k))
        m = _turned_normal(_row(n, p), g, o)
        cos_o, cos_i = _dot(m, o), _dot(m, i)
        if _dot(g, o) * _dot(g, i) <= 0.0 or cos_i <= 0.0:
            result[k, 0], result[k, 1], result[k, 2] = 0.0, 0.0, 0.0
            continue
        metal, f0 = np.float64(metallic[p]), np.float64(coat_f0[p])
        below, surface, s, coat = 1.0, 0.0, 0.0, 0.0
        if metal > 0.0 or f0 > 0.0:  # else Lambert's material, which reflects no light as a mirror
            a = max(np.float64(alpha[p]), MIN_ALPHA)
            nh, oh = _half_cosines(m, o, i)
            surface = distribution(a, nh) * visibility(a, cos_o, cos_i)
            s = schlick(oh)
            coat = (f0 + (1.0 - f0) * s) if f0 > 0.0 else 0.0
            ao, bo = albedo_terms(table, a, cos_o)
            ai, bi = albedo_terms(table, a, cos_i)
            am, bm = mean_albedo_terms(mean, a)
            below = (1.0 - _coat_albedo(f0, ao, bo)) * (1.0 - _coat_albedo(f0, ai, bi))
            below /= max(1.0 - _coat_albedo(f0, am, bm), 1e-9)
        for c in range(3):
            base = np.float64(base_color[p, c])
            mirror = metal * (base + (1.0 - base) * s) + (1.0 - metal) * coat
            f = mirror * surface + (1.0 - metal) * base / np.pi * below
            result[k, c] = f * cos_i


@compiled(parallel=True, fastmath=())
def _sample(base_color, alpha, metallic, coat_f0, table, mean, row, n, ng, wo, u, wi):
    for k in prange(len(wi)):
        p = row[k]
        o = _unit(_row(wo, p))
        x, y, z = _turned_normal(_row(n, p), _row(ng, p), o)
        a = max(np.float64(alpha[p]), MIN_ALPHA)
        # Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6(1), 2017).
        sign = np.copysign(1.0, z)
        c = -1.0 / (sign + z)
        d = x * y * c
        s = (1.0 + sign * x * x * c, sign * d, -sign * x)
        t = (d, sign + y * y * c, -y)
        ox, oy, oz = _dot(s, o), _dot(t, o), _dot((x, y, z), o)
        share = _specular_share(_row(base_color, p), a, metallic[p], coat_f0[p], table, oz)
        if u[k, 2] < share:
            ix, iy, iz = sample_reflection(a, ox, oy, oz, u[k, 0], u[k, 1])
        else:
            iz = np.sqrt(1.0 - u[k, 0])
            radius, phi = np.sqrt(u[k, 0]), 2.0 * np.pi * u[k, 1]
            ix, iy = radius * np.cos(phi), radius * np.sin(phi)
        wi[k, 0] = ix * s[0] + iy * t[0] + iz * x
        wi[k, 1] = ix * s[1] + iy * t[1] + iz * y
        wi[k, 2] = ix * s[2] + iy * t[2] + iz * z


@compiled(parallel=True, fastmath=())
def _pdf(base_color, alpha, metallic, coat_f0, table, mean, row, n, ng, wo, wi, result):
    for k in prange(len(wi)):
        p = row[k]
        o, i = _unit(_row(wo, p)), _unit(_row(wi, k))
        m = _turned_normal(_row(n, p), _row(ng, p), o)
        a, base = max(np.float64(alpha[p]), MIN_ALPHA), _row(base_color, p)
        share = _specular_share(base, a, metallic[p], coat_f0[p], table, _dot(m, o))
        result[k] = _density(m, o, i, a, share)
