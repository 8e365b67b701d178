"""Documents stay short, their anchors exist, and docstrings name their subject."""

import re
import subprocess
from collections.abc import Iterable
from pathlib import Path

import pytest

from tests.conftest import REPOSITORY

DOCS = REPOSITORY / "docs"
MEASURED = ("docs/results.md", "docs/frontier.md", "docs/stability.md", "docs/peers.md")
MOST_LINES = {
    "the changelog": (60, ["CHANGELOG.md"]),
    "measured figures": (450, [*MEASURED, "benchmarks/README.md"]),
    "docs without decisions": (
        3800,
        [*DOCS.glob("*.md"), *(DOCS / "reference").glob("*.md")],
    ),
}
VAGUE = re.compile(r'^ *r?"""(Of .*|.*\b[Ww]hat (?:is|are)\b.*)$', re.MULTILINE)
"""First lines of docstrings without a subject."""

PAGES = [REPOSITORY / name for name in ("README.md", "CONTRIBUTING.md", "benchmarks/README.md")]
PAGES += [*DOCS.rglob("*.md"), *(REPOSITORY / "examples").rglob("*.md")]


def _lines(paths: Iterable[str | Path]) -> int:
    return sum(len((REPOSITORY / path).read_text().splitlines()) for path in paths)


@pytest.mark.parametrize("name", MOST_LINES)
def test_documents_stay_short(name):
    most, paths = MOST_LINES[name]
    assert _lines(paths) <= most


def _anchors(page: Path) -> set[str]:
    """As GitHub and MkDocs make them of headings, and those that the page sets."""
    text = re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL)
    titles = re.findall(r"^#+ (.+)$", text, re.MULTILINE)
    plain = [re.sub(r"\[(.*?)\]\(.*?\)", r"\1", title).lower() for title in titles]
    named = {re.sub(r"[^\w\s-]", "", title).strip().replace(" ", "-") for title in plain}
    return named | set(re.findall(r'<a (?:id|name)="(.*?)"', text))


@pytest.mark.parametrize("page", PAGES, ids=lambda path: str(path.relative_to(REPOSITORY)))
def test_anchors_exist(page):
    links = re.findall(r"\]\((?!https?:)([^)\s]*)#([^)\s]+)\)", page.read_text())
    targets = [((page.parent / path) if path else page, anchor) for path, anchor in links]
    missing = [f"{path}#{anchor}" for path, anchor in targets if anchor not in _anchors(path)]
    assert missing == []


def test_docstrings_name_their_subject():
    listed = subprocess.check_output(["git", "ls-files", "*.py"], text=True, cwd=REPOSITORY)
    vague = [
        f"{name}: {line}"
        for name in listed.split()
        if (REPOSITORY / name).is_file()
        for line in VAGUE.findall((REPOSITORY / name).read_text())
    ]
    assert vague == []


@pytest.mark.parametrize("page", PAGES, ids=lambda path: str(path.relative_to(REPOSITORY)))
def test_except_is_not_but_for(page):
    if "decisions" not in page.parts:
        assert " but for " not in page.read_text()
