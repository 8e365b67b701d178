"""The material that a baked glTF or strand shader could have, on known geometry.

Parameters by place, the analytic BRDF, times the visibility. Of surfaces it is the model of
`rna-train --preset analytic`, which learns from captured rays there and from the same images as
the other peers here.
"""

import math
from pathlib import Path

import torch
from torch import Tensor, nn
from torch.nn.functional import normalize

from rna_bench.peers.kajiya_kay import HAIR_OUTPUTS, hair_material, hair_radiance
from rna_bench.peers.known_method import KnownMethod, Points
from rna_bench.peers.method import Budget, Training
from rna_bench.peers.methods import Setting
from rna_bench.peers.views import Views
from rna_export.training.model.analytic import gltf_material, gltf_radiance
from rna_export.training.model.layers import new_layers
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.presets import ANALYTIC
from rna_sdk.errors import TrainingError
from rna_sdk.package import query_width

BATCH, RATE = 2048, 1e-2  # the rate of our planes


class _Model(nn.Module):
    """The material, and the intensity of the lights, W/sr."""

    intensity: Tensor

    def __init__(self, kind: str):
        super().__init__()
        bounds = torch.tensor([[-1.0] * 3, [1.0] * 3])
        self.is_strand = kind == "fiber"
        model = ANALYTIC.model
        self.asset = NeuralAsset(model, bounds)
        if self.is_strand:  # an axis is three columns, too
            columns = query_width(model.inputs, model.channels)
            self.asset.decoder = new_layers(columns, model.width, model.hidden_layers, HAIR_OUTPUTS)
        self.register_buffer("intensity", torch.tensor(1.0))


class KnownMaterial(KnownMethod):
    """glTF's material of an asset of surfaces, Kajiya's and Kay's of one of strands.

    The planes span the unit sphere; the light's intensity is the views', or such that a white
    point at the centre is shown as white. Raises `TrainingError` for an asset of both kinds.
    """

    model: _Model

    def __init__(self, setting: Setting):
        torch.manual_seed(setting.seed)
        kinds = setting.geometry.kinds if setting.geometry else {"surface"}
        if len(kinds) > 1:
            raise TrainingError("analytic: found surfaces and strands, expected one of both")
        super().__init__("analytic", setting, _Model(next(iter(kinds))), BATCH, RATE)

    def rate_factor(self, progress: float, steps: int) -> float:
        """A cosine to 0, as in our presets."""
        return 0.5 * (1.0 + math.cos(math.pi * progress)) + 1e-3

    def train(self, data: Views, budget: Budget, work: Path) -> Training:
        """As `Method.train`."""
        self.model.intensity.fill_(data.shown_intensity)
        return super().train(data, budget, work)

    def shaded(self, at: Points) -> Tensor:
        """As `KnownMethod.shaded`; the model's radiance is for irradiance 1."""
        way = at.lights - at.points
        squared = way.square().sum(dim=1, keepdim=True)
        asset, axis = self.model.asset, at.tangents if self.model.is_strand else at.normals
        wo, wi = -at.directions, normalize(way, dim=1)
        where = {"position": at.points, "normal": axis, "wo": wo, "wi": wi}
        outputs = asset.decoder(asset.queries(where))
        lit = (
            hair_radiance(hair_material(outputs), axis, wo, wi)
            if self.model.is_strand
            else gltf_radiance(gltf_material(outputs), axis, wo, wi)
        )
        return lit * at.visible[:, None] * self.model.intensity / squared
