"""The memory that this process may use."""

import os
from pathlib import Path

from rna_sdk.errors import RnaError

_OF_CONTAINER = Path("/sys/fs/cgroup/memory.max")  # Linux' Documentation/admin-guide/cgroup-v2.rst


def check_memory(needed: int, what: str) -> None:
    """Raises RnaError where `what` takes more bytes than the machine, or the container, has.

    Linux promises any amount, and kills the process that uses it.
    """
    there = _memory()
    if there is not None and needed > there:
        raise RnaError(f"{what}: takes {needed / 1e9:.3g} GB of memory, found {there / 1e9:.3g} GB")


def _memory() -> int | None:
    """Bytes; None where the system does not tell."""
    try:
        result = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, ValueError, OSError):  # Windows has no sysconf
        return None
    try:
        return min(result, int(_OF_CONTAINER.read_text()))
    except (OSError, ValueError):  # no such file, or "max"
        return result
