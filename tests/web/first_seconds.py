"""What `<rna-viewer>` shows in its first seconds: elements of several builds, one after the other.

    python -m tests.web.first_seconds OUT.json before=OLD/rna-viewer.js after=NEW/rna-viewer.js

For each bundled asset, medians of several loads, the builds in turn: seconds from the page's start to
the poster, to the first picture of the asset that is seen, to the `load` event, and to the first picture
whose FLIP to the converged one is at most 0.1 and 0.05; the bytes that were fetched until then; the
longest task of the main thread. Software WebGPU.
"""

from __future__ import annotations

import base64
import json
import shutil
import statistics
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from flip_evaluator import evaluate as flip

from rna_bench.stamp import stamp
from tests.conftest import REPOSITORY
from tests.render.chromium import SOFTWARE_GPU, Page, find_chromium, open_page
from tests.web.pages import Ranges, served_folder

SIZE = 400, 250
LOADS = 3
SAMPLES = 12  # of the converged picture
SECONDS = 900.0
ASSETS = {
    "examples/quickstart/toy.rna": "34deg 70deg 1.7m",
    "examples/jade/fox.rna": "34deg 70deg 0.75m",
    "examples/fibers/curly_ball.rna": "34deg 70deg 2.2m",
}
"""By package, the camera that all builds are given."""
GOALS = 0.1, 0.05
PAGE = """<!doctype html><style>
  body { margin: 0 } rna-viewer { width: WIDTHpx; height: HEIGHTpx; background: rgb(255, 255, 255) }
</style>
<rna-viewer id="one" src="SRC" sun="40deg 45deg 2" pixel-ratio="1" camera-orbit="ORBIT" loading="eager" MORE></rna-viewer>
<script>
  globalThis.seen = []; globalThis.tasks = []; globalThis.taken = 0;
  const now = () => performance.now() - taken;
  const bytes = () => performance.getEntriesByType("resource")
    .filter(({ name }) => name.endsWith(".rna")).reduce((sum, own) => sum + own.encodedBodySize, 0);
  new PerformanceObserver((list) => tasks.push(...list.getEntries().map((own) => own.duration)))
    .observe({ type: "longtask", buffered: true });
  const sheet = new OffscreenCanvas(WIDTH, HEIGHT).getContext("2d", { willReadFrequently: true });
  function take() {
    const { stage, parts } = one, { scale, rounds } = stage.viewer.stats;
    const begun = performance.now(), time = now();
    sheet.drawImage(stage.canvas, 0, 0);
    const { data } = sheet.getImageData(0, 0, WIDTH, HEIGHT);
    taken += performance.now() - begun;
    // Whether it is seen is known once all others have heard of it.
    queueMicrotask(() => (parts.poster.hidden || parts.image.hidden) && seen.push({ time, scale, rounds, bytes: bytes(), data }));
  }
  customElements.whenDefined("rna-viewer").then(() => {
    one.stage.addEventListener("shown", take);
    one.addEventListener("load", () => { globalThis.loaded = now(); });
    one.parts.image.addEventListener("load", () => { globalThis.postered ??= now(); });
  });
  function text(data) {
    let all = "";
    for (let k = 0; k < data.length; k += 8192) all += String.fromCharCode(...data.subarray(k, k + 8192));
    return btoa(all);
  }
</script>
<script src="BUILD.js"></script>
"""


def show(page: Page, folder: Path, url: str, build: str, package: str, more: str) -> None:
    """Loads the page of a build, with an empty cache."""
    text = PAGE.replace("WIDTH", str(SIZE[0])).replace("HEIGHT", str(SIZE[1]))
    text = text.replace("SRC", Path(package).name).replace("ORBIT", ASSETS[package])
    (folder / "page.html").write_text(text.replace("MORE", more).replace("BUILD", build))
    page.call("Page.navigate", url="about:blank")
    page.call("Network.enable")
    page.call("Network.setCacheDisabled", cacheDisabled=True)
    page.call("Page.navigate", url=url + "page.html")
    page.wait_for("globalThis.one?.stage", SECONDS)


