"""The viewer in headless Chromium against the CPU runtime: decoder queries and images.

    rna-bench viewer examples/quickstart/scene.yaml --repeats 3 --out benchmarks/results/viewer.json

WebGPU and WebGL2 run in a page each (`?bench=1`), in Chromium on SwiftShader, which it brings;
rna_gpu runs the same WGSL of the decoder on the GPU or driver that wgpu finds (lavapipe); then the
CPU runtime. All once a run, in turn; medians.

    queries_per_second    of the decoder alone, with random rows
    samples_per_second    of the whole picture: one sample of every pixel under all lights
    first_picture_ms      from opening the page to its first picture, the bundle in the cache
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path
from typing import Any

import numpy as np

import rna_gpu
from rna_bench.bench_options import add_out, add_repeats
from rna_bench.results import publish
from rna_bench.speed.gpu import measure
from rna_render import Integrator, load_world, make_integrator, render
from rna_render.scene import read_scene
from rna_sdk.errors import RnaError
from rna_view.site_source import site_for
from tests.render.chromium import INSTALL, SOFTWARE_GPU, find_chromium, open_page
from tests.web.pages import served

APIS = {"webgpu": "WebGPU on SwiftShader", "webgl2": "WebGL2 on SwiftShader"}
TIMEOUT_S = 600.0


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("scene", type=Path, help="scene file of one asset")
    parser.add_argument(
        "--resolution", type=int, nargs=2, default=(480, 270), help="width, height, pixels"
    )
    parser.add_argument("--rows", type=int, default=32_768, help="queries per call of the runtime")
    add_repeats(parser, 3)
    add_out(parser)


def run(args: argparse.Namespace) -> None:
    scene_file = read_scene(args.scene)
    scene = scene_file.resolved.model_copy(
        update={"resolution": tuple(args.resolution), "samples": 1}
    )
    integrator = make_integrator(scene, load_world(scene_file))
    device = rna_gpu.open_device()
    readings: dict[str, dict[str, list[float]]] = {}
    for _ in range(args.repeats):
        pages = {APIS[api]: in_chromium(args.scene, api, args.resolution) for api in APIS}
        rates = measure(scene_file.asset_path(0), device, args.rows, 1, None)
        both = rates["queries_per_second"]
        rate = samples_per_second(scene, integrator)
        pages["CPU runtime"] = {"queries_per_second": both["cpu"], "samples_per_second": rate}
        pages[f"rna_gpu on {device.name}"] = {"queries_per_second": both["gpu"]}
        for name, values in pages.items():
            for what, value in values.items():
                readings.setdefault(name, {}).setdefault(what, []).append(value)
    report = {
        "scene": str(args.scene),
        "resolution": list(args.resolution),
        "runs": args.repeats,
        "per_query": rates["per_query"],
        "medians": {
            name: {what: round(float(np.median(values)), 3) for what, values in own.items()}
            for name, own in readings.items()
        },
    }
    publish(report, args)


def in_chromium(scene: Path, api: str, resolution: tuple[int, int]) -> dict[str, float]:
    """The page's own measurements; it is opened twice, the second time from the cache."""
    chromium = find_chromium()
    if chromium is None:
        raise RnaError(INSTALL)
    with served(site_for(scene)) as server, open_page(chromium, *resolution, SOFTWARE_GPU) as page:
        address = f"{server.url}?api={api}&dpr=1&ui=0"
        for more in ("", "&bench=1"):
            page.call("Page.navigate", url=address + more)
            page.wait_for("globalThis.rnaViewer?.viewer?.hasShown", TIMEOUT_S)
        marks = page.evaluate("performance.getEntriesByName('picture')[0].startTime")
        line = page.wait_for("globalThis.rnaBenchmark", TIMEOUT_S)
    return {
        "queries_per_second": 1e6 * line["millionQueriesPerSecond"],
        "samples_per_second": 1e3 / line["msPerSample"],
        "first_picture_ms": marks,
    }


def samples_per_second(scene: Any, integrator: Integrator) -> float:
    """Samples per second of rna-run: of the second of two runs, since the first compiles."""
    for _ in range(2):
        begun = time.perf_counter()
        render(scene, integrator)
        seconds = time.perf_counter() - begun
    return 1.0 / seconds
