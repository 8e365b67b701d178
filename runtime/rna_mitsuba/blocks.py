"""Columns of decoder inputs in Dr.Jit: spec/RNA.md, 6.3, by the formulas for float32."""

from __future__ import annotations

import drjit as dr
import mitsuba as mi

from rna_mitsuba.vectors import components, half_vector, length, unit

_ETA = 1.55  # of the fiber in 6.3, fiber_lobes

Columns = list[mi.Float]


def surface_columns(
    inputs: tuple[str, ...],
    features: Columns,
    p: mi.Vector3f,
    n: mi.Vector3f,
    wo: mi.Vector3f,
    wi: mi.Vector3f,
) -> Columns:
    """The columns of the blocks named in `inputs`. n, wo, wi: unit; p: as Triplane.place."""
    makers = {
        "features": lambda: features,
        "position": lambda: components(2 * p - 1),
        "normal": lambda: components(n),
        "wo": lambda: components(wo),
        "wi": lambda: components(wi),
        "half_vector": lambda: _half_vector(n, wo, wi),
        "highlight": lambda: _highlight(n, wo, wi),
        "learned_normal": lambda: _learned_normal(n, features, wo, wi),
    }
    return [column for name in inputs for column in makers[name]()]


def fiber_columns(
    inputs: tuple[str, ...],
    features: Columns,
    p: mi.Vector3f,
    t: mi.Vector3f,
    h: mi.Float,
    wo: mi.Vector3f,
    wi: mi.Vector3f,
) -> Columns:
    """The columns of the blocks named in `inputs`. t, wo, wi: unit; h in [-1, 1]."""
    makers = {
        "features": lambda: features,
        "position": lambda: components(2 * p - 1),
        "tangent": lambda: components(t),
        "h": lambda: [h],
        "wo": lambda: components(wo),
        "wi": lambda: components(wi),
        "fiber_angles": lambda: _fiber_angles(t, wo, wi),
        "fiber_lobes": lambda: _fiber_lobes(t, h, wo, wi),
    }
    return [column for name in inputs for column in makers[name]()]


def _log_gap(n: mi.Vector3f, m: mi.Vector3f) -> mi.Float:
    """m: unit, or 0 for one across n."""
    off = n - m
    gap = dr.select(dr.all(m == 0), 1, dr.dot(off, off) / 2)
    return dr.log2(gap + 1e-4) / 6


def _half_vector(n: mi.Vector3f, wo: mi.Vector3f, wi: mi.Vector3f) -> Columns:
    m = half_vector(wo, wi)
    return [dr.dot(n, m), _log_gap(n, m), dr.dot(n, wi), dr.dot(n, wo), dr.dot(wi, m)]


def _highlight(n: mi.Vector3f, wo: mi.Vector3f, wi: mi.Vector3f) -> Columns:
    m = half_vector(wo, wi)
    across = dr.cross(n, m)
    square = dr.select(dr.all(m == 0), 1, dr.dot(across, across))
    return [dr.log2(square + 1e-8) / 12]


def _learned_normal(n: mi.Vector3f, features: Columns, wo: mi.Vector3f, wi: mi.Vector3f) -> Columns:
    first = [*features, 0, 0][:3]
    bent = n + 0.1 * mi.Vector3f(*first)
    q = dr.select(length(bent) < 1e-6, n, unit(bent))
    m = half_vector(wo, wi)
    return [dr.dot(q, m), _log_gap(q, m)]


def _azimuth(
    t: mi.Vector3f, wo: mi.Vector3f, wi: mi.Vector3f
) -> tuple[mi.Float, mi.Float, mi.Float]:
    """c_o, cos phi and sin phi; phi turns wo to wi about t."""
    o, i = dr.cross(t, wo), dr.cross(t, wi)
    c_o = length(o)
    d = c_o * length(i)
    along = d < 1e-6
    d = dr.select(along, 1, d)
    cosine = dr.clip(dr.dot(o, i) / d, -1, 1)
    sine = dr.clip(dr.dot(t, dr.cross(o, i)) / d, -1, 1)
    return c_o, dr.select(along, 1, cosine), dr.select(along, 0, sine)


def _fiber_angles(t: mi.Vector3f, wo: mi.Vector3f, wi: mi.Vector3f) -> Columns:
    s_o, s_i = dr.dot(t, wo), dr.dot(t, wi)
    cone = s_i + s_o
    _, cos_phi, sin_phi = _azimuth(t, wo, wi)
    return [s_i, s_o, cone, dr.log2(cone * cone + 1e-3) / 6, cos_phi, sin_phi]


def _fiber_lobes(t: mi.Vector3f, h: mi.Float, wo: mi.Vector3f, wi: mi.Vector3f) -> Columns:
    """Azimuths as complex numbers: each inner segment turns by -2 g_t - pi."""
    c_o, cos_phi, sin_phi = _azimuth(t, wo, wi)
    s_o = dr.dot(t, wo)
    turn = _doubled(h)
    inner = _doubled(h * c_o / dr.sqrt(_ETA * _ETA - s_o * s_o))
    columns = []
    for _ in range(3):
        columns.append(cos_phi * turn[0] + sin_phi * turn[1])
        turn = (-turn[0] * inner[0] - turn[1] * inner[1], turn[0] * inner[1] - turn[1] * inner[0])
    return columns


def _doubled(sine: mi.Float) -> tuple[mi.Float, mi.Float]:
    """Cosine and sine of twice the angle within 90 degrees that has this sine."""
    square = dr.maximum(0, (1 - sine) * (1 + sine))
    cosine = dr.select(square > 0, dr.sqrt(dr.select(square > 0, square, 1)), 0)
    return 1 - 2 * sine * sine, 2 * sine * cosine
