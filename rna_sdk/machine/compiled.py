"""Compilation of all kernels, and invalidation of cached code."""

import inspect
import os
import pickle
import sys
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import cache, cached_property, partial
from hashlib import sha256
from inspect import unwrap
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any, TypeVar, cast

import numba
import numpy as np
from llvmlite.binding import ffi
from numba.core.caching import FunctionCache, IndexDataCacheFile
from numba.core.ccallback import CFunc
from numba.core.compiler_lock import global_compiler_lock
from numba.core.registry import CPUDispatcher

from rna_sdk.machine.kernel_threads import kernel_threads, share
from rna_sdk.machine.numba_threads import launch_numba_threads

Kernel = TypeVar("Kernel", bound=Callable[..., object])

_watchers: list[Callable[[bool], None]] = []


def _hold_compiler() -> None:
    """A fork waits while another thread compiles or frees: the locks would stay locked in it."""
    _compiler_lock.acquire()
    _llvm_lock.__enter__()


def _release_compiler() -> None:
    _llvm_lock.__exit__()
    _compiler_lock.release()


_compiler_lock: Any = global_compiler_lock
_llvm_lock: Any = ffi.lib._lock
if hasattr(os, "register_at_fork"):
    os.register_at_fork(
        before=_hold_compiler,
        after_in_parent=_release_compiler,
        after_in_child=_release_compiler,
    )


@contextmanager
def watched_compilations(watcher: Callable[[bool], None]) -> Iterator[None]:
    """A context in which `watcher` is called for each kernel that was not in the cache on disk.

    The thread that needs the kernel calls it with False before it is compiled, with True after.
    """
    _watchers.append(watcher)
    try:
        yield
    finally:
        _watchers.remove(watcher)


def compiled(
    *signature: numba.types.Type,
    rows: str = "",
    step: int = 1024,
    parallel: bool = False,
    inline: bool = False,
    fastmath: tuple[str, ...] = ("contract",),
) -> Callable[[Kernel], Kernel]:
    """Decorator: compile for these argument types, or for whatever comes where none are given.

    A kernel is compiled when it is first called.

    rows: names of arguments, divided by blanks, whose rows are independent of one another; what
    Python calls is then a `RowKernel`, whose threads share them, a multiple of `step` at a time.
    parallel: share loops over `prange` among numba's threads, for what no host calls: they cannot
    be used in a forked process. inline: copy it into the kernels
    that call it; a call takes 10 to 20 ns if it passes tuples or arrays. fastmath: liberties of
    LLVM's; by default fused multiply-add alone, so NaN and infinity keep their meaning.

    Kernels let other Python threads run, keep their code on disk for the next process, and
    divide as IEEE 754 has it. The code on disk is renewed when anything that is compiled into
    it changes, in whatever file.
    """
    cache_type: Any = _ParallelCache if parallel else _SourcesCache
    options = {
        "nopython": True,
        "nogil": True,
        "error_model": "numpy",
        "parallel": parallel,
        "inline": "always" if inline else "never",
        "fastmath": set(fastmath),
        "no_cfunc_wrapper": True,
    }

    def compile_kernel(function: Kernel) -> Kernel:
        kernel: Any = _Kernel(function, targetoptions=options)
        if (code := _cache_of(cache_type, function)) is not None:
            kernel._cache = code
        if signature:
            kernel._compile_for_args = partial(_compile_declared, kernel, signature)
        result: Any = RowKernel(kernel, rows.split(), step) if rows else kernel
        return cast(Kernel, result)

    return compile_kernel


class _Kernel(CPUDispatcher):
    """The function that Python calls; kernels call a twin without the wrapper for Python.

    The wrapper takes half the compilation of a short kernel. A twin's code is on disk within that
    of its callers alone.
    """

    @cached_property
    def _twin(self) -> Any:
        options = {**self.targetoptions, "no_cpython_wrapper": True}
        return CPUDispatcher(self.py_func, targetoptions=options)

    @property
    def _numba_type_(self) -> Any:
        return self._twin._type


