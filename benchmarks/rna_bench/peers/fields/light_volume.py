"""Transmittance from a point light, stored by a virtual camera there and interpolated.

Bi et al. 2020, section on relighting: rays through the pixels of a camera at the light store what
of the light arrives at places along them; shading looks it up between them.
"""

import math
from collections.abc import Callable

import torch
from torch import Tensor
from torch.nn.functional import grid_sample, normalize

from rna_sdk.errors import TrainingError

Density = Callable[[Tensor], Tensor]
"""Points (k, 3) -> density (k,), per unit of length."""

_CHUNK = 65_536
_MARGIN = 1.02  # of the cone about the unit sphere


def transmittances(density: Tensor, lengths: Tensor) -> Tensor:
    """Before each section of rays, and behind the last: (n, m + 1), of sections (n, m)."""
    depth = torch.cumsum(density * lengths, dim=1)
    return torch.exp(-torch.cat([torch.zeros_like(depth[:, :1]), depth], dim=1))


class LightVolume:
    """Transmittance from a light (3,) outside the unit sphere to points in it.

    side: pixels of the camera along a side. sections: along a ray, through the sphere. Raises
    `TrainingError` for a light in the sphere, which no camera sees as a whole.
    """

    def __init__(self, density: Density, light: Tensor, side: int, sections: int):
        distance = float(light.norm())
        if not distance > _MARGIN:
            place = ", ".join(f"{x:g}" for x in light.tolist())
            raise TrainingError(
                f"light at ({place}): found {distance:g} from the centre, expected a light outside "
                f"the asset's sphere, beyond {_MARGIN:g}"
            )
        self._light, self._near = light, distance - 1.0
        self._extent = math.tan(math.asin(min(_MARGIN / distance, 0.999)))
        forward = normalize(-light, dim=0)
        aside = torch.eye(3, device=light.device)[forward.abs().argmin()]
        right = normalize(torch.linalg.cross(forward, aside), dim=0)
        self._frame = torch.stack([right, torch.linalg.cross(right, forward), forward])
        at = torch.linspace(-self._extent, self._extent, side, device=light.device)
        y, x = torch.meshgrid(at, at, indexing="ij")
        local = torch.stack([x, y, torch.ones_like(x)], dim=2).reshape(-1, 3)
        directions = normalize(local @ self._frame, dim=1)
        length = 2.0 / sections
        middles = self._near + length * (torch.arange(sections, device=light.device) + 0.5)
        result = []
        for rays in directions.split(max(1, _CHUNK // sections)):
            points = light + rays[:, None] * middles[None, :, None]
            there = density(points.reshape(-1, 3)).reshape(len(rays), sections)
            result.append(transmittances(there, torch.full_like(there, length)))
        self._volume = torch.cat(result).T.reshape(1, 1, sections + 1, side, side)

    def at(self, points: Tensor) -> Tensor:
        """Transmittance (k,) from the light to points (k, 3)."""
        way = points - self._light
        local = way @ self._frame.T
        across = local[:, :2] / (self._extent * local[:, 2:].clamp(min=1e-6))
        along = way.norm(dim=1, keepdim=True) - self._near - 1.0
        places = torch.cat([across, along], dim=1)[None, None, None]
        samples = grid_sample(self._volume, places, padding_mode="border", align_corners=True)
        return samples.reshape(-1)
