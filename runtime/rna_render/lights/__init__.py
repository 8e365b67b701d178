"""Lights: what a scene file says of them (`models`), and what the integrator knows of them.

The names below are loaded when they are asked for, so that a scene file's models need no Embree.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rna_sdk.lazy_face import lazy_face

if TYPE_CHECKING:
    from rna_render.lights.asset import AssetEmission, AssetLight
    from rna_render.lights.base import (
        InfiniteLight,
        Light,
        LightSamples,
        PlacedLight,
        ShapeLight,
    )
    from rna_render.lights.directions import LUMINANCE
    from rna_render.lights.environment import EnvironmentImageLight, EnvironmentLight
    from rna_render.lights.equirectangular import EquirectangularImage
    from rna_render.lights.kinds import LIGHT_ROWS, ROW_NUMBERS, row_places
    from rna_render.lights.mesh import MeshLight
    from rna_render.lights.selection import LightSelection
    from rna_render.lights.split.bright_directions import (
        SplitEnvironment,
        cell_directions,
        split_environment,
    )
    from rna_render.lights.split.prefilter import PrefilteredEnvironment
    from rna_render.lights.table import make_light

__all__ = [
    "LIGHT_ROWS",
    "LUMINANCE",
    "ROW_NUMBERS",
    "AssetEmission",
    "AssetLight",
    "EnvironmentImageLight",
    "EnvironmentLight",
    "EquirectangularImage",
    "InfiniteLight",
    "Light",
    "LightSamples",
    "LightSelection",
    "MeshLight",
    "PlacedLight",
    "PrefilteredEnvironment",
    "ShapeLight",
    "SplitEnvironment",
    "cell_directions",
    "make_light",
    "row_places",
    "split_environment",
]

__getattr__, __dir__ = lazy_face(__name__)
