"""The optimizers of a model: Muon or Adam for its decoders, Adam for its planes."""

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np
import torch
from torch import Tensor

from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.optimization.muon import Muon
from rna_export.training.optimization.plane_kernels import adam
from rna_export.training.presets import TrainingConfig

_BETAS, _EPSILON = (0.9, 0.999), 1e-8


class PlaneAdam(torch.optim.Optimizer):
    """Like `torch.optim.Adam` for one float32 CPU tensor; `step` also clears its gradient.

    The gradient is one tensor for the whole training, which backward passes add to.
    """

    def __init__(self, planes: Tensor, lr: float):
        super().__init__([planes], {"lr": lr})
        planes.grad = torch.zeros_like(planes)
        self.state[planes] = {
            "step": torch.tensor(0),
            "exp_avg": torch.zeros_like(planes),
            "exp_avg_sq": torch.zeros_like(planes),
        }

    def zero_grad(self, set_to_none: bool = True) -> None:
        """`step` has done it; the gradient stays where backward passes add to it."""

    @torch.no_grad()
    def step(self, closure: None = None) -> None:  # type: ignore[override]
        """One step; no closure evaluates the loss again."""
        (group,) = self.param_groups
        (planes,) = group["params"]
        state = self.state[planes]
        state["step"] += 1
        t = int(state["step"])
        square_corrected = math.sqrt(1.0 - _BETAS[1] ** t)
        rate = group["lr"] * square_corrected / (1.0 - _BETAS[0] ** t)
        tensors: tuple[Any, ...] = (planes, planes.grad, state["exp_avg"], state["exp_avg_sq"])
        values, gradient, mean, square = (x.detach().numpy().reshape(-1) for x in tensors)
        betas = np.float32(_BETAS[0]), np.float32(_BETAS[1])
        epsilon = np.float32(_EPSILON * square_corrected)
        adam(values, gradient, mean, square, np.float32(rate), betas, epsilon)


def optimizers_of(model: NeuralAsset, config: TrainingConfig) -> list[torch.optim.Optimizer]:
    """Optimizers of a model, on its device; `set_rates` changes their rates.

    On a GPU rates are tensors there: a step that reads them can be part of a CUDA graph.
    """
    device, planes = model.ceiling.device, model.triplane.planes
    networks = [p for p in model.parameters() if p is not planes]
    rates = config.learning_rate, config.muon_learning_rate
    matrices = muon_matrices(model, config)
    optimizers = optimizers_of_networks(networks, matrices, rates, model.multiplies_in_bfloat16)
    if device.type == "cpu":
        of_planes: torch.optim.Optimizer = PlaneAdam(planes, config.plane_learning_rate)
    else:
        of_planes = _adam([planes], config.plane_learning_rate, device)
    return [*optimizers, *_with_initial_rates([of_planes])]


def optimizers_of_networks(
    parameters: Sequence[Tensor],
    matrices: Sequence[Tensor],
    rates: tuple[float, float],
    bfloat16: bool = False,
) -> list[torch.optim.Optimizer]:
    """Muon for the matrices among the parameters, Adam for the others; rates: of Adam, of Muon."""
    (adam_rate, muon_rate), device = rates, parameters[0].device
    taken = {id(matrix) for matrix in matrices}
    others = [p for p in parameters if id(p) not in taken]
    optimizers: list[torch.optim.Optimizer] = [_adam(others, adam_rate, device)]
    if matrices:
        optimizers.append(Muon(matrices, _rate(muon_rate, device), bfloat16))
    return _with_initial_rates(optimizers)


def muon_matrices(model: NeuralAsset, config: TrainingConfig) -> list[Tensor]:
    """Matrices for Muon: all matrices of networks, except of their last layers.

    Jordan et al. leave the layers that read out, and all vectors, to Adam.
    """
    return [] if config.optimizer == "adam" else model.hidden_matrices()


def set_rates(optimizers: Iterable[torch.optim.Optimizer], factor: float) -> None:
    """Set all rates to `factor` times the initial rates."""
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


def _with_initial_rates(optimizers: list[torch.optim.Optimizer]) -> list[torch.optim.Optimizer]:
    for group in _groups(optimizers):
        group["initial_lr"] = float(group["lr"])
    return optimizers


def _adam(parameters: list[Tensor], rate: float, device: torch.device) -> torch.optim.Adam:
    lr = _rate(rate, device)
    return torch.optim.Adam(parameters, lr, fused=True, capturable=device.type == "cuda")


def _rate(rate: float, device: torch.device) -> float | Tensor:
    return torch.tensor(rate, device=device) if device.type == "cuda" else rate


def _groups(optimizers: Iterable[torch.optim.Optimizer]) -> Iterator[dict[str, Any]]:
    return (group for optimizer in optimizers for group in optimizer.param_groups)
