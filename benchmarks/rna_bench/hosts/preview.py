"""Latency of `rna-run --preview` in headless Chromium.

    rna-bench preview --out benchmarks/results/preview.json

Prints JSON, milliseconds with everything loaded and Chromium running:

    opening  from asking for the page until its first picture is drawn; the renderer has just
             started again, so no picture is ready
    orbit    from the first movement of a drag until a picture of the new view is drawn, while
             samples of the old view are rendered
    full     from the same movement until one sample of every pixel is drawn

Drawn means put on the page's canvas; the screen shows it up to one refresh later. A first picture
has fewer pixels than the image, as `first_look` says.
"""

from __future__ import annotations

import argparse
import json
import re
import signal
import subprocess
import sys
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.bench_options import add_out, add_repeats
from rna_bench.checkout import QUICKSTART
from rna_bench.results import publish
from rna_sdk.errors import RnaError
from tests.render.chromium import INSTALL, Page, find_chromium, open_page

# In the page before its own script: when a picture was drawn and how wide it came, and when the
# pointer moved with a button held.
WATCH = """
  window.drawn = []; window.moved = [];
  const draw = CanvasRenderingContext2D.prototype.drawImage;
  let width = 0;
  CanvasRenderingContext2D.prototype.drawImage = function (image, ...place) {
    width = image.width;
    return draw.call(this, image, ...place);
  };
  document.addEventListener("shown", ({target}) => drawn.push({
    at: performance.now(), width, revision: +target.dataset.revision,
    samples: +target.dataset.samples,
  }), true);
  document.addEventListener("pointermove", (event) => {
    if (event.buttons) moved.push({at: event.timeStamp, revision: rnaPreview.state.revision});
  }, true);
"""


def run(args: argparse.Namespace) -> None:
    chromium = find_chromium()
    if chromium is None:
        raise RnaError(INSTALL)
    with rna_run(args.scene) as (url, loading), open_page(chromium) as page:
        page.call("Page.enable")
        page.call("Page.addScriptToEvaluateOnNewDocument", source=WATCH)
        open_preview(page, url)  # which loads what is left to load
        opened = [open_preview(page, url) for _ in range(args.repeats)]
        orbited = [orbit(page, step) for step in range(args.repeats)]
        sample_ms = float(page.evaluate("parseFloat(document.getElementById('time').textContent)"))
    publish(
        {
            "scene": args.scene.resolve().parent.name,
            "resolution": [640, 360],
            "repeats": args.repeats,
            "loading_s": round(loading, 2),
            "opening_ms": spread([first["at"] for first in opened]),
            "orbit_ms": spread([first for first, _, _ in orbited]),
            "full_ms": spread([full for _, full, _ in orbited]),
            "first_look": {
                "opening_width": spread([first["width"] for first in opened]),
                "orbit_width": spread([width for _, _, width in orbited]),
            },
            "last_sample_ms": sample_ms,
        },
        args,
    )


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--scene", type=Path, default=QUICKSTART, help="scene file")
    add_repeats(parser)
    add_out(parser)


@contextmanager
def rna_run(scene: Path) -> Iterator[tuple[str, float]]:
    """The address that the command prints, and after how many seconds."""
    start = time.perf_counter()
    options = ["--preview", "--resolution", "640x360", "--samples", "100000"]
    command = [sys.executable, "-m", "rna_render.command.rna_run", str(scene), *options]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as started:
        assert started.stdout is not None
        found = re.search(r"http://\S+", started.stdout.readline())
        if found is None:
            raise RnaError("rna-run has not started")
        yield found[0], time.perf_counter() - start
        started.send_signal(signal.SIGINT)
        started.wait(60)


def open_preview(page: Page, url: str) -> dict[str, Any]:
    """The first picture of the page, opened anew; `at` is since the navigation began."""
    page.call("Page.navigate", url="about:blank")
    body = json.dumps({"orbit_deg": [7, 0]}).encode()
    change = urllib.request.Request(url + "change", body, {"Content-Type": "application/json"})
    urllib.request.urlopen(change).close()
    page.call("Page.navigate", url=url)
    first: dict[str, Any] = page.wait_for("window.drawn?.[0]")
    page.wait_for("drawn.at(-1).samples >= 2")
    return first


def orbit(page: Page, step: int) -> tuple[float, float, int]:
    """Milliseconds to the first look and to the first whole sample; the first look's width."""
    x, y = 400 + 10 * (step % 5), 360
    page.evaluate("moved.length = drawn.length = 0")
    page.mouse("mousePressed", x, y, button="left", buttons=1, clickCount=1)
    page.mouse("mouseMoved", x + 40, y, button="left", buttons=1)
    page.wait_for("moved.length && drawn.some(d => d.revision > moved[0].revision && d.samples)")
    page.mouse("mouseReleased", x + 40, y, button="left")
    seen = page.evaluate("drawn.filter(d => d.revision > moved[0].revision)")
    start = page.evaluate("moved[0].at")
    full = next(picture for picture in seen if picture["samples"])
    page.wait_for("drawn.at(-1).samples >= 2")
    return seen[0]["at"] - start, full["at"] - start, seen[0]["width"]


def spread(values: list[float]) -> dict[str, float]:
    return {
        "median": round(float(np.median(values)), 1),
        "least": round(min(values), 1),
        "most": round(max(values), 1),
    }
