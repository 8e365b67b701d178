"""How every kernel of the runtime is compiled."""

from __future__ import annotations

from collections.abc import Callable
from hashlib import sha256
from pathlib import Path
from typing import Any, TypeVar

import numba
from numba.core.caching import FunctionCache

Kernel = TypeVar("Kernel", bound=Callable[..., object])


def compiled(*signature: numba.types.Type) -> Callable[[Kernel], Kernel]:
    """Decorator: compile for these argument types, or for whatever comes where none are given.

    Kernels let other Python threads run, keep their code on disk for the next process, and
    divide as IEEE 754 has it. Of the fast-math liberties they take only fused multiply-add:
    NaN and infinity keep their meaning.
    """
    jit: Any = numba.njit(nogil=True, error_model="numpy", fastmath={"contract"})

    def compile_kernel(function: Kernel) -> Kernel:
        kernel: Any = jit(function)
        kernel._cache = _RuntimeCache(function)  # type: ignore[no-untyped-call]
        if signature:
            kernel.compile(numba.void(*signature))
            kernel.disable_compile()
        result: Kernel = kernel
        return result

    return compile_kernel


class _RuntimeCache(FunctionCache):
    """Numba's cache on disk, renewed when any file of the runtime changes.

    A kernel holds a compiled copy of what it calls in other files; numba's own cache is renewed
    when the kernel's own file changes, and would go on with the old copy. Numba has no setting
    for this; `tests/runtime/test_compiled.py` watches that its internals still answer to it.
    """

    def _index_key(self, signature: Any, codegen: Any) -> tuple[Any, ...]:
        key = super()._index_key(signature, codegen)  # type: ignore[no-untyped-call]
        return (*key, _SOURCES)


def _digest_of_sources() -> str:
    files = sorted(Path(__file__).parent.glob("*.py"))
    return sha256(b"".join(file.read_bytes() for file in files)).hexdigest()


_SOURCES = _digest_of_sources()
