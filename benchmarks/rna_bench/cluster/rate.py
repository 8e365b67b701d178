"""Rate of captures and frames on a local Ray cluster, over that of local process pools.

    rna-bench cluster-rate examples/quickstart/toy.py examples/quickstart/scene.yaml \\
        --out benchmarks/results/cluster-rate.json

Both alternate in one run, as often as time permits, timed from when every worker has finished one
item: start-up of Ray, Blender and compilation is excluded.
"""

from __future__ import annotations

import argparse
import shutil
import statistics
import tempfile
import time
from collections.abc import Iterable
from functools import partial
from pathlib import Path
from typing import Any

from rna_bench.bench_options import add_out
from rna_bench.results import publish
from rna_export.capture.blender_process import blender_env
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.capture_worker import CaptureJob, CaptureWorker
from rna_export.capture.capture_run import CaptureWorkers, begin
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.capture_tasks import TrainingShard
from rna_export.capture.dataset.collect import Collector
from rna_render.command.frame_worker import Frame, FrameJob, FrameWorker
from rna_render.image.output import Output
from rna_render.scene import Scene, read_scene
from rna_render.world.scene_sources import carried_scene
from rna_sdk.cores import core_count
from rna_work.executors import Executor, open_executor
from rna_work.pool import Pool

FRAMES = 10  # those of a new process are slower at first


def seconds(pool: Pool[Any, Any], items: Iterable[Any], workers: int) -> float:
    """An item, from when every worker has finished one."""
    at_work: set[str] = set()
    ends: list[float] = []
    with pool:
        for outcome in pool.run(items):
            outcome.value()
            at_work.add(outcome.worker)
            if len(at_work) == workers:
                ends.append(time.perf_counter())
    return (ends[-1] - ends[0]) / (len(ends) - 1)


def capture_seconds(executor: Executor, source: Source, folder: Path, workers: int) -> float:
    """A shard of a capture."""
    capture_workers = CaptureWorkers(
        blender_env.find_python(), folder / "scratch", workers, executor
    )
    settings = {"lights": 32 * 12, "rays": 1024, "samples": 16, "validation_views": 1}
    dataset = begin(source, settings, folder / "a.rays", capture_workers, None, lambda line: None)
    carried = Collector.of(dataset, executor, None).carried()
    scratch = None if executor.far else capture_workers.scratch
    job = CaptureJob(carried, None, source, capture_workers.carried(source), scratch)
    tasks = [TrainingShard(k) for k in range(dataset.manifest.shards)]
    return seconds(Pool(capture_workers.backend(), partial(CaptureWorker, job)), tasks, workers)


def frame_seconds(executor: Executor, scene: Path, folder: Path) -> float:
    """A frame, by one worker with all cores."""
    size = {"samples": 8, "resolution": [640, 360]}
    turning = {"animation": {"frames": FRAMES, "turntable": {}}, **size}
    scene_file = read_scene(scene)
    data = scene_file.scene.model_dump(exclude={"animation", "samples", "resolution"}) | turning
    scene_file = scene_file.with_changes(**dict(Scene.model_validate(data)))
    backend, threads = executor.whole_machines(None)
    numbers, output = range(FRAMES), Output(folder / "%d.exr")
    files = carried_scene(scene_file, executor)
    job = FrameJob(scene_file, files, numbers, output, threads, time.perf_counter(), "cpu")
    frames = [Frame(number, str(number)) for number in numbers]
    return seconds(Pool(backend, partial(FrameWorker, job)), frames, 1)


def one_round(
    executors: list[tuple[str, Executor]], source: Source, scene: Path, workers: int
) -> dict[str, float]:
    """Seconds of a shard and of a frame by each executor, in this order."""
    found = {}
    for name, executor in executors:
        folder = Path(tempfile.mkdtemp())
        try:
            found[f"frames, {name}"] = frame_seconds(executor, scene, folder)
            found[f"capture, {name}"] = capture_seconds(executor, source, folder, workers)
        finally:
            shutil.rmtree(folder)
    return found


def report(rounds: list[dict[str, float]]) -> dict[str, Any]:
    """The rounds, and over them the medians of times and of ratios within a round."""
    medians = {name: statistics.median(r[name] for r in rounds) for name in rounds[0]}
    for kind in ("capture", "frames"):
        ratios = [r[f"{kind}, here"] / r[f"{kind}, ray"] for r in rounds]
        medians[f"{kind}, rate on Ray over rate here"] = statistics.median(ratios)
    return {"seconds": rounds, "median": medians}


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", type=Path, help="model to capture")
    parser.add_argument("scene", type=Path, help="scene file to render")
    parser.add_argument("--rounds", type=int, default=5, help="maximum number of rounds")
    parser.add_argument(
        "--minutes", type=float, default=5.5, help="time limit, after at least one round"
    )
    add_out(parser)


def run(args: argparse.Namespace) -> None:
    started, longest = time.monotonic(), 0.0
    workers = core_count()
    source = Source.captured(args.source, (), CaptureSettings())
    rounds: list[dict[str, float]] = []
    with open_executor(None) as here, open_executor("local") as there:
        executors = [("here", here), ("ray", there)]
        while len(rounds) < args.rounds:
            begun = time.monotonic()
            if rounds and begun - started + longest > 60.0 * args.minutes:
                break
            rounds.append(one_round(executors, source, args.scene, workers))
            executors.reverse()
            longest = max(longest, time.monotonic() - begun)
    publish(report(rounds), args)
