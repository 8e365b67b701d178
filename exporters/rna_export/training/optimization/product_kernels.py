"""Products of matrices whose bits do not depend on the number of threads."""

import os
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from rna_export.training.optimization.muon import orthogonalised
from rna_sdk.machine.compiled import compiled
from rna_sdk.machine.kernel_threads import kernel_threads
from rna_sdk.machine.numba_threads import limit_all_threads

# MKL, which reads this at its first product, then sums in an order that does not depend on the
# number of threads: on Intel's processors it would share the rows of a sum among them.
os.environ.setdefault("MKL_CBWR", "AUTO,STRICT")


def use_threads(count: int) -> int:
    """Let kernels and PyTorch take `count` threads in the calling thread; returns how many.

    No more are taken than numba has.
    """
    count = limit_all_threads(count)  # first: numba's start sets OpenMP's number, torch's too
    torch.set_num_threads(count)
    return count


def threads_in_use() -> int:
    """Threads that both may take in the calling thread."""
    return min(kernel_threads(), torch.get_num_threads())


_NARROW = 12  # columns: of such products BLAS shares the sum over rows among its threads


def weight_gradient(gradient: Tensor, value: Tensor) -> Tensor:
    """gradient.t() @ value, (b, a), of (n, b) and (n, a)."""
    if gradient.shape[1] > _NARROW or gradient.dtype != torch.float32 or gradient.is_cuda:
        return gradient.t() @ value
    product = torch.zeros(gradient.shape[1], value.shape[1])
    _add_products(gradient.contiguous().numpy(), value.contiguous().numpy(), product.numpy())
    return product


@compiled()
def _add_products(
    gradient: NDArray[np.float32], value: NDArray[np.float32], product: NDArray[np.float32]
) -> None:
    """In the order of the rows."""
    for i in range(len(gradient)):
        for k in range(gradient.shape[1]):
            g = gradient[i, k]
            for c in range(value.shape[1]):
                product[k, c] += g * value[i, c]


class Product(NamedTuple):
    """A linear layer's: rows, columns in and out, type of the factors."""

    rows: int
    columns_in: int
    columns_out: int
    dtype: torch.dtype


def products_repeat(products: Iterable[Product], stacks: Iterable[Tensor], most: int) -> bool:
    """Whether a step's products have the same bits with one thread and with `most`.

    BLAS may share a sum among threads; where it does so depends on sizes and processor. products:
    of layers, forwards and backwards. stacks: like those that Muon orthogonalises. Leaves `most`
    threads in use.
    """
    generator, factors = torch.Generator().manual_seed(0), []
    for n, a, b, dtype in dict.fromkeys(products):
        sizes = (n, a), (n, b), (b, a), (b,)
        factors.append([torch.randn(size, generator=generator).to(dtype) for size in sizes])
    directions = [torch.randn(s.shape, generator=generator).to(s.dtype) for s in stacks]
    result = []
    for count in (1, most):
        use_threads(count)
        layers = [p for each in factors for p in _products(*each)]
        result.append([*layers, *map(orthogonalised, directions)])
    return all(torch.equal(one, other) for one, other in zip(*result, strict=True))


def _products(x: Tensor, gradient: Tensor, weight: Tensor, bias: Tensor) -> list[Tensor]:
    """Matrix products of a layer, forwards and backwards."""
    forwards = torch.addmm(bias, x, weight.t())
    return [forwards, weight_gradient(gradient, x), gradient.sum(dim=0), gradient @ weight]
