"""A page in headless Chromium, driven over its debugging pipe: no port, no other package.

Chrome DevTools Protocol: https://chromedevtools.github.io/devtools-protocol/. With
--remote-debugging-pipe Chromium reads commands from its descriptor 3 and writes answers and events
to 4, each JSON with a zero byte at its end.
"""

import atexit
import base64
import fcntl
import json
import os
import select
import shutil
import signal
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any

INSTALL = "no Chromium; on Debian: apt-get install chromium"

NO_GPU = ("--disable-gpu",)
SOFTWARE_GPU = (
    "--enable-unsafe-webgpu",
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
    "--use-angle=swiftshader",
    "--ignore-gpu-blocklist",
)
"""WebGPU by SwiftShader, which Chromium brings. Compute alone needs the first three."""


def find_chromium() -> str | None:
    """The program's path."""
    names = ("chromium", "chromium-browser", "google-chrome")
    return next((path for name in names if (path := shutil.which(name))), None)


class Browser:
    """A running Chromium with the given flags, which ends with this process."""

    def __init__(self, flags: tuple[str, ...]) -> None:
        theirs_in, self._commands = _pipe()
        self._answers, theirs_out = _pipe()
        self._read, self._number = b"", 0
        self._profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        options = ["--headless=new", "--remote-debugging-pipe", "--no-first-run", *flags]
        options += [f"--user-data-dir={self._profile.name}", "--hide-scrollbars"]
        if os.geteuid() == 0:
            options += ["--no-sandbox"]  # which root cannot have
        nowhere = os.open(os.devnull, os.O_RDWR)
        pairs = [(nowhere, 0), (nowhere, 1), (nowhere, 2), (theirs_in, 3), (theirs_out, 4)]
        program = find_chromium()
        assert program is not None, INSTALL
        self._pid = os.posix_spawn(
            program,
            [program, *options],
            os.environ,
            file_actions=[(os.POSIX_SPAWN_DUP2, ours, theirs) for ours, theirs in pairs],
            setpgroup=0,
        )
        for descriptor in (theirs_in, theirs_out, nowhere):
            os.close(descriptor)
        atexit.register(self._end)

    def send(self, method: str, parameters: dict[str, Any], session: str | None = None) -> int:
        """The number that the answer will have."""
        self._number += 1
        message = {"id": self._number, "method": method, "params": parameters}
        if session is not None:
            message["sessionId"] = session
        os.write(self._commands, json.dumps(message).encode() + b"\0")
        return self._number

    def next_message(self) -> dict[str, Any]:
        """An answer or an event, of whatever page."""
        while b"\0" not in self._read:
            ready, _, _ = select.select([self._answers], [], [], 300)
            data = os.read(self._answers, 1 << 20) if ready else b""
            assert data, "Chromium has ended, or says nothing"
            self._read += data
        message, _, self._read = self._read.partition(b"\0")
        return json.loads(message)

    @property
    def runs(self) -> bool:
        with suppress(ChildProcessError):  # seen to have ended before
            return os.waitpid(self._pid, os.WNOHANG) == (0, 0)
        return False

    def _end(self) -> None:
        with suppress(ProcessLookupError):
            os.killpg(self._pid, signal.SIGKILL)
        with suppress(ChildProcessError):
            os.waitpid(self._pid, 0)
        self._profile.cleanup()


