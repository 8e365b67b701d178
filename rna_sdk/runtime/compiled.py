"""How every kernel of the runtime is compiled."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import numba

Kernel = TypeVar("Kernel", bound=Callable[..., object])


def compiled(*signature: numba.types.Type) -> Callable[[Kernel], Kernel]:
    """Decorator: compile for these argument types, or for whatever comes where none are given.

    Kernels let other Python threads run, keep their code on disk for the next process, and
    divide as IEEE 754 has it. Of the fast-math liberties they take only fused multiply-add:
    NaN and infinity keep their meaning. A kernel on disk is compiled anew when its own file
    changes, so a kernel and what it inlines stand in one file.
    """
    jit: Any = numba.njit(
        [numba.void(*signature)] if signature else None,
        nogil=True,
        cache=True,
        error_model="numpy",
        fastmath={"contract"},
    )

    def compile_kernel(function: Kernel) -> Kernel:
        kernel: Kernel = jit(function)
        return kernel

    return compile_kernel
