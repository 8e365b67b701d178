"""The page answers while an asset is read and its hierarchy built."""

import shutil
from itertools import pairwise

import pytest

from tests.conftest import REPOSITORY
from tests.web.element_pages import SMALL, loads, show
from tests.web.pages import TIMEOUT

pytestmark = pytest.mark.chromium

EXAMPLES = REPOSITORY / "examples"
CURLS = EXAMPLES / "fibers" / "curly_ball.rna"
LONGEST_MS = 100.0
TURNS = """(() => {
    globalThis.turns = [];
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => { turns.push(performance.now()); port2.postMessage(0); };
    port2.postMessage(0);
    one.src = "curly_ball.rna";
})()"""
BUILT = """(() => {
    const [begin, end] = ["package", "hierarchy"].map(
        (name) => performance.getEntriesByName(name).at(-1).startTime);
    return [begin, ...turns.filter((time) => time > begin && time < end), end];
})()"""


def test_hierarchy_is_built_in_steps(page, folder, url):
    """Others have a turn in between: of 162,000 segments, which take more than half a second."""
    shutil.copy(CURLS, folder)
    show(page, folder, url, f'<rna-viewer id="one" loading="eager" {SMALL}></rna-viewer>')
    page.wait_for("one.stage.engine", 60)
    page.evaluate(TURNS)
    loads(page, "one")
    times = page.evaluate(BUILT)
    gaps = [b - a for a, b in pairwise(times)]
    assert len(gaps) > 10 and max(gaps) < (times[-1] - times[0]) / 3


@pytest.mark.parametrize("name", ["quickstart/toy", "jade/fox", "fibers/curly_ball"])
def test_no_task_is_long(page, folder, url, name):
    """The bundled assets from the address to the first picture; the main thread's own time."""
    package = EXAMPLES / f"{name}.rna"
    shutil.copy(package, folder)
    show(page, folder, url, f'<rna-viewer id="one" loading="eager" {SMALL}></rna-viewer>')
    page.wait_for("one.stage.engine", TIMEOUT)
    page.evaluate("one.stage.engine.compiled.then(() => 0)")
    with page.tracing("toplevel") as events:
        page.evaluate(f"one.src = '{package.name}', 0")
        loads(page, "one")
    # Tasks that have begun and ended within the trace have a duration.
    runs = [one for one in events if one["name"].endswith("RunTask") and "tdur" in one]
    tasks = [one["tdur"] / 1e3 for one in runs]
    assert len(tasks) > 20 and max(tasks) <= LONGEST_MS, sorted(tasks)[-5:]
