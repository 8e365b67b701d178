"""Cost of queries on this processor: measured once, then stored in the user's cache folder."""

import json
import time
from collections.abc import Callable
from hashlib import sha256
from pathlib import Path

import numpy as np

import rna_sdk
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.files.owned_folder import cache_folder
from rna_sdk.machine.cpu import processor_key

_REPEATS = 5


def cached_cost(measure: Callable[[], float], *what: object) -> float:
    """The cached result of `measure` for `what`, this processor and these versions.

    measure: called if there is no cached result. what: values whose `repr` identifies what is
    measured.
    """
    import onnxruntime  # loads with the first asset, not with this module

    versions = rna_sdk.__version__, onnxruntime.__version__
    key = sha256(repr((processor_key(), versions, what)).encode()).hexdigest()
    known = _read()
    if key not in known:
        known = {**known, key: measure()}
        _write(known)
    return known[key]


def median_seconds(
    action: Callable[[], object], clock: Callable[[], float] = time.perf_counter
) -> float:
    """Median duration of several calls, after one that warms caches."""
    action()
    seconds = []
    for _ in range(_REPEATS):
        start = clock()
        action()
        seconds.append(clock() - start)
    return float(np.median(seconds))


def _file() -> Path:
    return cache_folder() / "costs.json"


def _read() -> dict[str, float]:
    """The cached costs; none if the file is missing or damaged, or there is no home."""
    try:
        known = json.loads(_file().read_text())
        return {str(key): float(value) for key, value in known.items()}
    except (OSError, RuntimeError, ValueError, AttributeError, TypeError):
        return {}


def _write(known: dict[str, float]) -> None:
    """Replace the file; if it cannot be written, the next process measures again."""
    try:
        path = _file()
        path.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(path, json.dumps(known).encode())
    except (OSError, RuntimeError):
        pass
