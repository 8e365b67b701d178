"""Memory of a page that adds assets to a three.js scene, draws and disposes of them for minutes.

    rna-bench three examples/quickstart/toy.rna spec/conformance/packages/fiber-float16.rna \\
        --out benchmarks/results/three.json

The page imports the packed rna-three, in headless Chromium on SwiftShader, which keeps the GPU's
memory in a process of its own. A round loads the next package, adds it, a clone and two instances
under a directional light with shadows, draws, and disposes of all. After garbage collection,
about every `--every` seconds:

    objects    buffers, textures, geometries and programs in three.js' `renderer.info.memory`
    heap_mb    JavaScript's heap in use
    page_mb    resident memory of the page's process
    gpu_mb     resident memory of the GPU's process

`later_over_earlier`: medians of the last quarter of the run by those of the second.
"""

from __future__ import annotations

import argparse
import os
import resource
import shutil
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.bench_options import add_out
from rna_bench.results import publish
from rna_sdk.errors import RnaError
from tests.render.chromium import INSTALL, Page, find_chromium
from tests.web.pages import TIMEOUT
from tests.web.three.pages import PAGE, installed, opened

SIZE = (16, 10)
ROUND = """(async () => {{
    const {{ THREE, rna, renderer, shoot }} = test;
    renderer.shadowMap.enabled = true;
    const asset = await new rna.RnaLoader().loadAsync("{name}");
    const scene = new THREE.Scene(), sun = new THREE.DirectionalLight(0xffffff, 2);
    const clone = asset.clone(), instanced = asset.instanced(2);
    sun.castShadow = true;
    sun.position.set(1, 2, 1);
    clone.position.x = 1;
    const behind = new THREE.Matrix4().makeTranslation(0, 0, -1);
    for (const mesh of instanced) mesh.setMatrixAt(1, behind);
    scene.add(sun, asset, clone, ...instanced);
    const camera = new THREE.PerspectiveCamera(50, {width} / {height}, 0.1, 10);
    camera.position.set(1, 1, 3);
    camera.lookAt(0, 0, 0);
    await shoot(scene, camera, {width}, {height});
    for (const own of [sun, asset, clone, ...instanced]) own.dispose();
}})()"""


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("packages", type=Path, nargs="+", help="assets, taken in turn")
    parser.add_argument("--minutes", type=float, default=10.0, help="how long")
    parser.add_argument("--every", type=float, default=20.0, help="seconds between readings")
    add_out(parser)


def run(args: argparse.Namespace) -> None:
    if find_chromium() is None:
        raise RnaError(INSTALL)
    with tempfile.TemporaryDirectory() as folder:
        installed(Path(folder))
        for path in (PAGE, *args.packages):
            shutil.copy(path, folder)
        with opened(Path(folder), PAGE.name, *SIZE) as page:
            page.wait_for("!!globalThis.test", TIMEOUT)
            rows = readings(page, [path.name for path in args.packages], args.minutes, args.every)
    report = {
        "packages": [str(path) for path in args.packages],
        "minutes": args.minutes,
        "rounds": rows[-1]["rounds"],
        "later_over_earlier": later_over_earlier(rows),
        "readings": rows,
    }
    publish(report, args)


def readings(page: Page, names: list[str], minutes: float, every: float) -> list[dict[str, Any]]:
    """Rounds until the time is over, and a row for each reading."""
    rows: list[dict[str, Any]] = []
    begun, rounds = time.monotonic(), 0
    while (seconds := time.monotonic() - begun) < 60 * minutes:
        page.evaluate(ROUND.format(name=names[rounds % len(names)], width=SIZE[0], height=SIZE[1]))
        rounds += 1
        if seconds >= every * len(rows) and rounds % len(names) == 0:
            rows.append({"seconds": round(seconds), "rounds": rounds, **memory(page)})
    return rows


def memory(page: Page) -> dict[str, Any]:
    page.call("HeapProfiler.collectGarbage")
    sizes = {"page_mb": 0.0, "gpu_mb": 0.0}
    for process in descendants(os.getpid()):
        command = Path(f"/proc/{process}/cmdline").read_text()
        pages = int(Path(f"/proc/{process}/statm").read_text().split()[1])
        resident = pages * resource.getpagesize() / 2**20
        for option, name in (("--type=renderer", "page_mb"), ("--type=gpu-process", "gpu_mb")):
            if option in command:
                sizes[name] += resident
    counts = page.evaluate("test.renderer.info.memory")
    return {
        "objects": sum(n for name, n in counts.items() if not name.endswith(("Size", "total"))),
        "heap_mb": round(page.call("Runtime.getHeapUsage")["usedSize"] / 2**20, 2),
        **{name: round(value, 1) for name, value in sizes.items()},
    }


def descendants(process: int) -> list[int]:
    """Children of a process, and theirs."""
    threads = Path(f"/proc/{process}/task").glob("*/children")
    children = [int(child) for path in threads for child in path.read_text().split()]
    return children + [below for child in children for below in descendants(child)]


def later_over_earlier(rows: list[dict[str, Any]]) -> dict[str, float]:
    quarter = max(1, len(rows) // 4)
    earlier, later = rows[quarter : 2 * quarter] or rows, rows[-quarter:]

    def median(own: list[dict[str, Any]], name: str) -> float:
        return float(np.median([row[name] for row in own]))

    names = ("heap_mb", "page_mb", "gpu_mb")
    return {name: round(median(later, name) / median(earlier, name), 3) for name in names}
