"""The loss between the decoder's y = log(x / unit + 1) and radiance targets, (n, 3) each.

Which one a training takes follows from the noise of the captured radiance.
"""

import numpy as np
import torch
from torch import Tensor

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.training.model.inputs import Points
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.model.tensor_vectors import dot
from rna_export.training.presets import Preset

_LEAST_VISIBLE = 0.05
_LEAST = 0.1  # of x / unit + 1, for a logarithm
MOST_DARKENED = 0.05
"""Part of the brightness that the log loss may cost; the end of a run puts it right."""


def sample_loss(
    model: NeuralAsset,
    at: Points,
    blur: float | Tensor,
    loss: str = "log",
    shadow_weight: float = 1.0,
    lit: int | None = None,
) -> Tensor:
    """The loss of a batch of samples, of the outputs alone that match their visibility.

    loss: "log" or "unbiased"; of a model with an output for direct light, of that light alone:
    scattered light is next to nothing but noise, and its loss is always the unbiased one.
    shadow_weight: of samples in shadow, for a model without that output; the mean weight is 1,
    before `_weights_of_glow`.
    lit: the first samples of the batch that see the light, where all others do not; of a model
    with a decoder for shadowed light, each of whose decoders then sees its own samples alone.
    """
    v = at["visible"]
    if not model.config.separates_direct:
        weight = _weights(v, shadow_weight)
        if lit is None:
            y, unit = _of_visibility(model(at, blur), model.units, v)
        else:
            y = model.own_light(at, lit, blur)
            of_visible, of_shadowed = model.units
            unit = torch.cat([of_visible.expand(lit, 1), of_shadowed.expand(len(v) - lit, 1)])
        if model.shadow is not None:
            weight = weight * _weights_of_glow(at, y, unit, model.shadow.unit)
        return _LOSSES[loss](y, at["radiance"], unit, weight)
    y = model(at, blur)
    scattered, unit = _of_visibility(y[:, 1:], model.units[1:], v)
    of_light = at["direct"]
    if v.dim() == 1:
        v = v[:, None]
    else:  # weakened by what it came through
        of_light = of_light / v.clamp(min=_LEAST_VISIBLE)
    direct = _LOSSES[loss](y[:, 0], of_light, model.unit, v)
    return direct + unbiased_l2(scattered, at["radiance"] - at["direct"], unit)


def _weights(visible: Tensor, of_shadow: float) -> Tensor | float:
    """Weights of samples, of mean 1: (k, 1), or (k, 3) where visibility has colours."""
    if of_shadow == 1.0:
        return 1.0
    v = visible[:, None] if visible.dim() == 1 else visible
    weight = v + of_shadow * (1.0 - v)
    return weight / weight.mean()


def _weights_of_glow(at: Points, y: Tensor, unit: Tensor, of_shadow: Tensor) -> Tensor:
    """Weights of samples, (k, 3), which make errors count as in shadow where the normal faces away.

    A normal map turns normals away from light that the surface sees. What is left there is
    scattered light, as dark as shadow: with the unit of visible light its loss would be nothing.
    y: (k, 3) of the samples, with their unit (k, 1). of_shadow: unit of shadowed light.
    """
    x = unit * torch.expm1(y.detach()).clamp(min=0.0)
    in_shadow = (1.0 + (unit - of_shadow) / (x + of_shadow)).square()
    return torch.where(dot(at["normal"], at["wi"]) < 0.0, in_shadow, 1.0)


def _of_visibility(y: Tensor, units: Tensor, v: Tensor) -> tuple[Tensor, Tensor]:
    """y (k, 3) of each sample's light and its unit, of outputs for visible and shadowed light.

    y: (k, 2, 3) outputs, blended by v, each sample's visibility. units: (2, 1) of both.
    """
    if v.dim() == 1:
        lit = v[:, None] > 0.5
        return torch.where(lit, y[:, 0], y[:, 1]), torch.where(lit, units[0], units[1])
    # v visible + (1 - v) shadowed, of radiance x = unit (exp(y) - 1).
    unit = v * units[0] + (1.0 - v) * units[1]
    x = v * units[0] * torch.expm1(y[:, 0]) + (1.0 - v) * units[1] * torch.expm1(y[:, 1])
    return torch.log((x / unit + 1.0).clamp(min=_LEAST)), unit


def log_l2(
    y: Tensor, target: Tensor, unit: Tensor | float = 1.0, weight: Tensor | float = 1.0
) -> Tensor:
    """Squared error of log(x / unit + 1): the paper, section 4.2, where the unit is 1.

    Noise in the targets darkens what it learns: see `darkening`.
    """
    return (weight * (y - torch.log1p(target / unit)).square()).mean()


def unbiased_l2(
    y: Tensor, target: Tensor, unit: Tensor | float = 1.0, weight: Tensor | float = 1.0
) -> Tensor:
    """Squared error of x over (x + unit)^2, x as predicted: near the truth it is `log_l2`.

    Its minimum is the mean of noisy targets, since the denominator is held fixed: Lehtinen et
    al., "Noise2Noise", 2018, section 3.2; Mueller et al., "Real-time Neural Radiance Caching for
    Path Tracing", 2021, section 4.1.
    """
    x_over_unit = torch.expm1(y)
    scale = 1.0 / (x_over_unit.detach().clamp(min=0.0) + 1.0)
    return (weight * (scale * (x_over_unit - target / unit)).square()).mean()


_LOSSES = {"log": log_l2, "unbiased": unbiased_l2}


def darkening(dataset: DatasetPart, unit: float) -> float:
    """Relative darkening that the log loss would cause, to second order in the noise.

    The mean of log(x / unit + 1) over noisy x is lower than at their mean, by half their
    variance over (x + unit)^2. The variance of a training sample follows from both halves of the
    validation images, which have more paths.
    """
    settings = dataset.manifest.settings
    lost = total = 0.0
    for view in dataset.validation_views():
        halves = view.halves.astype(np.float64)
        x = halves.mean(axis=0)
        of_half = (halves[0] - halves[1]) ** 2 / 2.0
        of_sample = of_half * (settings.validation_samples / 2.0 / settings.samples)
        lost += float(np.sum(of_sample / 2.0 / (x + unit)))
        total += float(np.sum(x))
    return lost / total if total > 0.0 else 0.0


def with_fitting_loss(preset: Preset, dataset: DatasetPart, unit: float) -> Preset:
    """The preset with a loss chosen for the dataset's noise, where it leaves that open."""
    if preset.training.loss != "auto":
        return preset
    too_dark = darkening(dataset, unit) > MOST_DARKENED
    return preset.with_training(loss="unbiased" if too_dark else "log")
