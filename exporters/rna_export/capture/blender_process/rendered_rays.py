"""What Cycles answers along rays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rna_export.capture.blender_axes import from_blender

_LOBES = ("Diffuse", "Glossy", "Transmission")

Passes = dict[str, np.ndarray]
"""Channels of a render, "Pass.C" -> (pixels,) float32."""


def needed_passes(has_fibers: bool) -> tuple[str, ...]:
    """Passes that `RenderedRays.of_passes` reads."""
    lobes = [f"{lobe} {kind}" for lobe in _LOBES for kind in ("Direct", "Color")]
    return "Combined", "Position", *(lobes if has_fibers else ())


@dataclass(frozen=True)
class RenderedRays:
    """One row a ray, float32.

    radiance: (n, 3) under irradiance 1. alpha: (n,), 1 for a hit. position: (n, 3) Cycles' own
    hits, object space. direct: (n, 3) the part of the radiance that scattered once, at the hit
    itself: without noise on fibers. None of a source without fibers. normal: (n, 3) Cycles' shading
    normals, object space; None where they were not asked for.
    """

    radiance: np.ndarray
    alpha: np.ndarray
    position: np.ndarray
    direct: np.ndarray | None
    normal: np.ndarray | None = None

    @classmethod
    def of_passes(cls, passes: Passes, n: int, has_fibers: bool) -> RenderedRays:
        """The first n pixels of a render with the passes of `needed_passes`."""
        rgba = channels(passes, "Combined", "RGBA")[:n]
        position = from_blender(channels(passes, "Position", "XYZ")[:n])
        direct = _direct(passes)[:n] if has_fibers else None
        normal = None
        if "Normal.X" in passes:
            normal = from_blender(channels(passes, "Normal", "XYZ")[:n])
        return cls(rgba[:, :3], rgba[:, 3], position, direct, normal)


def channels(passes: Passes, name: str, letters: str) -> np.ndarray:
    """Channels of a pass, (pixels, k) float32."""
    return np.stack([passes[f"{name}.{c}"] for c in letters], axis=-1)


def _direct(passes: Passes) -> np.ndarray:
    """Light of no bounce; Cycles divides each lobe's by its colour."""
    lobes = [
        channels(passes, f"{lobe} Direct", "RGB") * channels(passes, f"{lobe} Color", "RGB")
        for lobe in _LOBES
    ]
    diffuse, glossy, transmission = lobes
    return np.asarray(diffuse + glossy + transmission)
