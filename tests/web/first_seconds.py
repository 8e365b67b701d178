"""What `<rna-viewer>` shows in its first seconds: elements of several builds, one after the other.

    python -m tests.web.first_seconds OUT.json before=OLD/rna-viewer.js after=NEW/rna-viewer.js

For each bundled asset, the builds in turn: when the first picture of the asset is seen, when the
element says `load`, and when a picture is first seen whose FLIP to the converged one is at most
0.1 and 0.05. Each is told in seconds since the page began, in seconds of the browser's
processors, which other programs on the machine hardly change, and in bytes of the package that
were fetched. WebGPU in software, so that these processors do all of the work.
"""

from __future__ import annotations

import base64
import json
import os
import re
import shlex
import shutil
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from flip_evaluator import evaluate as flip

from rna_bench.stamp import stamp
from tests.conftest import REPOSITORY
from tests.render.chromium import SOFTWARE_GPU, Page, find_chromium, open_page
from tests.web.pages import Ranges, served_folder

WIDTH, HEIGHT = 400, 250
SAMPLES = 5  # of the converged picture
SECONDS = 1500.0
ASSETS = {
    "examples/quickstart/toy.rna": "34deg 70deg 1.7m",
    "examples/jade/fox.rna": "34deg 70deg 0.75m",
    "examples/fibers/curly_ball.rna": "34deg 70deg 2.2m",
}
"""By package, the camera that all builds are given."""
GOALS = 0.1, 0.05
PAGE = """<!doctype html><style>
  body { margin: 0 }
  rna-viewer { width: WIDTHpx; height: HEIGHTpx; background: rgb(255, 255, 255) }
</style>
<rna-viewer id="one" src="SRC" sun="40deg 45deg 2" pixel-ratio="1" camera-orbit="ORBIT"
  loading="eager" MORE></rna-viewer>
<script>
  globalThis.seen = [];
  const now = () => performance.now() / 1e3;
  const bytes = () => performance.getEntriesByType("resource")
    .filter(({ name }) => name.endsWith(".rna"))
    .reduce((sum, own) => sum + own.encodedBodySize, 0);
  const sheet = new OffscreenCanvas(WIDTH, HEIGHT).getContext("2d", { willReadFrequently: true });
  function take() {
    const { stage, parts } = one, { scale, rounds } = stage.viewer.stats;
    const figures = { seconds: now() };
    sheet.drawImage(stage.canvas, 0, 0);
    const { data } = sheet.getImageData(0, 0, WIDTH, HEIGHT);
    Object.assign(figures, { scale, rounds, bytes: bytes() });
    // Whether it is seen is known once all others have heard of it.
    const isSeen = () => parts.poster.hidden || parts.image.hidden;
    queueMicrotask(() => isSeen() && seen.push({ figures, data, isLoaded: one.loaded }));
  }
  customElements.whenDefined("rna-viewer").then(() => one.stage.addEventListener("shown", take));
  function text(data) {
    let all = "";
    for (let k = 0; k < data.length; k += 8192) {
      all += String.fromCharCode(...data.subarray(k, k + 8192));
    }
    return btoa(all);
  }
</script>
<script src="BUILD.js"></script>
"""


def show(page: Page, folder: Path, url: str, build: str, package: str, more: str = "") -> None:
    """Loads the page of a build, with an empty cache."""
    words = {"WIDTH": WIDTH, "HEIGHT": HEIGHT, "SRC": Path(package).name, "BUILD": build}
    text = PAGE
    for word, value in {**words, "ORBIT": ASSETS[package], "MORE": more}.items():
        text = text.replace(word, str(value))
    (folder / "page.html").write_text(text)
    page.call("Page.navigate", url=url + "page.html")
    page.wait_for("globalThis.one?.stage", SECONDS)


def picture(page: Page, index: int) -> np.ndarray:
    """(h, w, 3) float32, 0 to 1, of a picture that was seen."""
    data = base64.b64decode(page.evaluate(f"text(seen.at({index}).data)"))
    pixels = np.frombuffer(data, np.uint8).reshape(HEIGHT, WIDTH, 4)
    return np.ascontiguousarray(pixels[..., :3] / np.float32(255))


