"""The network of Neural Reflectance Fields: density, normal and reflectance at a point.

Bi et al., "Neural Reflectance Fields for Appearance Acquisition", 2020: an MLP of 14 layers of 256
gives a density, a normal, and albedo and roughness of a GGX BRDF, or for fur the parameters of
Kajiya's and Kay's model. Not published, and NeRF's here (Mildenhall et al. 2020): the encoding of
the position by 10 octaves without the factor pi, and that it comes in again behind every fifth
layer. The density is a softplus, which cannot die as NeRF's ReLU can.
"""

from typing import NamedTuple

import torch
from torch import Tensor, nn
from torch.nn.functional import normalize, softplus

from rna_bench.peers.kajiya_kay import HAIR_OUTPUTS, hair_material, hair_radiance
from rna_export.training.model.analytic import GltfMaterial, gltf_radiance

LAYERS, WIDTH, OCTAVES = 14, 256, 10
ENCODED = 3 + 3 * 2 * OCTAVES
AGAIN = (5, 10)
"""Layers that have the encoded position as inputs, too; from 0."""

_STEEP, _EMPTY = 10.0, -1.0  # of the softplus, and where it begins: a density of 0.3
_LEAST_ROUGHNESS = 0.1


class FieldPoint(NamedTuple):
    """The field at k points: density (k,), unit axes (k, 3), reflectance (k, p)."""

    density: Tensor
    axis: Tensor
    reflectance: Tensor


class FieldNetwork(nn.Module):
    """The field in the unit sphere. is_fur: the axis is a tangent instead of a normal."""

    def __init__(self, is_fur: bool = False):
        super().__init__()
        self.is_fur = is_fur
        columns = [ENCODED] + [WIDTH + ENCODED * (k in AGAIN) for k in range(1, LAYERS)]
        self.layers = nn.ModuleList(nn.Linear(c, WIDTH) for c in columns)
        self.last = nn.Linear(WIDTH, 4 + (HAIR_OUTPUTS if is_fur else 4))

    def forward(self, points: Tensor) -> FieldPoint:
        """The field at points (k, 3)."""
        octaves = 2.0 ** torch.arange(OCTAVES, device=points.device)
        scaled = (points[:, :, None] * octaves).flatten(1)
        encoded = torch.cat([points, torch.sin(scaled), torch.cos(scaled)], dim=1)
        x = torch.relu(self.layers[0](encoded))
        for k, layer in enumerate(self.layers[1:], start=1):
            x = torch.relu(layer(torch.cat([x, encoded], dim=1) if k in AGAIN else x))
        density, axis, reflectance = self.last(x).tensor_split([1, 4], dim=1)
        return FieldPoint(
            softplus(_STEEP * density[:, 0] + _EMPTY), normalize(axis, dim=1), reflectance
        )

    def reflected(self, at: FieldPoint, wo: Tensor, wi: Tensor) -> Tensor:
        """f(wo, wi) times the cosine of the light, (k, 3)."""
        if self.is_fur:
            return hair_radiance(hair_material(at.reflectance), at.axis, wo, wi)
        albedo, roughness = torch.sigmoid(at.reflectance).split([3, 1], dim=1)
        roughness = _LEAST_ROUGHNESS + (1.0 - _LEAST_ROUGHNESS) * roughness
        none = torch.zeros_like(roughness)
        material = GltfMaterial(albedo, roughness, none, torch.zeros_like(at.axis))
        return gltf_radiance(material, at.axis, wo, wi)
