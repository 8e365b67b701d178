"""The light of a render of rays: a sun, a white world, or the asset itself; as Blender is asked."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from rna_export.capture.blender_axes import to_blender
from rna_sdk.package.manifest.manifest_fields import Region


@dataclass(frozen=True)
class WhiteWorld:
    """Light of radiance 1 from all directions of a region, as far away as a sun."""

    region: Region = "sphere"


Light = np.ndarray | WhiteWorld | None
"""(3,) towards a sun of irradiance 1; a world; or None for the asset's emission."""


def asked_light(light: Light) -> dict[str, Any]:
    """The light of a request, in Blender's axes: see `ray_render.light`."""
    if light is None:
        return {}
    if isinstance(light, WhiteWorld):
        return {"white": _cones(light.region)}
    return {"sun": to_blender(np.asarray(light, np.float64)).tolist()}


def _cones(region: Region) -> list[list[float]]:
    """Axis and least cosine of each cone, [x, y, z, cosine]; none for all directions."""
    if region == "sphere":
        return []
    up = np.array([0.0, 1.0, 0.0])
    cones = [(up, 0.0)] if region == "hemisphere" else _axes(region)
    return [[*to_blender(axis).tolist(), cosine] for axis, cosine in cones]


def _axes(region: Any) -> list[tuple[np.ndarray, float]]:
    return [
        (np.array(cone.axis) / np.linalg.norm(cone.axis), float(np.cos(cone.half_angle)))
        for cone in region
    ]
