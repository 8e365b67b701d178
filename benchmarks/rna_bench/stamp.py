"""Conditions of a result: commit, machine, load, date, command."""

import os
import platform
import shlex
import subprocess
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from rna_bench.checkout import ROOT

_FEATURES = {
    "avx2": "AVX2",
    "avx512f": "AVX-512",
    "avx512vnni": "AVX-512 VNNI",
    "avxvnni": "AVX-VNNI",
    "neon": "NEON",
}


def stamp(arguments: Sequence[str]) -> dict[str, Any]:
    """Taken as a command starts; its own work is not in the load.

    arguments: those after `rna-bench`. Absolute paths are shortened, since results are shared: to
    what they are in the repository, else to their last part.
    """
    from rna_sdk.machine.cores import core_count
    from rna_sdk.machine.cpu import processor

    return {
        "command": shlex.join(["rna-bench", *map(_shortened, arguments)]),
        "commit": commit(ROOT),
        "date": datetime.now(UTC).isoformat(timespec="seconds"),
        "cpu": processor(),
        "cpu_features": cpu_features(),
        "cores": core_count(),
        "load": [round(load, 2) for load in os.getloadavg()],
        "system": f"{platform.system()} {platform.machine()}, Python {platform.python_version()}",
    }


def commit(root: Path) -> str:
    """Commit of the checkout, with "+changes" if it is modified; "unknown" without git."""
    try:
        head = _git(root, "rev-parse", "--short=12", "HEAD")
        return head + ("+changes" if _git(root, "status", "--porcelain") else "")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def cpu_features() -> list[str]:
    """Vector instruction sets of the CPU that decide the speed."""
    from llvmlite import binding

    if restricted := os.environ.get("NUMBA_CPU_NAME"):  # as by tests/avx2
        return [f"restricted to {restricted}"]
    seen = binding.get_host_cpu_features()
    return [name for feature, name in _FEATURES.items() if seen.get(feature)]


def _git(root: Path, *arguments: str) -> str:
    done = subprocess.run(["git", "-C", root, *arguments], capture_output=True, check=True)
    return done.stdout.decode().strip()


def _shortened(argument: str) -> str:
    path = Path(argument)
    if not path.is_absolute():
        return argument
    return str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else path.name
