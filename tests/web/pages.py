"""The viewer in headless Chromium, and what tests do with it."""

import base64
import io
import json
import re
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import numpy as np

from rna_view.page_server import PageServer
from rna_view.site_files import Site
from tests.answering import answering
from tests.render.chromium import SOFTWARE_GPU, Page, open_page

TIMEOUT = 300.0
"""Seconds: SwiftShader compiles shaders for long on a busy machine."""


@contextmanager
def served(site: Site) -> Iterator[PageServer]:
    """The page's server, answering."""
    with answering(PageServer(site)) as server:
        yield server


class Plain(SimpleHTTPRequestHandler):
    """Any other web server: no ranges, no headers of ours."""

    def log_message(self, *arguments: object) -> None:
        """Nothing."""


class Ranges(Plain):
    """A host as most are: it has ranges, allows all origins, exposes no header to them."""

    def send_head(self) -> Any:
        span = re.fullmatch(r"bytes=(\d+)-(\d+)", self.headers.get("Range", ""))
        path = Path(self.translate_path(self.path))
        if span is None or not path.is_file():
            return super().send_head()
        size, first = path.stat().st_size, int(span[1])
        part = path.read_bytes()[first : int(span[2]) + 1]
        self.send_response(206)
        self.send_header("Content-Range", f"bytes {first}-{first + len(part) - 1}/{size}")
        self.send_header("Content-Length", str(len(part)))
        self.end_headers()
        return io.BytesIO(part)

    def end_headers(self) -> None:
        self.send_header("Access-Control-Allow-Origin", "*")
        super().end_headers()


@contextmanager
def served_folder(folder: Path, handler: type[Plain] = Plain) -> Iterator[str]:
    """The address of a folder on a plain server, answering."""
    handler_of_folder = partial(handler, directory=str(folder))
    with answering(ThreadingHTTPServer(("127.0.0.1", 0), handler_of_folder)) as server:
        yield f"http://127.0.0.1:{server.server_port}/"


@contextmanager
def viewer(
    site: Site,
    query: str = "",
    width: int = 320,
    height: int = 200,
    gpu: tuple[str, ...] = SOFTWARE_GPU,
) -> Iterator[Page]:
    """The page of a site, its engine begun."""
    with served(site) as server, open_page(width, height, gpu) as page:
        page.call("Page.navigate", url=f"{server.url}?{query}")
        page.wait_for(
            "globalThis.rnaViewer?.begun && rnaViewer.begun.then(() => true, () => true)", TIMEOUT
        )
        yield page


def wait_for_picture(page: Page, rounds: int) -> None:
    """Until the picture has so many samples; an error on the page fails the test."""
    stats = "rnaViewer.viewer?.stats"
    done = f"rnaViewer.failures || ({stats}?.scale === 1 && {stats}.rounds >= {rounds})"
    page.wait_for(done, TIMEOUT)
    assert not page.evaluate("rnaViewer.failures"), notice(page)


def notice(page: Page) -> str | None:
    """The line that the page shows, if any."""
    shown = "const n = rnaViewer.notices.place; return n.hidden ? null : n.textContent"
    return page.evaluate(f"(() => {{ {shown} }})()")


def picture(page: Page) -> np.ndarray:
    """(h, w, 4) float32: the mean of the samples, linear."""
    record = page.evaluate(
        """(async () => {
            const { viewer, engine } = rnaViewer, rounds = viewer.stats.rounds;
            viewer.pause();
            await engine.done();
            const values = await engine.picture(), { width, height } = engine.target;
            const bytes = new Uint8Array(values.buffer);
            let text = "";
            for (let k = 0; k < bytes.length; k += 8192) {
                text += String.fromCharCode(...bytes.subarray(k, k + 8192));
            }
            return { text: btoa(text), rounds, width, height };
        })()"""
    )
    values = np.frombuffer(base64.b64decode(record["text"]), "<f4")
    return values.reshape(record["height"], record["width"], 4) / record["rounds"]


def call_reader(page: Page, method: str, *arguments: Any) -> Any:
    """What a method of the page's conformance reader returns."""
    words = ", ".join(json.dumps(argument) for argument in arguments)
    page.evaluate("globalThis.reader ??= rnaViewer.reader()")
    return page.evaluate(f"reader.{method}({words})")


def base64_of(path: Path) -> str:
    """A file's bytes, as the page takes them."""
    return base64.b64encode(path.read_bytes()).decode()


FIRST_LOOK = """(async () => {
    const { viewer, engine } = rnaViewer, { sums } = engine;
    viewer.pause();
    await engine.done();
    engine.sums = engine.firstLook;
    const values = await engine.picture();
    engine.sums = sums;
    viewer.start();
    return [...values];
})()"""
"""RGBA of the first look, rows from the top."""
