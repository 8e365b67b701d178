"""docs/decisions/: every record has the same form, and a row in the table of the first page."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[1] / "docs" / "decisions"
PAGES = sorted(path.name for path in FOLDER.glob("*.md") if path.name != "README.md")
_FORM = re.compile(
    r"[^\n]+\n\nDate: (\d{4}-\d\d-\d\d)(, revised \d{4}-\d\d-\d\d)?\n\n"
    r"\*\*Context\.\*\* .+\n\n\*\*Options\.\*\* .+\n\n"
    r"(\*\*Figures\.\*\*\s.+\n\n)?\*\*Outcome\.\*\* .+",
    re.DOTALL,
)
_ROW = re.compile(r"\| ([\d-]+) \| \[(.+)\]\((.+)#(.+)\) \| (.+) \|")


def _records(page: str) -> list[str]:
    return re.split(r"(?m)^## ", (FOLDER / page).read_text())[1:]


def _anchor(title: str) -> str:
    """As GitHub and MkDocs make it, of titles that both treat alike."""
    return re.sub(r"[^\w\s-]", "", title.lower()).replace(" ", "-")


@pytest.mark.parametrize("page", PAGES)
def test_records_have_date_context_options_and_outcome(page: str) -> None:
    titles = [record.splitlines()[0] for record in _records(page) if not _FORM.fullmatch(record)]
    assert titles == []


def test_the_table_has_every_record_once_newest_first() -> None:
    rows = _ROW.findall((FOLDER / "README.md").read_text())
    expected = []
    for page in PAGES:
        subject = (FOLDER / page).read_text().splitlines()[0].removeprefix("# Decisions: ")
        for record in _records(page):
            title = record.splitlines()[0]
            date = record.partition("Date: ")[2][:10]
            expected.append((date, title, page, _anchor(title), subject))
    assert sorted(rows) == sorted(expected)
    assert [row[0] for row in rows] == sorted((row[0] for row in rows), reverse=True)
