"""Images are the same bits on any number of threads, in fresh processes."""

import ast
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import rna_render.paths.bands
from rna_render.command.rna_run import main
from rna_render.image.images import read_exr
from rna_render.materials.ggx_albedo import ALBEDO_ADDRESSES, ALBEDO_MEANS, ALBEDO_TABLE
from rna_render.paths.bands import rendered_bands
from rna_render.paths.integrator_factory import make_integrator
from rna_render.paths.sampling import Sampler
from rna_render.paths.world_in_time import load_world
from rna_render.scene.scene_file import read_scene
from rna_sdk.machine.kernel_threads import kernel_threads, limit_kernel_threads
from tests.conftest import REPOSITORY
from tests.render.whole_scenes import SCENES, write_scene

SAMPLES = 3  # memory that is used after it was freed has other contents a while later
EXAMPLES = sorted((REPOSITORY / "examples").glob("*/scene.yaml"))
SWITCH_INTERVAL = 1e-6
"""Seconds between switches of Python threads in a hurried process; Python's own are 5e-3."""

_RENDER = """
import sys
interval = float(sys.argv.pop(1))
if interval:
    sys.setswitchinterval(interval)
from rna_render.command.rna_run import main
sys.exit(main())
"""


@pytest.fixture(params=[*EXAMPLES, *SCENES], ids=[*(p.parent.name for p in EXAMPLES), *SCENES])
def scene(request, tmp_path):
    if isinstance(request.param, Path):
        return request.param
    return write_scene(tmp_path, request.param)


def test_two_threads_of_a_fresh_process_render_what_one_does(scene, tmp_path):
    assert differing(rendered(scene, 2, tmp_path), on_one_thread(scene, tmp_path)) == 0


def test_four_threads_that_switch_all_the_time(tmp_path):
    scene = REPOSITORY / "examples" / "jade" / "scene.yaml"
    actual = rendered(scene, 4, tmp_path, SWITCH_INTERVAL)
    assert differing(actual, on_one_thread(scene, tmp_path)) == 0


def options(out: Path, threads: int) -> list[str]:
    size = ["--resolution", "160x120", "--samples", str(SAMPLES)]
    return ["--out", str(out), *size, "--threads", str(threads)]


def rendered(
    scene: Path, threads: int, folder: Path, interval: float = 0.0
) -> dict[str, np.ndarray]:
    """The image that a fresh process renders; interval: between switches of Python threads, s."""
    out = folder / "fresh.exr"
    command = [sys.executable, "-c", _RENDER, str(interval), str(scene), *options(out, threads)]
    cores = str(max(threads, os.cpu_count() or 1))
    subprocess.run(command, env={**os.environ, "NUMBA_NUM_THREADS": cores}, check=True)
    return read_exr(out)[0]


def differing(actual: dict[str, np.ndarray], expected: dict[str, np.ndarray]) -> int:
    """Values of all channels that differ in any bit."""
    pairs = ((actual[name].view(np.uint32), expected[name].view(np.uint32)) for name in expected)
    return sum(int(np.count_nonzero(a != b)) for a, b in pairs)


def on_one_thread(scene: Path, folder: Path) -> dict[str, np.ndarray]:
    """The image that this process renders with one thread."""
    out, threads = folder / "out.exr", kernel_threads()
    try:
        assert main([str(scene), *options(out, 1)]) == 0
    finally:
        limit_kernel_threads(threads)
    return read_exr(out)[0]


@pytest.fixture
def hurried():
    interval = sys.getswitchinterval()
    sys.setswitchinterval(SWITCH_INTERVAL)
    yield
    sys.setswitchinterval(interval)


def test_small_bands_of_threads_that_switch_all_the_time(tmp_path, hurried, monkeypatch):
    scene_file = read_scene(write_scene(tmp_path, "everything"))
    world = load_world(scene_file)
    images = []
    for threads in (1, 2, 4, 8):
        monkeypatch.setattr(rna_render.paths.bands, "kernel_threads", lambda count=threads: count)
        renderer = make_integrator(scene_file.resolved, world)
        bands = rendered_bands(renderer, 40 * 28, [Sampler(0, 0)], most=64)
        images.append(np.concatenate([band.beauty for band, _, _ in bands]))
    assert all(np.array_equal(image, images[0], equal_nan=True) for image in images[1:])


def test_the_addresses_of_albedos_are_those_of_arrays_that_stay():
    owners = [ALBEDO_TABLE.ctypes.data, ALBEDO_MEANS.ctypes.data]
    assert ALBEDO_ADDRESSES.tolist() == owners


def test_no_cached_function_takes_an_address():
    """The memory that the address names may be another thread's, which lost the race."""
    for folder in ("rna_sdk", "runtime"):
        for path in (REPOSITORY / folder).rglob("*.py"):
            for function in ast.walk(ast.parse(path.read_text())):
                if isinstance(function, ast.FunctionDef) and _is_cached(function):
                    assert ".ctypes" not in ast.unparse(function), f"{path}: {function.name}"


def _is_cached(function: ast.FunctionDef) -> bool:
    return any("cache" in ast.unparse(decorator) for decorator in function.decorator_list)
