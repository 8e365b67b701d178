"""Textures that Blender computes from a source's materials."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True)
class SeeThrough:
    """Transmittance of a material without refraction; as in rna_sdk.package.Transmittance."""

    texture: np.ndarray  # (h, w, 1 or 3) uint8
    cutoff: float | None
    ior: tuple[float, float] | None


@dataclass(frozen=True)
class MaterialTextures:
    """Textures by the full name of their material.

    see_through: holes and thin glass. normals: normal maps, (h, w, 2) uint8 as in a package.
    charts: the texture coordinates that they are looked up at (see `uv_charts.py`). captured_holes:
    whether light through some material has no texture and is part of its captured light.
    learnt_relief: whether some relief has none. notes: for the user.
    """

    see_through: dict[str, SeeThrough]
    normals: dict[str, np.ndarray]
    charts: dict[str, Any]
    captured_holes: bool
    learnt_relief: bool
    notes: list[str]
