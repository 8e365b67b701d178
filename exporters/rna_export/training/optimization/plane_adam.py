"""Adam for planes on the CPU, compiled: most of a step is memory traffic over all texels."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import torch
from torch import Tensor

from rna_export.training.optimization.plane_kernels import adam

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
