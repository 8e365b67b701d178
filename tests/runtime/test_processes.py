"""Processes that are forked or started beside one that evaluates: no hang, and the same bits."""

import os
import subprocess
import sys
import threading
from typing import NamedTuple

import numpy as np
import pytest

from rna_sdk.machine import compiled as compiled_module
from rna_sdk.machine import kernel_threads as module
from rna_sdk.machine.compiled import compiled
from rna_sdk.machine.kernel_threads import at_most, kernel_threads, limit_kernel_threads, share
from tests.conftest import REPOSITORY

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
forks = pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork on this system")

STARTED = """
import multiprocessing, sys
import numpy as np
from rna_sdk.runtime import load

def light(path):
    asset = loaded.get(path) or load(path, threads=2)
    loaded[path] = asset
    mesh = asset.mesh
    hit = np.resize(np.arange(len(mesh.triangles)), 5000)
    u = np.full(len(hit), 1 / 3, np.float32)
    x, n = (a[mesh.triangles[hit]].mean(axis=1) for a in (mesh.positions, mesh.normals))
    up = np.tile(np.float32([0, 1, 0]), (len(n), 1))
    color = asset.base_color_at(hit, u, u)
    return asset.transport(x, n, n, up, n[:, 1] > 0, color).tobytes()

loaded = {}
if __name__ == "__main__":
    expected = light(sys.argv[1])
    for method in multiprocessing.get_all_start_methods():
        with multiprocessing.get_context(method).Pool(2) as pool:
            found = pool.map_async(light, [sys.argv[1]] * 3).get(timeout=300)
        assert found == [expected] * 3, method
"""

FORKS = """
import faulthandler, os, sys, threading
import numpy as np
sys.path.insert(0, sys.argv[1])
{before}
expected = call()

def forever():
    while True:
        call()

for _ in range(3):
    threading.Thread(target=forever, daemon=True).start()
for _ in range({count}):
    child = os.fork()
    if child == 0:
        faulthandler.dump_traceback_later(60, exit=True)
        os._exit(0 if np.array_equal(call(), expected) else 3)
    if os.waitpid(child, 0)[1]:
        os._exit(1)
os._exit(0)
"""

KERNELS = """
from rna_sdk.runtime import load
asset = load({path!r}, threads=2)
rows = np.random.default_rng(0).normal(size=(4, 2000, 3)).astype(np.float32)
white, u = np.ones((2000, 3), np.float32), np.full(2000, 0.3, np.float32)

def call():
    colors = asset.base_color_at(np.arange(2000) % len(asset.mesh.triangles), u, u)
    return np.stack([*asset.evaluate(*rows, white), colors])
"""
SESSION = """
from rna_sdk.runtime.engine.decoder_sessions import Graph
from rna_sdk.package import decoder_to_bytes
from tests.package.builders import random_decoder
graph = Graph(decoder_to_bytes(random_decoder(22, 256, 4)))
query = np.ones((1, graph.columns), np.float32)

def call():
    return graph.run(query)
"""
LOADS = """
from rna_sdk.runtime import load

def call():
    return load({path!r}).mesh.positions
"""
COMPILER = """
import itertools
from rna_sdk.machine.compiled import compiled
count = itertools.count()

def call():
    step = float(next(count))
    return compiled()(lambda x: x + step)(1.0) - step
"""


def test_all_ways_to_start_processes_give_the_parents_bits(tmp_path):
    """Code is on disk from the parent's call on; with fork the asset is the parent's own."""
    program = tmp_path / "started.py"
    program.write_text(STARTED)
    subprocess.run([sys.executable, str(program), str(TOY)], check=True, timeout=600)


@forks
@pytest.mark.parametrize(
    ("before", "count"),
    [
        (KERNELS.format(path=str(TOY)), 40),
        (LOADS.format(path=str(TOY)), 40),
        (SESSION, 150),
        (COMPILER, 5),
    ],
    ids=["kernels", "loads", "onnxruntime", "compiler"],
)
def test_a_fork_at_any_moment_does_not_hang(before, count):
    program = FORKS.format(before=before, count=count)
    command = [sys.executable, "-W", "ignore", "-c", program, str(REPOSITORY)]
    done = subprocess.run(command, timeout=600, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


OUTLIVES = """
import threading, time
{kernels}
expected = call()
main = threading.main_thread()

def late():
    main.join()
    time.sleep(0.2)
    print(np.array_equal(call(), expected))

threading.Thread(target=late).start()
"""


def test_a_thread_evaluates_after_the_main_thread_has_ended():
    """Executors refuse work by then: a RuntimeError reached the caller."""
    program = "import numpy as np\n" + OUTLIVES.format(kernels=KERNELS.format(path=str(TOY)))
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("True\n", "")


@compiled(rows="numbers results")
def _double(numbers: np.ndarray, results: np.ndarray) -> None:
    for i in range(len(numbers)):
        results[i] = 2 * numbers[i]


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("count", [0, 1, 1024, 1025, 100_003])
def test_threads_share_every_row_once(threads, count, monkeypatch):
    monkeypatch.setattr(module, "most_threads", lambda: 2)
    numbers, results = np.arange(count), np.full(count, -1)
    with at_most(threads):
        _double(numbers, results)
    np.testing.assert_array_equal(results, 2 * numbers)


class Rays(NamedTuple):
    mask: np.ndarray
    origins: np.ndarray


def test_arrays_for_all_rows_and_named_tuples_are_cut_as_they_should():
    rays = Rays(np.arange(1), np.arange(6))
    cut = compiled_module._cut(rays, slice(2, 4), 6)
    assert [len(array) for array in cut] == [1, 2] and type(cut) is Rays


def test_no_more_threads_take_part_than_the_caller_may(monkeypatch):
    monkeypatch.setattr(module, "most_threads", lambda: 3)
    seen: list[int] = []

    def run(starts) -> None:
        seen.append(threading.get_ident())
        for _ in starts:
            pass

    share(run, range(100), 1)
    assert seen == [threading.get_ident()]
    with at_most(None):
        assert limit_kernel_threads(None) == 3
        with at_most(1):
            assert kernel_threads() == 1
            with at_most(2):
                assert kernel_threads() == 1
        assert kernel_threads() == 3


def test_an_error_of_a_thread_is_raised_and_no_piece_is_begun_after_it():
    begun: list[int] = []

    def run(starts) -> None:
        for start in starts:
            begun.append(start)
            raise ValueError(start)

    with pytest.raises(ValueError):
        share(run, range(1000), 2)
    assert len(begun) <= 2


@forks
def test_a_forked_process_may_not_use_a_gpu_of_the_one_before():
    pytest.importorskip("wgpu")
    from rna_gpu import device
    from rna_sdk.errors import GpuError

    with pytest.raises(GpuError, match="spawn"):
        device._check_process(os.getpid() + 1)
    device._check_process(os.getpid())
