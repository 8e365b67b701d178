"""A stand-in material for a neural asset, estimated from its captured samples.

Surfaces: the base colour is the Lambertian albedo that fits the lit samples away from their
highlights best (least squares); the roughness that of the GGX lobe (Trowbridge and Reitz 1975)
that fits what is left best. Where the lobe reflects four times as much as the diffuse part, the
asset counts as metal with the lobe's colour. Strands: the albedo of a diffuser that would be as
bright on average; roughness 1.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from rna_export.capture.dataset.validation_view import is_lit
from rna_sdk.package.manifest.extensions import StandinMaterial

_ROWS = 400_000
_ROUGHNESS = np.linspace(0.1, 1.0, 19)
_METAL = 4.0  # times as much light from the lobe as from the diffuse part
_OFF_HIGHLIGHT = 0.85  # n.h below which GGX of usual roughness adds little


def standin_material(samples: Mapping[str, np.ndarray]) -> StandinMaterial:
    """The material for a part's captured samples, fields as in the dataset."""
    rows = np.random.default_rng(0).permutation(len(samples["radiance"]))[:_ROWS]
    picked = {name: values[rows].astype(np.float64) for name, values in samples.items()}
    if "normal" not in picked:
        colour = 4.0 * np.pi * picked["radiance"].mean(axis=0)
        return _material(colour, 1.0, metal=False)
    n, wo, wi = (picked[name] for name in ("normal", "wo", "wi"))
    cos_i, cos_o = _dots(n, wi), _dots(n, wo)
    lit = is_lit(picked["visible"]) & (cos_i > 0.1) & (cos_o > 0.1)
    halves = wi[lit] + wo[lit]
    halves /= np.maximum(np.linalg.norm(halves, axis=1, keepdims=True), 1e-9)
    cos_h, cos_i, cos_o = _dots(n[lit], halves), cos_i[lit], cos_o[lit]
    radiance = picked["radiance"][lit]
    away = cos_h < _OFF_HIGHLIGHT
    if not away.any():
        return _material(4.0 * np.pi * picked["radiance"].mean(axis=0), 1.0, metal=False)
    albedo = np.pi * _scale(cos_i[away], radiance[away])
    left = radiance - albedo / np.pi * cos_i[:, None]
    fits = [_fit(left, _ggx(cos_h, roughness) / (4.0 * cos_o)) for roughness in _ROUGHNESS]
    best = int(np.argmin([error for error, _ in fits]))
    reflectance = fits[best][1]
    metal = reflectance.mean() > _METAL * albedo.mean()
    return _material(reflectance if metal else albedo, float(_ROUGHNESS[best]), metal)


def _material(colour: np.ndarray, roughness: float, metal: bool) -> StandinMaterial:
    r, g, b = (round(float(c), 4) for c in np.clip(colour, 0.0, 1.0))
    return StandinMaterial(
        base_color=(r, g, b), roughness=round(roughness, 4), metallic=1.0 if metal else 0.0
    )


def _ggx(cos_h: np.ndarray, roughness: float) -> np.ndarray:
    """D of alpha = roughness^2, at the cosines n.h."""
    squared = roughness**4
    return squared / (np.pi * (1.0 + cos_h**2 * (squared - 1.0)) ** 2)


def _fit(left: np.ndarray, lobe: np.ndarray) -> tuple[float, np.ndarray]:
    """The squared error of the lobe's best colour, none of it negative, and that colour."""
    colour = np.maximum(_scale(lobe, left), 0.0)
    return float(np.mean((left - lobe[:, None] * colour) ** 2)), colour


def _scale(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """(3,) by which x (n,) is nearest to each column of y (n, 3)."""
    scale: np.ndarray = x @ y / np.maximum(x @ x, 1e-12)
    return scale


def _dots(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    dots: np.ndarray = np.einsum("ij,ij->i", a, b)
    return dots
