"""The kernels' code on disk, and the threads of parallel kernels."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from numba import types
from numba.core.caching import IndexDataCacheFile

from rna_sdk.machine import compiled as module

REPOSITORY = Path(__file__).parent.parent

HELPERS = """
from llvmlite import ir
from numba import types
from numba.extending import intrinsic
from rna_sdk.machine.compiled import compiled

CONSTANT = {constant}

@compiled()
def called(x):
    return x + {called}

@compiled()
def called_by_name_of_the_module(x):
    return x + {called_by_name_of_the_module}

@intrinsic
def generated(typing_context, x):
    def generate(context, builder, signature, arguments):
        return builder.fadd(arguments[0], ir.Constant(ir.DoubleType(), _generated()))
    return types.float64(types.float64), generate

def _generated():
    return {generated}
"""
KERNEL = """
import numba
import numpy as np
import helpers
from numba import prange
from helpers import CONSTANT, called, generated
from rna_sdk.machine.compiled import callback, compiled

@compiled({options})
def fill(numbers):
    for i in prange(len(numbers)):
        numbers[i] = CONSTANT + called(0.0) + generated(0.0)
        numbers[i] += helpers.called_by_name_of_the_module(0.0)

@callback(numba.types.CPointer(numba.types.float64))
def told(numbers):
    numbers[0] = CONSTANT

numbers = np.empty(1)
fill(numbers)
assert told.address
print(numbers[0], sum(fill.stats.cache_hits.values()), told._cache_hits)
"""
NUMBERS = {"constant": 1.0, "called": 2.0, "called_by_name_of_the_module": 4.0, "generated": 8.0}


FORKING = """
import os, runpy, sys
import numba, numpy
import rna_sdk.machine.compiled

sys.dont_write_bytecode = True  # .pyc tell changes by the second
for line in iter(sys.stdin.readline, ""):
    folder = line.rstrip("\\n")
    child = os.fork()
    if child == 0:
        os.chdir(folder)
        sys.path.insert(0, folder)
        runpy.run_path(os.path.join(folder, "kernel.py"), run_name="__main__")
        sys.stdout.flush()
        os._exit(0)
    print("ended", os.waitpid(child, 0)[1], flush=True)
"""
"""Imports what all programs do once, before any thread, and runs each in a process of its own."""


@pytest.fixture(scope="module")
def forking():
    command, pipe = [sys.executable, "-c", FORKING], subprocess.PIPE
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True) as process:
        yield process
        process.stdin.close()


class Program:
    """KERNEL, which the folder may have already, and HELPERS; each run is a new process."""

    def __init__(self, forking: subprocess.Popen[str], folder: Path, options: str = "") -> None:
        self._forking, self._folder = forking, folder
        folder.mkdir(exist_ok=True)
        if not (folder / "kernel.py").exists():
            (folder / "kernel.py").write_text(KERNEL.format(options=options))

    def run(self, **numbers: float) -> list[float]:
        """What `fill` gives, and whether it and `told` came from disk."""
        (self._folder / "helpers.py").write_text(HELPERS.format(**{**NUMBERS, **numbers}))
        self._forking.stdin.write(f"{self._folder}\n")
        self._forking.stdin.flush()
        said = self._forking.stdout.readline()
        assert self._forking.stdout.readline() == "ended 0\n", said
        return [float(word) for word in said.split()]


def run(command: list[str], folder: Path, **environment: str) -> str:
    done = subprocess.run(
        command, cwd=folder, capture_output=True, text=True, env={**os.environ, **environment}
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def compiled_folder(forking, tmp_path_factory):
    """Folder of a program whose code is on disk, and counts in a copy, too."""
    folder = tmp_path_factory.mktemp("compiled")
    Program(forking, folder / "first").run()
    shutil.copytree(folder / "first", folder / "copy")
    assert Program(forking, folder / "copy").run() == [15.0, 1, 1]
    return folder / "copy"


@pytest.fixture
def compiled_copy(compiled_folder, tmp_path):
    """A copy of it, to be changed."""
    return shutil.copytree(compiled_folder, tmp_path / "copy")


@pytest.mark.parametrize("options", ["", "parallel=True", "numba.types.float64[::1]"])
def test_code_comes_from_disk_until_a_helper_changes(forking, tmp_path, options):
    program = Program(forking, tmp_path, options)
    assert [program.run(), program.run()] == [[15.0, 0, 0], [15.0, 1, 1]]
    assert [program.run(called=3.0), program.run(called=3.0)] == [[16.0, 0, 1], [16.0, 1, 1]]


@pytest.mark.parametrize(
    "damage",
    [
        lambda data: b"",
        lambda data: data[: len(data) // 2],
        lambda data: data[: len(data) // 2] + bytes(64) + data[len(data) // 2 + 64 :],
    ],
    ids=["empty", "cut", "changed"],
)
def test_damaged_code_is_compiled_again(forking, compiled_copy, damage):
    """As a power cut leaves it, or a bad disk."""
    program = Program(forking, compiled_copy)
    for suffix in (".nbi", ".nbc"):
        for path in compiled_copy.rglob(f"*{suffix}"):
            path.write_bytes(damage(path.read_bytes()))
        assert program.run() == [15.0, 0, 0]
    assert program.run() == [15.0, 1, 1]


@pytest.mark.parametrize("changed", NUMBERS)
def test_a_change_of_anything_compiled_in_is_seen(forking, compiled_copy, changed):
    result, from_disk, _ = Program(forking, compiled_copy).run(**{changed: 100.0})
    assert (result, from_disk) == (115.0 - NUMBERS[changed], 0)


def test_all_kernels_are_compiled_in_one_way():
    folders = ["rna_sdk", "runtime", "exporters", "benchmarks", "examples"]
    uses = re.compile(r"\b(jit|njit|cfunc|vectorize|guvectorize|CPUDispatcher|CFunc)\b")
    files = [file for folder in folders for file in (REPOSITORY / folder).rglob("*.py")]
    assert [str(f) for f in files if uses.search(f.read_text())] == [
        str(REPOSITORY / "rna_sdk" / "machine" / "compiled.py")
    ]


SIDE_BY_SIDE = """
import sys
from concurrent.futures import ThreadPoolExecutor
import numba
import numpy as np
from numba import prange
from rna_sdk.machine.compiled import compiled
from rna_sdk.errors import RnaError
{before}
@compiled(parallel=True)
def fill(numbers):
    for i in prange(len(numbers)):
        numbers[i] = np.sqrt(i)