def picture(page: Page, index: int) -> np.ndarray:
    """(h, w, 3) float32, 0 to 1, of a picture that was seen."""
    data = base64.b64decode(page.evaluate(f"text(seen.at({index}).data)"))
    pixels = np.frombuffer(data, np.uint8).reshape(SIZE[1], SIZE[0], 4)
    return np.ascontiguousarray(pixels[..., :3] / np.float32(255))


def converged(page: Page, folder: Path, url: str, build: str, package: str) -> np.ndarray:
    show(page, folder, url, build, package, f'first-look="off" samples="{SAMPLES}"')
    page.wait_for(f"seen.at(-1)?.scale === 1 && seen.at(-1).rounds >= {SAMPLES}", SECONDS)
    return picture(page, -1)


def load(page: Page, folder: Path, url: str, build: str, package: str, goal: np.ndarray) -> Any:
    """Figures of one load; it ends when all goals are met."""
    show(page, folder, url, build, package, "")
    found: dict[str, Any] = {}
    looked = 0
    while f"flip {GOALS[-1]}" not in found:
        page.wait_for(f"seen.length > {looked}", SECONDS)
        own = page.evaluate(
            f"(({{ time, scale, rounds, bytes }}) => ({{ time, scale, rounds, bytes }}))(seen[{looked}])"
        )
        error = float(flip(goal, picture(page, looked), "LDR", inputsRGB=True, applyMagma=False)[1])
        seconds = own["time"] / 1e3
        found.setdefault("first picture", seconds)
        found.setdefault("its flip", error)
        found.setdefault("its bytes", own["bytes"])
        if own["scale"] <= 4:
            found.setdefault("a quarter", seconds)
        for limit in GOALS:
            if error <= limit:
                found.setdefault(f"flip {limit}", seconds)
                found.setdefault(f"bytes to flip {limit}", own["bytes"])
        looked += 1
        if own["scale"] == 1 and own["rounds"] >= SAMPLES:
            break
    more = page.evaluate("[globalThis.postered, loaded, Math.max(0, ...tasks)]")
    return found | {
        "poster": (more[0] or 0) / 1e3,
        "load": more[1] / 1e3,
        "longest task ms": more[2],
    }


def measure(builds: dict[str, Path], loads: int) -> dict[str, Any]:
    results: dict[str, Any] = {}
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        for name, script in builds.items():
            shutil.copy(script, folder / f"{name}.js")
        for package in ASSETS:
            shutil.copy(REPOSITORY / package, folder)
        for package in ASSETS:
            own: dict[str, list[Any]] = {name: [] for name in builds}
            with served_folder(folder, Ranges) as url:
                with open_page(find_chromium(), *SIZE, SOFTWARE_GPU) as page:
                    goal = converged(page, folder, url, list(builds)[-1], package)
                for _ in range(loads):
                    for name in builds:
                        with open_page(find_chromium(), *SIZE, SOFTWARE_GPU) as page:
                            own[name].append(load(page, folder, url, name, package, goal))
                            print(Path(package).stem, name, own[name][-1], flush=True)
            results[Path(package).stem] = {name: medians(all_) for name, all_ in own.items()}
    return results


def medians(loads: list[dict[str, float]]) -> dict[str, float]:
    """Of what all loads found."""
    names = [name for name in loads[0] if all(name in load for load in loads)]
    return {name: round(statistics.median(load[name] for load in loads), 3) for name in names}


def main() -> None:
    out, *given = sys.argv[1:]
    builds = {name: Path(script) for name, script in (one.split("=", 1) for one in given)}
    report = {"stamp": stamp(sys.argv), "size": SIZE, "samples": SAMPLES, "loads": LOADS}
    Path(out).write_text(json.dumps(report | {"assets": measure(builds, LOADS)}, indent=1) + "\n")


if __name__ == "__main__":
    main()
