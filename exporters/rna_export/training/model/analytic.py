"""The metallic-roughness material of glTF by place: a decoder's outputs and their shading.

Instead of colours, the decoder gives the material's parameters at each point. It is what baking a
material gives, fitted to the captured radiance: what a neural asset has to be better than.
`rna_render.materials.bsdf` shades the same.
"""

import math
from functools import cache
from typing import NamedTuple

import numpy as np
import torch
import torch.nn.functional as F
from torch import Tensor

from rna_export.training.model.tensor_vectors import dot
from rna_render.materials import ALBEDO_MEANS, ALBEDO_TABLE

GLTF_OUTPUTS = 8
"""Number of outputs of the decoder."""

COAT_F0 = 0.04
"""Reflectance of glTF's dielectrics seen straight on."""

_LEAST_ROUGHNESS = 0.03
_LEAST_COSINE = 1e-3  # to the viewer
_FIRST_METALLIC = -3.0  # before the sigmoid: dielectric at first


class GltfMaterial(NamedTuple):
    """Parameters of points, (k, 3) or (k, 1) each."""

    base_color: Tensor  # linear, 0 to 1
    roughness: Tensor
    metallic: Tensor
    tilt: Tensor  # added to the unit normal, object space

    def normal(self, n: Tensor) -> Tensor:
        """The unit shading normal about the geometry's, (k, 3)."""
        return F.normalize(n + self.tilt, dim=1)


def gltf_material(outputs: Tensor) -> GltfMaterial:
    """The material that a decoder's outputs (k, 8) stand for."""
    base, roughness, metallic, tilt = outputs.split([3, 1, 1, 3], dim=1)
    return GltfMaterial(
        torch.sigmoid(base),
        _LEAST_ROUGHNESS + (1.0 - _LEAST_ROUGHNESS) * torch.sigmoid(roughness),
        torch.sigmoid(metallic + _FIRST_METALLIC),
        tilt,
    )


def gltf_radiance(material: GltfMaterial, n: Tensor, wo: Tensor, wi: Tensor) -> Tensor:
    """f(wo, wi) |n.wi| of both sides of a surface alike, (k, 3)."""
    m = torch.where(dot(n, wo) < 0.0, -1.0, 1.0) * material.normal(n)
    cos_i, cos_o = dot(m, wi).clamp(min=0.0), dot(m, wo).clamp(min=_LEAST_COSINE)
    h = F.normalize(wo + wi, dim=1)
    cos_h, weight = dot(m, h), (1.0 - dot(wo, h).clamp(0.0, 1.0)) ** 5
    base, roughness, metallic, _ = material
    square = roughness**4
    across = torch.cross(m, h, dim=1)  # a sine keeps the digits that 1 - cos_h**2 loses
    spread = dot(across, across) + square * cos_h**2
    roots = (torch.sqrt(square + (1.0 - square) * c**2) for c in (cos_o, cos_i))
    # Smith's height-correlated masking; no light comes where cos_i is 0.
    masked = cos_i * next(roots) + cos_o * next(roots)
    mirrored = square / (math.pi * spread**2) * 0.5 / masked
    metal = metallic * (base + (1.0 - base) * weight)
    coat = (1.0 - metallic) * (COAT_F0 + (1.0 - COAT_F0) * weight)
    passed = (1.0 - _coat_albedo(roughness, cos_o)) * (1.0 - _coat_albedo(roughness, cos_i))
    diffuse = (1.0 - metallic) * base / math.pi * passed / (1.0 - _coat_albedo(roughness))
    return ((metal + coat) * mirrored + diffuse) * cos_i


def _coat_albedo(roughness: Tensor, cosine: Tensor | None = None) -> Tensor:
    """The part that a dielectric's coat reflects by itself; its mean without a direction: (k, 1).

    Interpolated in the renderer's table, uniform in roughness and sqrt(cosine).
    """
    table = _coat_table(cosine is None, roughness.device)
    column = roughness if cosine is None else torch.sqrt(cosine.clamp(1e-8, 1.0))
    place = 2.0 * torch.cat([column, roughness], dim=1)[None, :, None] - 1.0
    albedo = F.grid_sample(table, place, padding_mode="border", align_corners=True)
    return albedo[0, 0]


@cache
def _coat_table(mean: bool, device: torch.device) -> Tensor:
    terms: np.ndarray = ALBEDO_MEANS[:, None] if mean else ALBEDO_TABLE
    albedo = COAT_F0 * terms[..., 0] + terms[..., 1]
    return torch.tensor(albedo[None, None], dtype=torch.float32, device=device)