try:
    with ThreadPoolExecutor(4) as pool:
        list(pool.map(fill, [np.empty(100_000) for _ in range(200)]))
    print(numba.threading_layer())
except RnaError as error:
    print(error)
"""


@pytest.mark.parametrize("layer", ["default", "workqueue", "omp"])
def test_parallel_kernels_may_run_side_by_side(tmp_path, layer):
    (tmp_path / "kernels.py").write_text(SIDE_BY_SIDE.format(before=""))
    output = run([sys.executable, "kernels.py"], tmp_path, NUMBA_THREADING_LAYER=layer)
    assert output.strip() in ("omp", "tbb")


QUOTA = """
import os
from rna_sdk.machine import cores
cores.core_count = lambda: 1
from rna_sdk.machine.numba_threads import launch_numba_threads
import numba
launch_numba_threads()
print(numba.get_num_threads(), os.environ["OMP_WAIT_POLICY"])
"""


def test_numba_has_no_more_threads_than_a_quota_and_they_sleep(tmp_path):
    """Numba's own number is that of the affinity."""
    names = "OMP_WAIT_POLICY", "NUMBA_NUM_THREADS"
    program = f"import os\nfor name in {names}:\n    os.environ.pop(name, None)\n"
    assert run([sys.executable, "-c", program + QUOTA], tmp_path) == "1 passive\n"


NO_SAFE_LAYER = """
for module in ("tbbpool", "omppool"):
    sys.modules["numba.np.ufunc." + module] = None
"""
UNSAFE_RUNS = """
numba.get_num_threads()
"""


@pytest.mark.parametrize(
    ("before", "expected"),
    [(NO_SAFE_LAYER, "pip install tbb"), (UNSAFE_RUNS, "NUMBA_THREADING_LAYER=threadsafe")],
    ids=["none", "unsafe"],
)
def test_without_safe_threads_one_line_says_what_to_do(tmp_path, before, expected):
    (tmp_path / "kernels.py").write_text(SIDE_BY_SIDE.format(before=before))
    output = run([sys.executable, "kernels.py"], tmp_path, NUMBA_THREADING_LAYER="workqueue")
    assert expected in output and len(output.splitlines()) == 1


def test_without_a_folder_for_code_kernels_work_and_one_warning_says_so(
    monkeypatch,
):
    """As from a read-only installation whose user has no home."""

    def refuse(*_: object) -> None:
        raise RuntimeError("cannot cache function: no locator available")

    monkeypatch.setattr(module._SourcesCache, "__init__", refuse)
    module._warn_of_no_cache.cache_clear()
    with pytest.warns(module.CacheWarning, match="NUMBA_CACHE_DIR") as warned:
        double = module.compiled()(lambda x: 2 * x)
        triple = module.compiled()(lambda x: 3 * x)
        module.callback(types.CPointer(types.float64))(lambda numbers: None)
    assert (double(2), triple(2), len(warned)) == (4, 6, 1)


def test_code_that_cannot_be_written_is_not_kept(monkeypatch):
    """The disk is full, or the folder is read-only by now."""

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(IndexDataCacheFile, "save", full)
    module._warn_of_no_cache.cache_clear()
    with pytest.warns(module.CacheWarning):
        assert module.compiled()(_quadrupled)(2) == 8


def _quadrupled(x: int) -> int:
    return 4 * x
