"""Packages on servers of others: other origins, pages in the place of a package, requests."""

import re
import shutil

import pytest

from tests.web.element_pages import SMALL, line, loads, show
from tests.web.pages import TIMEOUT, Ranges, served_folder
from tests.web.test_page import TOY

pytestmark = pytest.mark.chromium


@pytest.fixture(scope="module")
def elsewhere(folder):
    """The folder on another origin, in ranges."""
    with served_folder(folder, Ranges) as address:
        yield address


def test_ranges_of_another_origin_that_hides_their_size(page, folder, url, elsewhere):
    """As most static hosts answer: the package is asked for again, whole."""
    assert (folder / "tiny.rna").stat().st_size > 65536
    show(page, folder, url, f'<rna-viewer id="one" src="{elsewhere}tiny.rna" {SMALL}></rna-viewer>')
    loads(page, "one")
    assert line(page) is None
    assert page.evaluate("one.stage.opened.source.ranged") is False


FETCHES = """(() => {
    const plain = fetch;
    Object.assign(globalThis, { told: [], spans: [] });
    globalThis.fetch = async (address, asked) => {
        const span = { range: asked.headers.Range, begun: performance.now() };
        spans.push(span);
        const answer = await plain(address, asked);
        span.end = performance.now();
        return answer;
    };
    one.addEventListener("progress", ({ detail }) => told.push(detail.totalProgress));
    one.src = "toy.rna";
})()"""


def test_progress_goes_up_and_ranges_are_asked_for_together(page, folder, elsewhere):
    """The toy, with a poster and lobes: two requests for the directory, then all others."""
    shutil.copy(TOY, folder)
    show(page, folder, elsewhere, f'<rna-viewer id="one" loading="eager" {SMALL}></rna-viewer>')
    page.wait_for("one.stage.engine", TIMEOUT)
    page.evaluate(FETCHES)
    loads(page, "one")
    output, spans = page.evaluate("told"), page.evaluate("spans")
    on_the_way = [value for value in output if value < 1]
    assert output == sorted(output) and output[-1] == 1
    assert len(set(on_the_way)) > 2 and max(on_the_way) > 0.9
    first, second, *others = spans
    assert re.fullmatch(r"bytes=0-\d+", first["range"])
    assert int(second["range"].split("-")[1]) == TOY.stat().st_size - 1
    assert len(others) > 1
    assert max(one["begun"] for one in others) < min(one["end"] for one in others)


PAGE_NOT_FOUND = "<!DOCTYPE html>\n<html><title>404</title><p>There is no such page.</p></html>"
POINTER = f"""version https://git-lfs.github.com/spec/v1
oid sha256:{"0" * 64}
size 4100000
"""


@pytest.mark.parametrize(
    ("kind", "content", "actual"),
    [("html", PAGE_NOT_FOUND, "an HTML page"), ("lfs", POINTER, "a pointer of Git LFS")],
)
def test_what_stands_in_the_place_of_a_file_is_said(page, folder, url, kind, content, actual):
    wrong = {"src": f"{kind}.rna", "environment": f"{kind}.hdr", "scene": f"{kind}.json"}
    for name in wrong.values():
        (folder / name).write_text(content)
    show(page, folder, url, f'<rna-viewer id="one" loading="eager" {SMALL}></rna-viewer>')
    for number, (name, address) in enumerate(wrong.items(), 1):
        page.evaluate(f"one.setAttribute('{name}', '{address}'), 0")
        page.wait_for(f"count('error', 'one') === {number}", TIMEOUT)
        message = page.evaluate("heard.at(-1).message")
        assert message.startswith(address) and actual in message
    assert page.evaluate("heard.find(({ type }) => type === 'asset').code") == "ZIP_NOT_ZIP"
