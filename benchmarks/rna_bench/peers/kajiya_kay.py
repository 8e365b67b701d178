"""A material of strands: the meaning of a network's outputs, and their shading.

Kajiya and Kay, "Rendering Fur with Three Dimensional Textures", 1989, with the exponent of the
highlight, and a colour of its own, as parameters of a point.
"""

import math
from typing import NamedTuple

import torch
from torch import Tensor
from torch.nn.functional import softplus

from rna_export.training.model.tensor_vectors import dot

HAIR_OUTPUTS = 7
"""Number of outputs of the network."""

_EXPONENTS = 1.0, 9.0  # of two: narrow highlights have the larger one


class HairMaterial(NamedTuple):
    """Parameters of points of strands, (k, 3) or (k, 1) each; none negative."""

    diffuse: Tensor  # radiance of light at right angles to the strand, of irradiance 1
    specular: Tensor
    exponent: Tensor


def hair_material(outputs: Tensor) -> HairMaterial:
    """The material that outputs (k, 7) stand for."""
    diffuse, specular, exponent = outputs.split([3, 3, 1], dim=1)
    low, high = _EXPONENTS
    power = torch.exp2(low + (high - low) * torch.sigmoid(exponent))
    return HairMaterial(softplus(diffuse) / math.pi, softplus(specular) / math.pi, power)


def hair_radiance(material: HairMaterial, t: Tensor, wo: Tensor, wi: Tensor) -> Tensor:
    """A cylinder's diffuse part, and a highlight about the cone that mirrors the light: (k, 3)."""
    s_i, s_o = (dot(t, w).clamp(-1.0, 1.0) for w in (wi, wo))
    c_i, c_o = (torch.sqrt((1.0 - s**2).clamp(min=1e-6)) for s in (s_i, s_o))
    aside = (c_i * c_o - s_i * s_o).clamp(min=1e-6)  # cosine of the angle to the cone
    return material.diffuse * c_i + material.specular * aside**material.exponent
