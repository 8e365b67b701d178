"""The neural asset in PyTorch: planes, input blocks, decoder."""

from typing import Any

import torch
from torch import Tensor, nn

from rna_export.training.model.analytic import GLTF_OUTPUTS, gltf_material, gltf_radiance
from rna_export.training.model.emission import EmissionDecoder
from rna_export.training.model.inputs import Points, assemble, in_box
from rna_export.training.model.layers import hidden_matrices, new_layers, through
from rna_export.training.model.shadow import ShadowDecoder
from rna_export.training.model.triplane import Triplane
from rna_export.training.presets import ModelConfig
from rna_sdk.package import query_width

_LEAK = 0.01  # of gradients below 0


class NeuralAsset(nn.Module):
    """T(x, wo, wi) as a triplane and an MLP (the paper, section 3).

    The decoder gives colours as y = log(x / unit + 1); `colours` inverts that. In the paper there
    are two, `visible` and `shadowed`. A model that `separates_direct` has three: direct light, and
    scattered light where the light is visible and where it is shadowed. `transport` sums them up
    to the paper's two. With glTF's
    `material` the decoder gives its parameters, and shadowed light is black. A model that
    `uses_base_color` has a second colour for each, which the base colour of a point multiplies
    before it is added: print needs no planes. A model with `nearby` lengths has each of these once
    more for every length, times the nearby light: `seen` sums them up. The last colour may come
    from a decoder of its own, `shadow`.

    `bounds` is (2, 3). `unit` is a radiance: 1 in the paper, what is usual on the asset in our
    presets. `ceiling` bounds what a colour can be: nothing brighter was seen in training.
    `multiplies_in_bfloat16`: see `layers.through`; where gradients are asked for, and only there.
    """

    multiplies_in_bfloat16 = False

    ceiling: Tensor
    unit: Tensor
    nearby_means: Tensor

    def __init__(self, config: ModelConfig, bounds: Tensor):
        super().__init__()
        self.config = config
        self.triplane = Triplane(config.resolution, config.channels, *bounds)
        width, columns = config.width, query_width(config.inputs, config.channels)
        terms = 6 if config.uses_base_color else 3
        colours = len(config.colour_sums[0]) - (config.shadow_width > 0)
        sets = sum(1 + len(config.nearby) * counts for counts in config.counts_nearby[:colours])
        outputs = GLTF_OUTPUTS if config.material == "gltf" else terms * sets
        self.decoder = new_layers(columns, width, config.hidden_layers, outputs)
        self.shadow = (
            ShadowDecoder(
                config.shadow_inputs,
                config.channels,
                config.shadow_width,
                terms * (1 + len(config.nearby)),
            )
            if config.shadow_width > 0
            else None
        )
        self.emission = (
            EmissionDecoder(config.emission_inputs, config.channels, width)
            if config.emission_inputs
            else None
        )
        self.register_buffer("ceiling", torch.tensor(100.0))
        self.register_buffer("unit", torch.tensor(1.0))
        if config.nearby:
            self.register_buffer("nearby_means", torch.zeros(2, len(config.nearby)))

    @property
    def colour_sums(self) -> tuple[tuple[int, ...], ...]:
        """See `ModelConfig`."""
        return self.config.colour_sums

    @property
    def units(self) -> Tensor:
        """The unit of each colour, (colours, 1)."""
        units = [self.unit] * len(self.colour_sums[0])
        if self.shadow is not None:
            units[-1] = self.shadow.unit
        return torch.stack(units)[:, None]

    @property
    def multiply_adds(self) -> int:
        """Multiply-adds of all matrix products of a query, without the emission decoder."""
        modules = [*self.decoder, *([] if self.shadow is None else self.shadow.modules())]
        return sum(m.weight.numel() for m in modules if isinstance(m, nn.Linear))

    @property
    def emitting(self) -> tuple[EmissionDecoder, Triplane]:
        """The decoder of emission with its planes, of a model that has one."""
        assert self.emission is not None
        return self.emission, self.triplane

    def forward(self, at: Points, blur: float | Tensor = 1.0) -> Tensor:
        """y = log(x / unit + 1) of each colour, (k, 1 to 3, 3)."""
        features, p = self._features(at, blur), self._place(at)
        colours = [self._colours_of_decoder(features, p, at)]
        if self.shadow is not None:
            colours.append(self._shadowed(self.shadow, features, p, at))
        return torch.cat(colours, dim=1)

    def own_light(self, at: Points, lit: int, blur: float | Tensor = 1.0) -> Tensor:
        """y, (k, 3), of visible light at the first `lit` points, of shadowed at others.

        Of a surface's model with a decoder for shadowed light: each decoder sees its points alone.
        """
        assert self.shadow is not None
        count = len(at["position"])
        sizes = [lit, count - lit]
        features, p = self._features(at, blur).split(sizes), self._place(at).split(sizes)
        seeing, others = ({name: x.split(sizes)[k] for name, x in at.items()} for k in range(2))
        visible = self._colours_of_decoder(features[0], p[0], seeing)
        shadowed = self._shadowed(self.shadow, features[1], p[1], others)
        return torch.cat([visible, shadowed]).squeeze(1)

    def _colours_of_decoder(self, features: Tensor, p: Tensor, at: Points) -> Tensor:
        """y of all colours except `shadow`."""
        queries = assemble(self.config.inputs, features, p, at)
        y = through(self.decoder, queries, self._in_bfloat16)
        if self.config.material == "gltf":
            radiance = gltf_radiance(gltf_material(y), at["normal"], at["wo"], at["wi"])
            lit = torch.log1p(radiance / self.unit)
            return torch.stack([lit, torch.zeros_like(lit)], dim=1)
        counts = self.config.counts_nearby
        return self._colours(y, at, counts if self.shadow is None else counts[:-1])

    def _shadowed(self, shadow: ShadowDecoder, features: Tensor, p: Tensor, at: Points) -> Tensor:
        """y of the colour of `shadow`."""
        queries = assemble(shadow.inputs, features, p, at)
        # Much of it is black. What is below 0 costs nothing, so blacks need not be hit exactly.
        return self._colours(_cut_off(shadow(queries)), at, (True,))

    def _colours(self, y: Tensor, at: Points, counts_nearby: tuple[bool, ...]) -> Tensor:
        """y of colours from outputs of a decoder.

        These are those of each colour, of two terms where base colour is a factor; then those for
        each length of nearby light, of the colours that count it, the last ones.
        """
        y, lengths = y.reshape(len(y), -1, 3), len(self.config.nearby)
        if not (lengths or self.config.uses_base_color):
            return y
        terms, every = 2 if self.config.uses_base_color else 1, len(counts_nearby)
        y = _cut_off(y)
        total = self._terms_summed(y[:, : terms * every], at)
        if lengths:
            of_lengths = self._terms_summed(y[:, terms * every :].unflatten(1, (lengths, -1)), at)
            of_nearby = torch.einsum("klsc,kl->ksc", of_lengths, at["nearby"])
            silent = every - of_nearby.shape[1]
            total = total + nn.functional.pad(of_nearby, (0, 0, silent, 0))
        return torch.log1p(total)

    def _terms_summed(self, y: Tensor, at: Points) -> Tensor:
        """x / unit of colours, (k, ..., colours, 3), of y of their terms."""
        x = torch.expm1(y)
        if not self.config.uses_base_color:
            return x
        rest, factor = x.chunk(2, dim=-2)
        color = at["base_color"].reshape(len(x), *[1] * (x.dim() - 2), 3)
        return rest + color * factor

    @property
    def _in_bfloat16(self) -> bool:
        return self.multiplies_in_bfloat16 and torch.is_grad_enabled()

    def queries(self, at: Points, blur: float | Tensor = 1.0) -> Tensor:
        """The decoder's queries, (k, K)."""
        return assemble(self.config.inputs, self._features(at, blur), self._place(at), at)

    def _place(self, at: Points) -> Tensor:
        """Positions in the bounds, (k, 3) from 0 to 1."""
        return in_box(at["position"], self.triplane.low, self.triplane.high)

    def hidden_matrices(self) -> list[Tensor]:
        """Matrices of all layers of the decoders but the last ones."""
        others = (self.shadow, self.emission)
        decoders = [self.decoder, *(other.decoder for other in others if other is not None)]
        return [matrix for decoder in decoders for matrix in hidden_matrices(decoder)]

    def _features(self, at: Points, blur: float | Tensor) -> Tensor:
        """Features (k, C) of the points."""
        features: Tensor = self.triplane(at["position"], blur)
        return features

    def colours(self, y: Tensor) -> Tensor:
        """Radiance from y: the inverse of log(x / unit + 1), between 0 and the ceiling."""
        units = self.units
        highest = torch.log1p(self.ceiling / units)
        return units * torch.expm1(y.clamp(min=0.0).minimum(highest))

    def transport(self, y: Tensor) -> Tensor:
        """Radiance where the light is visible and where it is shadowed, (k, 2, 3)."""
        sums = torch.tensor(self.config.colour_sums, dtype=y.dtype, device=y.device)
        return torch.einsum("sc,kcr->ksr", sums, self.colours(y))


def _cut_off(y: Tensor) -> Tensor:
    """y as packages have it, 0 at least; in training a gradient leads back from below."""
    if not torch.is_grad_enabled():
        return y.clamp(min=0.0)
    result: Tensor = _CutOff.apply(y)  # type: ignore[no-untyped-call]
    return result


class _CutOff(torch.autograd.Function):
    """Values of ReLU, as packages have them; below 0 a part of the gradients that lead upwards.

    A leaky ReLU trains with sums of negative terms, which packages cut off: their pictures are too
    bright (docs/decisions/model.md).
    """

    @staticmethod
    def forward(ctx: Any, y: Tensor) -> Tensor:
        ctx.save_for_backward(y)
        return y.clamp(min=0.0)

    @staticmethod
    def backward(ctx: Any, gradient: Tensor) -> Tensor:
        (y,) = ctx.saved_tensors
        return torch.where(y > 0.0, gradient, _LEAK * gradient.clamp(max=0.0))