def _compile_declared(kernel: Any, signature: tuple[Any, ...], *_arguments: Any) -> Any:
    """numba calls this for arguments of a kernel without code; returns the function to call."""
    with global_compiler_lock:
        if not kernel.signatures:
            kernel.compile(numba.void(*signature))
            kernel.disable_compile()
    return kernel


class RowKernel:
    """A kernel whose rows the threads that the caller may take share: `kernel_threads`."""

    def __init__(self, kernel: Any, rows: list[str], step: int) -> None:
        """rows: names of arguments with a row each. step: rows that are not worth a division."""
        names = list(inspect.signature(kernel.py_func).parameters)
        self._places, self._step = [names.index(name) for name in rows], step
        self.kernel, self.__wrapped__ = kernel, kernel.py_func

    def __call__(self, *arguments: Any) -> None:
        first = arguments[self._places[0]]
        count = len(first[0] if isinstance(first, tuple) else first)
        threads = kernel_threads()
        if threads == 1 or count <= self._step:
            self.kernel(*arguments)
            return
        size = -(-count // (_PIECES * threads * self._step)) * self._step

        def run(starts: Iterator[int]) -> None:
            piece = list(arguments)
            for start in starts:
                for k in self._places:
                    piece[k] = _cut(arguments[k], slice(start, start + size), count)
                self.kernel(*piece)

        share(run, range(0, count, size), threads)


_PIECES = 4
"""Pieces of the rows a thread; small last pieces leave few threads idle."""


def _cut(argument: Any, rows: slice, count: int) -> Any:
    """The rows of an array of `count`, or of those in a named tuple; others are of all rows."""
    if isinstance(argument, tuple):
        return type(argument)(*(_cut(array, rows, count) for array in argument))
    return argument[rows] if len(argument) == count else argument


def callback(*signature: numba.types.Type) -> Callable[[Kernel], Any]:
    """Decorator: a C function of these argument types, compiled when its `address` is asked for.

    Its code on disk is renewed as for `compiled`.
    """
    cache_type: Any = _SourcesCache

    def compile_callback(function: Kernel) -> Any:
        result: Any = _Callback(function, (signature, numba.void), {}, {})
        if (code := _cache_of(cache_type, function)) is not None:
            result._cache = code
        return result

    return compile_callback


class _Callback(CFunc):
    @cached_property
    def address(self) -> int:
        """Where it starts."""
        function: Any = self
        function.compile()
        return int(function._wrapper_address)


class CacheWarning(UserWarning):
    """Compiled code cannot be cached for the next process."""


def _cache_of(cache_type: Any, function: Callable[..., object]) -> Any:
    """The cache on disk of a kernel; None, with a warning once a process, where there is none."""
    try:
        return cache_type(function)
    except RuntimeError:  # numba found no folder that it may write to
        _warn_of_no_cache()
        return None


@cache
def _warn_of_no_cache() -> None:
    message = (
        "compiled kernels are not kept, so that each process compiles them again: neither the "
        "installation nor the user's cache folder can be written; set NUMBA_CACHE_DIR to a folder "
        "that can"
    )
    warnings.warn(message, CacheWarning, stacklevel=2)


class _HashedFile(IndexDataCacheFile):
    """Numba's files of code, with a hash: LLVM may crash on damaged code."""

    def _save_data(self, name: str, data: Any) -> None:
        code = self._dump(data)  # type: ignore[no-untyped-call]
        super()._save_data(name, (sha256(code).digest(), code))  # type: ignore[no-untyped-call]

    def _load_data(self, name: str) -> Any:
        digest, code = super()._load_data(name)  # type: ignore[no-untyped-call]
        if sha256(code).digest() != digest:
            raise ValueError(f"{name} is damaged")
        return pickle.loads(code)


class _SourcesCache(FunctionCache):
    """Numba's cache on disk, renewed when a source or a constant of the kernel changes.

    A kernel holds a compiled copy of what it calls and names in other files; numba's own cache
    is renewed when the kernel's own file changes, and would go on with the old copy. Numba has
    no setting for this; `tests/test_compiled.py` watches that its internals still answer to it.
    """

    def __init__(self, function: Callable[..., object]) -> None:
        super().__init__(function)  # type: ignore[no-untyped-call]
        stamp = self._impl.locator.get_source_stamp()
        file_type: Any = _HashedFile
        self._cache_file = file_type(self._cache_path, self._impl.filename_base, stamp)

    @cached_property
    def _sources(self) -> str:
        return _digest_of_sources(self._py_func)

    def _index_key(self, signature: Any, codegen: Any) -> tuple[Any, ...]:
        key = super()._index_key(signature, codegen)  # type: ignore[no-untyped-call]
        return (*key, self._sources)

    def load_overload(self, signature: Any, target_context: Any) -> Any:
        """The code on disk; None, so that it is compiled, where that is missing or damaged."""
        code: Any = None
        try:
            code = super().load_overload(signature, target_context)  # type: ignore[no-untyped-call]
        except Exception:  # whatever damaged bytes make pickle raise
            with suppress(OSError):
                self.flush()  # type: ignore[no-untyped-call]
        if code is None:
            _tell_watchers(False)
        return code

    def save_overload(self, signature: Any, data: Any) -> None:
        """Keeps the code, unless the disk is full or the folder can no longer be written."""
        _tell_watchers(True)
        try:
            super().save_overload(signature, data)  # type: ignore[no-untyped-call]
        except Exception:  # a damaged index that cannot be written raises as above
            _warn_of_no_cache()


def _tell_watchers(is_compiled: bool) -> None:
    for watcher in _watchers:
        watcher(is_compiled)


class _ParallelCache(_SourcesCache):
    """Launches numba's threads before numba itself would, and in a safe way."""

    def load_overload(self, signature: Any, target_context: Any) -> Any:
        launch_numba_threads()
        return super().load_overload(signature, target_context)


def _digest_of_sources(kernel: FunctionType) -> str:
    """Digest of this file and of the files and constants of all functions `kernel` reaches."""
    reached, pending = {kernel}, [kernel]
    parts = {_digest_of_file(__file__)}
    while pending:
        function = pending.pop()
        parts.add(_digest_of_file(function.__code__.co_filename))
        for name, value in _named_values(function):
            if isinstance(value, _CONSTANTS):
                parts.add(f"{name} = {value!r}".encode())
            elif isinstance(value, np.ndarray):
                parts.add(f"{name} = {value.dtype.str}{value.shape}".encode() + value.tobytes())
            elif (called := _source_of(value)) is not None and called not in reached:
                reached.add(called)
                pending.append(called)
    return sha256(b"\0".join(sorted(parts))).hexdigest()


_CONSTANTS = (bool, int, float, complex, str, bytes, tuple, np.generic)
_LIBRARIES = sys.stdlib_module_names | {"numba", "numpy", "llvmlite"}


@cache
def _digest_of_file(path: str) -> bytes:
    return sha256(Path(path).read_bytes()).digest()


def _source_of(value: object) -> FunctionType | None:
    """The function behind a kernel, an intrinsic or a function; None for a library's, or none."""
    function = unwrap(value) if callable(value) else None
    if not isinstance(function, FunctionType):
        return None
    return None if function.__module__.partition(".")[0] in _LIBRARIES else function


def _named_values(function: FunctionType) -> Iterator[tuple[str, object]]:
    """The globals and closed-over variables that the code names, and attributes of modules."""
    if function.__closure__:
        for name, cell in zip(function.__code__.co_freevars, function.__closure__, strict=True):
            yield name, cell.cell_contents
    names = _names(function.__code__)
    values = [(name, function.__globals__[name]) for name in names & function.__globals__.keys()]
    for name, value in values:
        yield name, value
        if isinstance(value, type(sys)) and value.__name__.partition(".")[0] not in _LIBRARIES:
            yield from ((f"{name}.{n}", getattr(value, n)) for n in names & vars(value).keys())


def _names(code: CodeType) -> set[str]:
    """Names of globals and attributes used in this code and in nested functions."""
    inside = [constant for constant in code.co_consts if isinstance(constant, CodeType)]
    return set(code.co_names).union(*map(_names, inside))
