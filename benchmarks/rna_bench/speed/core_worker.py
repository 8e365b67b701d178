"""Does one kind of work for as long as it is asked to; `cores.py` asks.

    python -m rna_bench.speed.core_worker NAME THREADS

It writes a line when it is ready. For each line that comes in, a number of seconds, it writes a
line of JSON: `rate`, a second. It is warm before the first one counts.
"""

import json
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path
from threading import Thread

import numpy as np

from rna_bench.checkout import QUICKSTART, ROOT, TOY

WORK = {
    "trainer": "steps/s",
    "rna-run": "samples of a pixel/s",
    "evaluate": "queries/s",
    "capture": "paths/s",
    "lobes": "steps/s",
}
"""Kind of work -> unit of its rate."""

Task = Callable[[float], float]
"""Works for about so many seconds; returns how much was done."""

_WARM = 3.0  # s
_SAMPLES = 1 << 18
_ROWS = 1 << 18
_RAYS, _PATHS = 4096, 16


def main() -> None:
    name, threads = sys.argv[1], int(sys.argv[2])
    makers = {
        "trainer": trainer,
        "rna-run": renderer,
        "evaluate": evaluation,
        "capture": capture,
        "lobes": lobes,
    }
    with makers[name](threads) as task:
        task(_WARM)
        print("ready", flush=True)
        for line in sys.stdin:
            begun = time.perf_counter()
            done = task(float(line))
            print(json.dumps({"rate": done / (time.perf_counter() - begun)}), flush=True)
            print("ready", flush=True)


def repeated(once: Callable[[], float]) -> Task:
    """A task that does something again and again."""

    def task(seconds: float) -> float:
        until, done = time.perf_counter() + seconds, 0.0
        while time.perf_counter() < until:
            done += once()
        return done

    return task


@contextmanager
def trainer(threads: int) -> Iterator[Task]:
    """Steps of `small` on random samples, as `rna-train` does them."""
    import torch

    from rna_export.machine import keep_freed_memory
    from rna_export.training.optimization.fitting import Fitting
    from rna_export.training.optimization.product_kernels import use_threads
    from rna_export.training.optimization.samples import SampleTable
    from rna_export.training.optimization.step_threads import StepThreads
    from rna_export.training.presets import PRESETS

    keep_freed_memory()
    preset = PRESETS["surface"]["small"].with_training(loss="log")
    batch = preset.training.batch
    table = SampleTable(_samples()).shuffled(batch, 0, 0)
    bounds = torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])
    fitting = Fitting(preset, bounds, 1.5, 0.5, table.fields)
    batches = iter(table)
    use_threads(threads)
    with StepThreads.of(fitting, (batch, batch)) as steps:

        def step() -> float:
            steps.run(partial(fitting.step, next(batches), 0.5))
            return 1.0

        yield repeated(step)


def _samples() -> dict[str, np.ndarray]:
    rng = np.random.default_rng(0)

    def directions() -> np.ndarray:
        v = rng.normal(size=(_SAMPLES, 3))
        return np.asarray(v / np.linalg.norm(v, axis=1, keepdims=True), np.float32)

    return {
        "position": rng.uniform(-1.0, 1.0, (_SAMPLES, 3)).astype(np.float32),
        **{name: directions() for name in ("normal", "wo", "wi")},
        "radiance": rng.random((_SAMPLES, 3), np.float32),
        "visible": np.ones(_SAMPLES, np.float32),
    }


@contextmanager
def renderer(threads: int) -> Iterator[Task]:
    """The quickstart's scene, a sample of every pixel at a time."""
    from rna_render import load_world, make_integrator, render
    from rna_render.scene import read_scene
    from rna_sdk.machine.kernel_threads import limit_kernel_threads

    limit_kernel_threads(threads)
    scene_file = read_scene(QUICKSTART)
    world = load_world(scene_file)
    scene = scene_file.resolved.model_copy(update={"samples": 1, "quality": None})
    integrator = make_integrator(scene, world)
    pixels = float(np.prod(scene.resolution))

    def sample() -> float:
        render(scene, integrator)
        return pixels

    yield repeated(sample)


@contextmanager
def evaluation(threads: int) -> Iterator[Task]:
    """Random queries of the quickstart's asset."""
    from rna_bench.one_part import load_one_part
    from rna_bench.speed.query_batches import random_points
    from rna_sdk.runtime import SurfaceAsset

    asset = load_one_part(TOY, threads=threads)
    assert isinstance(asset, SurfaceAsset)
    (low, high), (positions, normals, wo, wi) = asset.bounds, random_points(_ROWS)
    inside = (low + (positions + 1) / 2 * (high - low)).astype(np.float32)
    white = np.ones_like(inside)

    def batch() -> float:
        asset.evaluate(inside, normals, wo, wi, white)
        return float(_ROWS)

    yield repeated(batch)


@contextmanager
def capture(threads: int) -> Iterator[Task]:
    """Rays of the quickstart's source in Cycles, one worker a thread, as captures have them."""
    from rna_export.capture.blender_process import blender_env
    from rna_export.capture.blender_process.blender_process import Source
    from rna_export.capture.blender_process.blender_worker import BlenderWorker

    source, python = Source(ROOT / "examples" / "quickstart" / "toy.py"), blender_env.find_python()
    rng = np.random.default_rng(0)
    origins = rng.normal(size=(_RAYS, 3))
    origins *= 3.0 / np.linalg.norm(origins, axis=1, keepdims=True)
    targets = rng.uniform(-0.3, 0.3, (_RAYS, 3))
    origin, direction = origins.astype(np.float32), _unit(targets - origins)
    with tempfile.TemporaryDirectory() as scratch, ExitStack() as stack:
        blenders = [
            stack.enter_context(BlenderWorker(python, source, Path(scratch), 1, str(k)))
            for k in range(threads)
        ]

        def task(seconds: float) -> float:
            done = [0.0] * len(blenders)
            until = time.perf_counter() + seconds

            def work(k: int) -> None:
                while time.perf_counter() < until:
                    wi = _unit(np.array([0.3, 1.0, 0.2]))
                    blenders[k].render_rays(origin, direction, wi, _PATHS, int(done[k]))
                    done[k] += _RAYS * _PATHS

            workers = [Thread(target=work, args=(k,)) for k in range(len(blenders))]
            for one in workers:
                one.start()
            for one in workers:
                one.join()
            return sum(done)

        yield task


@contextmanager
def lobes(threads: int) -> Iterator[Task]:
    """Steps of a training of lobes, as `rna-export --environment` does them."""
    from rna_export.lobes.lobe_fit import fit_lobes
    from rna_export.lobes.lobe_model import LobeModel
    from rna_export.lobes.lobe_queries import QueryRows
    from rna_export.lobes.view_points import part_views
    from rna_export.training.optimization.pace import TimePace
    from rna_export.training.optimization.product_kernels import use_threads
    from rna_sdk.package import Package
    from rna_sdk.runtime import load

    use_threads(threads)
    asset = load(TOY, threads=1)
    (views,) = part_views(asset)
    with Package.open(TOY) as package:
        queries = QueryRows(package, asset.tier.name, 0, views.visibility_columns)
    model = LobeModel(queries.columns)

    def task(seconds: float) -> float:
        return fit_lobes(model, views, queries, [TimePace(seconds, time.monotonic())])

    yield task


def _unit(vectors: np.ndarray) -> np.ndarray:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True), np.float32)


if __name__ == "__main__":
    main()