class Page:
    """A page of a browser, which shares nothing with its others: cookies, files, storage."""

    def __init__(self, browser: Browser) -> None:
        self._browser = browser
        self._session: str | None = None
        self._events: list[dict[str, Any]] = []
        self._context = self.call("Target.createBrowserContext")["browserContextId"]
        context = {"browserContextId": self._context}
        target = self.call("Target.createTarget", url="about:blank", **context)["targetId"]
        attached = self.call("Target.attachToTarget", targetId=target, flatten=True)
        self._session = attached["sessionId"]

    def close(self) -> None:
        self._session = None
        self.call("Target.disposeBrowserContext", browserContextId=self._context)

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        """What the protocol's method returns."""
        number = self._browser.send(method, parameters, self._session)
        while True:
            answer = self._browser.next_message()
            self._keep(answer)
            if answer.get("id") == number:
                assert "error" not in answer, f"{method}: {answer['error']}"
                return answer["result"]

    def evaluate(self, expression: str) -> Any:
        """The value of JavaScript, that of its promise if it is one."""
        result = self.call(
            "Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True
        )
        assert "exceptionDetails" not in result, result["exceptionDetails"]
        return result["result"].get("value")

    def wait_for(self, expression: str, seconds: float = 30.0) -> Any:
        """The value of JavaScript once it is true in JavaScript's sense."""
        end = time.monotonic() + seconds
        while not (value := self.evaluate(expression)):
            assert time.monotonic() < end, f"not within {seconds} s: {expression}"
            time.sleep(0.02)
        return value

    def mouse(self, kind: str, x: float, y: float, **more: Any) -> None:
        """kind: mousePressed, mouseMoved, mouseReleased or mouseWheel."""
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    @contextmanager
    def tracing(self, category: str) -> Iterator[list[dict[str, Any]]]:
        """Trace events of the page's main thread, in the list once the block has ended."""
        of_page: list[dict[str, Any]] = []
        config = {"includedCategories": [category, "__metadata"]}
        self.call("Tracing.start", transferMode="ReportEvents", traceConfig=config)
        yield of_page
        self._events.clear()
        self.call("Tracing.end")
        while not any(event["method"] == "Tracing.tracingComplete" for event in self._events):
            self._keep(self._browser.next_message())
        sent = [event for event in self._events if event["method"] == "Tracing.dataCollected"]
        events = [one for event in sent for one in event["params"]["value"]]
        threads = _threads(events, "CrRendererMain")
        of_page += [one for one in events if (one["pid"], one["tid"]) in threads]

    @contextmanager
    def complaints(self) -> Iterator[list[str]]:
        """Errors and warnings of the page and of the browser, once the block ends."""
        lines: list[str] = []
        domains = ("Runtime", "Log")
        for domain in domains:
            self.call(f"{domain}.enable")
        self._events.clear()  # enabling repeats what was said before
        yield lines
        for domain in domains:
            self.call(f"{domain}.disable")
        lines += [line for event in self._events if (line := _complaint(event))]
        self._events.clear()

    def _keep(self, message: dict[str, Any]) -> None:
        if message.get("method", "").startswith(("Tracing.", "Runtime.", "Log.")):
            self._events.append(message)

    def screenshot(self) -> bytes:
        """PNG."""
        return base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])


def _threads(events: list[dict[str, Any]], name: str) -> set[tuple[int, int]]:
    """Process and thread of those with this name."""
    named = [one for one in events if one.get("name") == "thread_name"]
    return {(one["pid"], one["tid"]) for one in named if one["args"]["name"] == name}


def _complaint(event: dict[str, Any]) -> str | None:
    """The line of an error or a warning; None of all else."""
    parameters = event["params"]
    match event["method"]:
        case "Runtime.exceptionThrown":
            details = parameters["exceptionDetails"]
            return f"{details['text']} {details.get('exception', {}).get('description', '')}"
        case "Runtime.consoleAPICalled" if parameters["type"] in ("error", "warning", "assert"):
            return " ".join(
                str(one.get("value", one.get("description"))) for one in parameters["args"]
            )
        case "Log.entryAdded" if parameters["entry"]["level"] in ("error", "warning"):
            return str(parameters["entry"]["text"])
    return None


_browsers: dict[tuple[str, ...], Browser] = {}


@contextmanager
def open_page(
    width: int = 1280, height: int = 720, gpu: tuple[str, ...] = NO_GPU
) -> Iterator[Page]:
    """An empty page of that size, in this process' Chromium. gpu: NO_GPU or SOFTWARE_GPU."""
    if gpu not in _browsers or not _browsers[gpu].runs:
        _browsers[gpu] = Browser(gpu)
    page = Page(_browsers[gpu])
    try:
        page.call(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=False,
        )
        yield page
    finally:
        if _browsers[gpu].runs:
            page.close()


def _pipe() -> tuple[int, int]:
    """A pipe whose ends are not among the descriptors that Chromium's are copied to."""
    ends = os.pipe()
    moved = tuple(fcntl.fcntl(end, fcntl.F_DUPFD_CLOEXEC, 10) for end in ends)
    for end in ends:
        os.close(end)
    return moved
