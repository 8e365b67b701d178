"""The optimizers of a model: Muon or Adam for its decoders, Adam for its planes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import torch
from torch import Tensor, nn

from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.model.triplane import Triplane
from rna_export.training.optimization.muon import Muon
from rna_export.training.optimization.plane_adam import PlaneAdam
from rna_export.training.presets import TrainingConfig


def optimizers_of(model: NeuralAsset, config: TrainingConfig) -> list[torch.optim.Optimizer]:
    """Optimizers of a model, on its device; `set_rates` changes their rates.

    On a GPU rates are tensors there: a step that reads them can be part of a CUDA graph.
    """
    device = model.ceiling.device
    matrices = muon_matrices(model, config)
    taken = {id(p) for p in matrices}
    features: list[Tensor] = [p for p in model.triplane.parameters() if id(p) not in taken]
    taken |= {id(p) for p in features}
    others: list[Tensor] = [p for p in model.parameters() if id(p) not in taken]
    found: list[torch.optim.Optimizer] = [_adam(others, config.learning_rate, device)]
    if matrices:
        lr = _rate(config.muon_learning_rate, device)
        found.append(Muon(matrices, lr, model.multiplies_in_bfloat16))
    if isinstance(model.triplane, Triplane) and device.type == "cpu":
        found.append(PlaneAdam(features[0], config.plane_learning_rate))
    else:
        found.append(_adam(features, config.plane_learning_rate, device))
    for group in _groups(found):
        group["initial_lr"] = float(group["lr"])
    return found


def muon_matrices(model: NeuralAsset, config: TrainingConfig) -> list[Tensor]:
    """What Muon takes: the matrices of networks, but for those of their last layers.

    Jordan et al. leave the layers that read out, and all vectors, to Adam.
    """
    if config.optimizer == "adam":
        return []
    decoders = [model.decoder]
    if model.emission is not None:
        decoders.append(model.emission.decoder)
    layers = (layer for decoder in decoders for layer in [*decoder][:-1])
    found: list[Tensor] = [layer.weight for layer in layers if isinstance(layer, nn.Linear)]
    return found + model.feature_matrices()


def set_rates(optimizers: Iterable[torch.optim.Optimizer], factor: float) -> None:
    """Set all rates to `factor` times those of the start."""
    for group in _groups(optimizers):
        rate = factor * group["initial_lr"]
        if isinstance(group["lr"], Tensor):
            group["lr"].fill_(rate)
        else:
            group["lr"] = rate


def load_states(optimizers: Sequence[torch.optim.Optimizer], states: Sequence[Any]) -> None:
    """Go on from `state_dict`s. Rates stay the objects that they are, on their device."""
    rates = [group["lr"] for group in _groups(optimizers)]
    for optimizer, state in zip(optimizers, states, strict=True):
        optimizer.load_state_dict(state)
    for group, rate in zip(_groups(optimizers), rates, strict=True):
        group["lr"] = rate


def _adam(parameters: list[Tensor], rate: float, device: torch.device) -> torch.optim.Adam:
    lr = _rate(rate, device)
    return torch.optim.Adam(parameters, lr, fused=True, capturable=device.type == "cuda")


def _rate(rate: float, device: torch.device) -> float | Tensor:
    return torch.tensor(rate, device=device) if device.type == "cuda" else rate


def _groups(optimizers: Iterable[torch.optim.Optimizer]) -> Iterator[dict[str, Any]]:
    return (group for optimizer in optimizers for group in optimizer.param_groups)
