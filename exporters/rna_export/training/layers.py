"""The decoder's layers as one autograd function, faster for small batches."""

from __future__ import annotations

from typing import Any

import torch
from torch import Tensor, nn


def through(layers: nn.Sequential, x: Tensor) -> Tensor:
    """layers(x), of linear layers with a ReLU between each two."""
    linear = [layer for layer in layers if isinstance(layer, nn.Linear)]
    parameters = (tensor for layer in linear for tensor in (layer.weight, layer.bias))
    y: Tensor = _Layers.apply(x, *parameters)  # type: ignore[no-untyped-call]
    return y


class _Layers(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, x: Tensor, *parameters: Tensor) -> Tensor:
        values, count = [x], len(parameters) // 2
        for k in range(count):
            weight, bias = parameters[2 * k : 2 * k + 2]
            y = torch.addmm(bias, values[-1], weight.t())
            values.append(y.relu_() if k < count - 1 else y)
        ctx.save_for_backward(*values[:-1], *parameters[::2])
        return values[-1]

    @staticmethod
    def backward(ctx: Any, gradient: Tensor) -> tuple[Tensor, ...]:
        count = len(ctx.saved_tensors) // 2
        values, weights = ctx.saved_tensors[:count], ctx.saved_tensors[count:]
        of_parameters: list[Tensor] = []
        for k in reversed(range(count)):
            of_parameters[:0] = gradient.t() @ values[k], gradient.sum(dim=0)
            gradient = gradient @ weights[k]
            if k > 0:
                gradient = torch.ops.aten.threshold_backward(gradient, values[k], 0)
        return gradient, *of_parameters
