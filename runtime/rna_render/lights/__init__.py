"""Lights: what the integrator knows of them.

The names below are loaded when they are asked for, so that a scene file's models need no Embree.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rna_sdk.lazy_face import lazy_face

if TYPE_CHECKING:
    from rna_render.lights.base import (
        InfiniteLight,
        Light,
        LightSamples,
        PlacedLight,
        ShapeLight,
    )
    from rna_render.lights.directions import LUMINANCE
    from rna_render.lights.equirectangular import EquirectangularImage
    from rna_render.lights.kinds.asset import AssetEmission, AssetLight
    from rna_render.lights.kinds.environment import EnvironmentImageLight, EnvironmentLight
    from rna_render.lights.kinds.mesh import MeshLight
    from rna_render.lights.light_kinds import kinds_of_lights, make_light, number_places
    from rna_render.lights.selection import LightSelection
    from rna_render.lights.split.bright_directions import (
        SplitEnvironment,
        cell_directions,
        split_environment,
    )
    from rna_render.lights.split.prefilter import PrefilteredEnvironment

__all__ = [
    "LUMINANCE",
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
    "kinds_of_lights",
    "make_light",
    "number_places",
    "split_environment",
]

__getattr__, __dir__ = lazy_face(__name__)
