"""Muon: momentum whose matrices are orthogonalised before each step.

Jordan et al., "Muon: An optimizer for hidden layers in neural networks", 2024. Unlike
`torch.optim.Muon` it iterates over all matrices of equal height at once, in float32 unless told
otherwise, and its rate may be a tensor: the step can be part of a CUDA graph.
"""

import math
from collections.abc import Iterable

import torch
import torch.nn.functional as F
from torch import Tensor

_MOMENTUM = 0.95
_ITERATIONS = 5
_COEFFICIENTS = 3.4445, -4.7750, 2.0315  # of the quintic polynomial: Jordan et al.
_EPSILON = 1e-7
# The momentum of a unit that is always 0 decays to subnormal numbers, which processors multiply a
# hundred times more slowly; so does what is tiny beside the rest of its matrix.
_NO_MOMENTUM = 1e-30
_NEGLIGIBLE = 1e-7  # of a matrix's norm


class Muon(torch.optim.Optimizer):
    """Steps of a decoder's matrices, (rows, columns) each: outputs by inputs, as `nn.Linear` has.

    A step moves each by `lr` times the orthogonalised momentum, times sqrt(rows / columns) where
    that is above 1. lr: a float, or a tensor on the matrices' device. bfloat16: of the products of
    the orthogonalisation.
    """

    def __init__(self, matrices: Iterable[Tensor], lr: float | Tensor, bfloat16: bool = False):
        by_rows: dict[int, list[Tensor]] = {}
        for matrix in matrices:
            by_rows.setdefault(len(matrix), []).append(matrix)
        super().__init__([{"params": same} for same in by_rows.values()], {"lr": lr})
        for matrix in (m for same in by_rows.values() for m in same):
            self.state[matrix]["momentum"] = torch.zeros_like(matrix)
        self._dtype = torch.bfloat16 if bfloat16 else torch.float32

    def stacks(self) -> list[Tensor]:
        """Zeros in the shapes (k, rows, columns) and dtype of the matrices of a step."""
        result = []
        for group in self.param_groups:
            first, columns = group["params"][0], max(m.shape[1] for m in group["params"])
            shape = len(group["params"]), len(first), columns
            result.append(first.new_zeros(shape, dtype=self._dtype))
        return result

    @torch.no_grad()
    def step(self, closure: None = None) -> None:  # type: ignore[override]
        """One step; no closure evaluates the loss again."""
        for group, directions in zip(self.param_groups, self.stacks(), strict=True):
            matrices = group["params"]
            for matrix, direction in zip(matrices, directions, strict=True):
                momentum = self.state[matrix]["momentum"].lerp_(matrix.grad, 1.0 - _MOMENTUM)
                momentum.copy_(F.hardshrink(momentum, _NO_MOMENTUM))
                nesterov = torch.lerp(matrix.grad, momentum, _MOMENTUM)
                direction[:, : matrix.shape[1]] = nesterov
            steps = orthogonalised(directions).float() * group["lr"]
            for matrix, step in zip(matrices, steps, strict=True):
                rows, columns = matrix.shape
                matrix.sub_(step[:, :columns], alpha=math.sqrt(max(1.0, rows / columns)))


def orthogonalised(matrices: Tensor) -> Tensor:
    """Matrices (k, a, b) with all singular values near 1, between 0.7 and 1.2; zeros stay zero.

    Newton-Schulz iterations; columns of zeros change nothing of the others.
    """
    is_tall = matrices.shape[1] > matrices.shape[2]
    x = matrices.mT.contiguous() if is_tall else matrices
    a, b, c = _COEFFICIENTS
    x = F.hardshrink(x / (x.norm(dim=(1, 2), keepdim=True) + _EPSILON), _NEGLIGIBLE)
    for _ in range(_ITERATIONS):
        gram = torch.bmm(x, x.mT)
        polynomial = torch.baddbmm(gram, gram, gram, beta=b, alpha=c)
        x = torch.baddbmm(x, polynomial, x, beta=a)
    return x.mT if is_tall else x
