"""The kernels' code on disk."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

from rna_sdk.runtime import compiled

HELPER = """
from compiled import compiled

@compiled()
def answer(x):
    return x + {number}
"""
KERNEL = """
import numba
import numpy as np
from compiled import compiled
from helper import answer

@compiled(numba.types.float64[::1])
def fill(numbers):
    numbers[0] = answer(0.5)

numbers = np.empty(1)
fill(numbers)
print(numbers[0], sum(fill.stats.cache_hits.values()))
"""


def test_a_change_in_another_file_is_compiled_and_all_else_comes_from_disk(tmp_path: Path) -> None:
    def run(number: int) -> str:
        (tmp_path / "helper.py").write_text(HELPER.format(number=number))
        command = [sys.executable, "kernel.py"]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
        return done.stdout.strip()

    shutil.copy(compiled.__file__, tmp_path)
    (tmp_path / "kernel.py").write_text(KERNEL)
    assert [run(1), run(1), run(2), run(2)] == ["1.5 0", "1.5 1", "2.5 0", "2.5 1"]
