"""The decoder's layers as one autograd function, faster for small batches."""

from itertools import pairwise
from typing import Any

import torch
from torch import Tensor, nn

from rna_export.training.optimization.product_kernels import weight_gradient


def new_layers(columns: int, width: int, hidden: int, outputs: int) -> nn.Sequential:
    """Linear layers with a ReLU between each two: `hidden` of a width, and one of the outputs."""
    sizes = [columns] + [width] * hidden
    layers: list[nn.Module] = []
    for before, after in pairwise(sizes):
        layers += [nn.Linear(before, after), nn.ReLU()]
    return nn.Sequential(*layers, nn.Linear(sizes[-1], outputs))


def hidden_matrices(layers: nn.Sequential) -> list[Tensor]:
    """Matrices of all layers but the last, which reads out."""
    return [layer.weight for layer in [*layers][:-1] if isinstance(layer, nn.Linear)]


def through(layers: nn.Sequential, x: Tensor, bfloat16: bool = False) -> Tensor:
    """layers(x), of linear layers with a ReLU between each two.

    bfloat16: of the layers between the first and the last, which take nearly all the time of wide
    decoders, values and gradients are bfloat16. Products are summed in float32; the weights
    themselves, and the first and the last layer, are float32.
    """
    linear = [layer for layer in layers if isinstance(layer, nn.Linear)]
    parameters = (tensor for layer in linear for tensor in (layer.weight, layer.bias))
    y: Tensor = _Layers.apply(x, bfloat16, *parameters)  # type: ignore[no-untyped-call]
    return y


class _Layers(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, x: Tensor, bfloat16: bool, *parameters: Tensor) -> Tensor:
        inner = torch.bfloat16 if bfloat16 else torch.float32
        count = len(parameters) // 2
        dtypes = [torch.float32, *[inner] * (count - 2), torch.float32]
        values, weights = [x], []
        for k, dtype in enumerate(dtypes[:count]):
            weight, bias = (p.to(dtype) for p in parameters[2 * k : 2 * k + 2])
            y = torch.addmm(bias, values[-1].to(dtype), weight.t())
            values.append(y.relu_().to(inner) if k < count - 1 else y)
            weights.append(weight)
        ctx.save_for_backward(*values[:-1], *weights)
        return values[-1]

    @staticmethod
    def backward(ctx: Any, gradient: Tensor) -> tuple[Tensor | None, ...]:
        count = len(ctx.saved_tensors) // 2
        values, weights = ctx.saved_tensors[:count], ctx.saved_tensors[count:]
        of_parameters: list[Tensor] = []
        for k in reversed(range(count)):
            value, weight = values[k], weights[k]
            gradient = gradient.to(weight.dtype)
            of_weight = weight_gradient(gradient, value.to(weight.dtype))
            of_parameters[:0] = of_weight.float(), gradient.sum(dim=0, dtype=torch.float32)
            gradient = gradient @ weight
            if k > 0:
                gradient = torch.ops.aten.threshold_backward(gradient.to(value.dtype), value, 0)
        return gradient, None, *of_parameters
