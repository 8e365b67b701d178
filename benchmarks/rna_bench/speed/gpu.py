"""Queries/s and images on a GPU and on the CPU, with flop and bytes per query for a roofline.

    rna-bench gpu examples/quickstart/toy.rna examples/fibers/curly_ball.rna \\
        --scenes examples/quickstart/scene.yaml --out benchmarks/results/gpu.json

One run, alternating; medians. `gpu` and `cpu` evaluate numpy arrays; `resident` are queries that
are on the GPU and whose results stay there. Arithmetic counts multiply-adds of the decoder twice,
and those of the bilinear lookups; bytes are those of texels, row and result, without caches.
Weights are read once a workgroup at best, and once a query at worst: both are given. Seconds of an
image are those of its samples, without loading; the first image on the GPU compiles the shaders.
The CPU renders 2 samples a pixel; its seconds are scaled to all of them.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import rna_gpu
from rna_bench.bench_options import add_out
from rna_bench.one_part import load_one_part
from rna_bench.results import publish
from rna_bench.speed.query_batches import random_queries
from rna_gpu import Device, GpuAsset, GpuFiber, GpuSurface
from rna_gpu.scene.rendering import GpuRenderer
from rna_render import Integrator, load_world, make_integrator, render
from rna_render.scene import Scene, read_scene

DISPATCHES = 32  # of one reading of the resident rate
CPU_SAMPLES = 2
TEXELS = 12  # that a query reads
ROW, RESULT, GROUP = 64, 32, 64  # bytes, bytes, threads


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("packages", nargs="+", type=Path, help="of one part each")
    parser.add_argument("--rows", type=int, default=32_768, help="queries per run")
    parser.add_argument("--runs", type=int, default=5, help="runs of each")
    parser.add_argument("--scenes", nargs="*", type=Path, default=[], help="scene files to render")
    parser.add_argument(
        "--resolution", type=int, nargs=2, default=(1920, 1080), help="of images, pixels"
    )
    parser.add_argument("--samples", type=int, default=16, help="of images, per pixel")
    parser.add_argument("--threads", type=int, default=None, help="of the CPU (default: all)")
    add_out(parser)


def run(args: argparse.Namespace) -> None:
    device = rna_gpu.open_device()
    measured = [measure(path, device, args.rows, args.runs, args.threads) for path in args.packages]
    result = {"gpu": device.name, "rows": args.rows, "packages": measured}
    if args.scenes:
        size = {"resolution": tuple(args.resolution), "samples": args.samples}
        images = [image_seconds(path, size, args.runs) for path in args.scenes]
        result |= size | {"images": images}
    publish(result, args)


def measure(
    path: Path, device: Device, rows: int, runs: int, threads: int | None
) -> dict[str, Any]:
    """One package of one part, in its first tier."""
    cpu = load_one_part(path, threads=threads)
    gpu = rna_gpu.load(path, device=device)
    assert not isinstance(gpu, GpuAsset)
    arguments = random_queries(cpu, rows)
    calls: dict[str, Callable[[], object]] = {
        "gpu": lambda: gpu.evaluate(*arguments),
        "cpu": lambda: cpu.evaluate(*arguments),
    }
    seconds: dict[str, list[float]] = {name: [] for name in calls}
    for run in range(runs + 1):  # the first one compiles
        for name, call in calls.items():
            start = time.perf_counter()
            call()
            if run:
                seconds[name].append(time.perf_counter() - start)
    rates = {name: rows / float(np.median(values)) for name, values in seconds.items()}
    rates["resident"] = resident_rate(gpu, runs)
    return {
        "package": path.name,
        "tier": cpu.tier.name,
        "queries_per_second": {name: round(rate) for name, rate in rates.items()},
        "gpu_over_cpu": round(rates["gpu"] / rates["cpu"], 4),
        "per_query": _cost(gpu, cpu),
    }


def resident_rate(gpu: GpuSurface | GpuFiber, runs: int) -> float:
    """Queries/s of dispatches of a full batch each, rows and results staying on the GPU."""
    batch = gpu.transport.batch
    rows = gpu.new_rows(batch)
    numbers = np.random.default_rng(2).uniform(-0.3, 0.3, (batch, ROW // 4)).astype(np.float32)
    gpu.device.write(rows.rows, numbers)
    gpu.device.write(rows.count, np.array([batch], np.uint32))
    seconds = []
    for _ in range(runs + 1):
        start = time.perf_counter()
        for _ in range(DISPATCHES):
            gpu.evaluate_on_gpu(rows, most=batch)
        gpu.device.read(rows.results, 4)  # waits for all of them
        seconds.append(time.perf_counter() - start)
    return DISPATCHES * batch / float(np.median(seconds[1:]))


def image_seconds(path: Path, size: dict[str, Any], runs: int) -> dict[str, Any]:
    """Seconds of a scene's image: the first on the GPU, and the median of later ones on both."""
    scene_file = read_scene(path).with_changes(**size)
    scene, world = scene_file.resolved, load_world(scene_file)
    short = scene.model_copy(update={"samples": CPU_SAMPLES})
    renderers: dict[str, tuple[Scene, GpuRenderer | Integrator, float]] = {
        "gpu": (scene, GpuRenderer(scene, world), 1.0),
        "cpu": (short, make_integrator(short, world), scene.samples / CPU_SAMPLES),
    }
    seconds: dict[str, list[float]] = {name: [] for name in renderers}
    for _ in range(runs + 1):
        for name, (each, renderer, times) in renderers.items():
            start = time.perf_counter()
            render(each, renderer)
            seconds[name].append((time.perf_counter() - start) * times)
    medians = {name: float(np.median(values[1:])) for name, values in seconds.items()}
    return {
        "scene": path.parent.name,
        "first_on_gpu_s": round(seconds["gpu"][0], 3),
        **{f"{name}_s": round(value, 3) for name, value in medians.items()},
        "gpu_over_cpu": round(medians["cpu"] / medians["gpu"], 2),
    }


def _cost(gpu: Any, cpu: Any) -> dict[str, float]:
    part = gpu.tier_part
    texel = part.channels * {"int8": 1, "float16": 2, "float32": 4}[part.plane_precision]
    arithmetic = 2 * gpu.multiply_adds + TEXELS * 2 * part.channels
    streamed = TEXELS * texel + ROW + RESULT
    weights = 4 * gpu.multiply_adds
    return {
        "multiply_adds": gpu.multiply_adds,
        "flop": arithmetic,
        "bytes_streamed": streamed,
        "bytes_with_weights_once_a_workgroup": streamed + weights / GROUP,
        "bytes_with_weights_once_a_query": streamed + weights,
        "flop_per_byte": round(arithmetic / (streamed + weights / GROUP), 1),
    }
