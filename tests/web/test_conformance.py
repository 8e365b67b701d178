"""The viewer gives the answers of the conformance kit (spec/conformance)."""

import base64
from pathlib import Path

import pytest

from rna_sdk.conformance.kit import find_kit, load_kit
from rna_sdk.conformance.program import Answer
from rna_sdk.conformance.scoring import cases, score
from rna_view.site_files import Site
from tests.render.chromium import Page
from tests.web.pages import base64_of, call_reader, viewer

pytestmark = pytest.mark.chromium

_QUERIES = {
    "evaluate": ("transport", 16),
    "nearby": ("transport", 19),
    "emission": ("emission", 10),
}
"""Calls of the kit about queries: a decoder's output, and the columns of a row."""


class PageProgram:
    """The page as a reader program (spec/conformance/README.md)."""

    def __init__(self, page: Page) -> None:
        self._page = page
        self._loaded: tuple[str, str] | None = None

    def run(self, *arguments: str) -> Answer:
        command, package, *rest = arguments
        if command in _QUERIES:
            tier, part, queries, results = rest
            self._load(package, tier)
            output, columns = _QUERIES[command]
            text = base64_of(Path(queries))
            actual = call_reader(self._page, "evaluate", int(part), output, text, columns)
        else:
            hits, results = rest
            self._load(package, "")
            method = {"base-color": "baseColor"}.get(command, command)
            actual = call_reader(self._page, method, base64_of(Path(hits)))
        Path(results).write_bytes(base64.b64decode(actual))
        return Answer(0, "", "")

    def _load(self, package: str, tier: str) -> None:
        if self._loaded != (package, tier):
            call_reader(self._page, "load", base64_of(Path(package)), tier)
            self._loaded = package, tier


@pytest.fixture(scope="module")
def page():
    with viewer(Site({}, {})) as page:
        yield page


@pytest.mark.parametrize("level", ["evaluate", "nearby", "visibility", "normals", "base-color"])
def test_page_gives_the_answers_of_the_kit(page, level):
    kit, program = load_kit(find_kit()), PageProgram(page)
    scores = [score(program, kit, case) for case in cases(kit, level)]
    assert scores
    wrong = [
        f"{s.package} {s.tier}: {s.in_tolerances:.3g} {s.note}" for s in scores if not s.passed
    ]
    assert not wrong, "\n".join(wrong)
