"""Speed of a real render on two cores against one.

    python benchmarks/threads.py --out benchmarks/results/threads.json

Prints JSON. The scene is that of the quickstart on a ground under a sky. Every run is a process of
its own, since the runtime and numba take their threads when they start, and is held to as many
cores as it has threads: else what is done between bands, such as adding them up, would have a
second core beside one thread. Runs on one and on two alternate, and medians are compared. Loading
and compiling are left out, and so is a first sample.

It needs an idle machine.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import subprocess
import sys
import time
from pathlib import Path
from statistics import median
from typing import Any

from report import publish, report_parser

QUICKSTART = Path(__file__).parent.parent / "examples" / "quickstart" / "scene.yaml"
TARGET = 1.85


def main() -> None:
    args = arguments()
    if args.worker:
        print(json.dumps(worker(args)))
        return
    runs: dict[str, list[float]] = {"1": [], "2": []}
    for _ in range(args.repeats):
        for threads, seconds in runs.items():
            seconds.append(in_process(threads, args))
    one, two = (median(seconds) for seconds in runs.values())
    paths = args.width * (args.width * 9 // 16) * args.samples
    report: dict[str, Any] = {
        "scene": "examples/quickstart on a ground, under a sky",
        "resolution": [args.width, args.width * 9 // 16],
        "samples": args.samples,
        "processor": platform.processor() or platform.machine(),
        "cores": os.cpu_count(),
        "load": [round(load, 2) for load in os.getloadavg()],
        "seconds": runs,
        "camera_paths_per_second": {"1": paths / one, "2": paths / two},
        "scaling": one / two,
        "target": TARGET,
    }
    publish(report, args.out)


def arguments() -> argparse.Namespace:
    parser = report_parser(
        description="Render the quickstart's scene on one and on two threads; prints JSON.",
        epilog="example: python benchmarks/threads.py --out threads.json",
    )
    parser.add_argument("--width", type=int, default=640, help="of the image, pixels")
    parser.add_argument("--samples", type=int, default=8, help="a pixel")
    parser.add_argument("--worker", help=argparse.SUPPRESS)
    return parser.parse_args()


def in_process(task: str, args: argparse.Namespace) -> float:
    command = [sys.executable, __file__, "--worker", task]
    command += ["--width", str(args.width), "--samples", str(args.samples)]
    environment = os.environ | {"NUMBA_NUM_THREADS": task}
    cores = set(sorted(os.sched_getaffinity(0))[: int(task)])
    result = subprocess.run(
        command,
        check=True,
        env=environment,
        stdout=subprocess.PIPE,
        preexec_fn=lambda: os.sched_setaffinity(0, cores),
    )
    return float(result.stdout)


def worker(args: argparse.Namespace) -> float:
    """Seconds that a render takes."""
    from rna_render.render import load_world, make_integrator, render
    from rna_render.scene_file import read_scene
    from rna_render.scene_model import GroundModel

    resolution = args.width, args.width * 9 // 16
    file = read_scene(QUICKSTART).with_changes(
        ground=GroundModel(), resolution=resolution, samples=args.samples
    )
    world = load_world(file)
    integrator = make_integrator(file.scene, world, resolve=file.resolve)
    render(file.scene.model_copy(update={"samples": 1}), integrator)
    start = time.perf_counter()
    render(file.scene, integrator)
    return time.perf_counter() - start


if __name__ == "__main__":
    main()
