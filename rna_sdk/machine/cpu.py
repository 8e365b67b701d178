"""The processor of this process."""

import platform
from functools import cache
from hashlib import sha256

from rna_sdk.errors import QueryError
from rna_sdk.machine.cores import core_count


def processor() -> str:
    """The processor's name."""
    return _cpuinfo("model name") or platform.processor() or platform.machine()


@cache
def processor_key() -> str:
    """A key that differs between processors of the same name with different instructions."""
    flags = " ".join(sorted(_cpuinfo("flags").split()))
    return f"{processor()}, {sha256(flags.encode()).hexdigest()[:12]}"


def multiplies_bfloat16() -> bool:
    """Whether it has matrix instructions for bfloat16; False where Linux does not say."""
    return not {"avx512_bf16", "amx_bf16"}.isdisjoint(_cpuinfo("flags").split())


def _cpuinfo(name: str) -> str:
    """A member of the first processor in Linux's list; "" where there is none."""
    try:
        with open("/proc/cpuinfo") as file:
            return next(line.split(":", 1)[1].strip() for line in file if line.startswith(name))
    except (OSError, StopIteration):
        return ""


def thread_count(threads: int | None) -> int:
    """`threads`, or for None the number of cores available to this process.

    Raises:
        QueryError: `threads` is not a positive integer.
    """
    if threads is None:
        return core_count()
    if isinstance(threads, bool) or not isinstance(threads, int) or threads < 1:
        raise QueryError(f"threads: expected an integer of at least 1 or None, found {threads!r}")
    return threads
