"""Threads of trainings: those of our kernels and PyTorch's."""

from __future__ import annotations

import os

import torch

from rna_sdk.kernel_threads import kernel_threads, limit_kernel_threads

# MKL, which reads this at its first product, then sums in an order that does not depend on the
# number of threads: on Intel's processors it would share the rows of a sum among them.
os.environ.setdefault("MKL_CBWR", "AUTO,STRICT")


def use_threads(count: int) -> int:
    """Let kernels and PyTorch take `count` threads in the calling thread; returns how many.

    No more are taken than numba has.
    """
    count = limit_kernel_threads(count)  # first: numba's start sets OpenMP's number, torch's too
    torch.set_num_threads(count)
    return count


def threads_in_use() -> int:
    """Threads that both may take in the calling thread."""
    return min(kernel_threads(), torch.get_num_threads())