def converged(page: Page, folder: Path, url: str, build: str, package: str) -> np.ndarray:
    show(page, folder, url, build, package, f'first-look="off" samples="{SAMPLES}"')
    own = "seen.at(-1)?.figures"
    page.wait_for(f"{own}?.scale === 1 && {own}.rounds >= {SAMPLES}", SECONDS)
    return picture(page, -1)


def processor_seconds() -> Callable[[], float]:
    """Of the Chromium that this process started: the processes that draw and that run the page."""
    own = os.getpid()
    children = Path(f"/proc/{own}/task/{own}/children").read_text().split()
    named = [Path(f"/proc/{child}/cmdline").read_text() for child in children]
    profile = next(
        found[1] for text in named if (found := re.search(r"user-data-dir=([^\0]+)", text))
    )
    kinds = ("--type=gpu-process", "--type=renderer")

    def seconds() -> float:
        total = 0
        for folder in Path("/proc").glob("[0-9]*"):
            try:
                text = (folder / "cmdline").read_text()
                if profile in text and any(kind in text for kind in kinds):
                    fields = (folder / "stat").read_text().rsplit(")", 1)[1].split()
                    total += int(fields[11]) + int(fields[12])
            except OSError:
                continue
        return total / os.sysconf("SC_CLK_TCK")

    return seconds


def load(page: Page, folder: Path, url: str, build: str, package: str, goal: np.ndarray) -> Any:
    """Figures of one load, until all goals are met or it has as many samples as the goal."""
    processors = processor_seconds()
    show(page, folder, url, build, package)
    found: dict[str, Any] = {}
    for k in range(1000):
        page.wait_for(f"seen.length > {k}", SECONDS)
        figures = page.evaluate(f"seen[{k}].figures") | {"processor_seconds": processors()}
        error = float(flip(goal, picture(page, k), "LDR", inputsRGB=True, applyMagma=False)[1])
        figures["flip"] = round(error, 4)
        found.setdefault("first picture", figures)
        if page.evaluate(f"seen[{k}].isLoaded") or k > 0:
            found.setdefault("load", figures)
        if figures["scale"] <= 4:
            found.setdefault("sharp picture", figures)
        for limit in GOALS:
            if error <= limit:
                found.setdefault(f"flip {limit}", figures)
        is_all = figures["scale"] == 1 and figures["rounds"] >= SAMPLES
        if is_all or f"flip {GOALS[-1]}" in found:
            break
    return found


def measure(builds: dict[str, Path], write: Callable[[dict[str, Any]], object]) -> None:
    """Hands the results on after each load."""
    results: dict[str, Any] = {}
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        for name, script in builds.items():
            shutil.copy(script, folder / f"{name}.js")
        for package in ASSETS:
            shutil.copy(REPOSITORY / package, folder)
            own = results.setdefault(Path(package).stem, {})
            with served_folder(folder, Ranges) as url:
                with open_page(find_chromium(), WIDTH, HEIGHT, SOFTWARE_GPU) as page:
                    goal = converged(page, folder, url, list(builds)[-1], package)
                for name in builds:
                    with open_page(find_chromium(), WIDTH, HEIGHT, SOFTWARE_GPU) as page:
                        own[name] = load(page, folder, url, name, package, goal)
                        print(Path(package).stem, name, own[name], flush=True)
                    write(results)


def main() -> None:
    out, *given = sys.argv[1:]
    builds = {name: Path(script) for name, script in (one.split("=", 1) for one in given)}
    names = (f"{name}={script.name}" for name, script in builds.items())
    command = shlex.join(["python", "-m", "tests.web.first_seconds", Path(out).name, *names])
    head = {
        "stamp": stamp([]) | {"command": command},
        "width": WIDTH,
        "height": HEIGHT,
        "samples": SAMPLES,
    }
    measure(
        builds,
        lambda assets: Path(out).write_text(
            json.dumps({**head, "assets": assets}, indent=1) + "\n"
        ),
    )


if __name__ == "__main__":
    main()
