"""docs/decisions/: every record has the same form, and the first page leads to every page."""

import re
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[1] / "docs" / "decisions"
PAGES = sorted(path.name for path in FOLDER.glob("*.md") if path.name != "README.md")
_FORM = re.compile(
    r"[^\n]+\n\n"
    r"\*\*Context\*\* \(\d{4}-\d\d-\d\d(, revised \d{4}-\d\d-\d\d)?\)\. .+\n\n"
    r"\*\*Options\.\*\* .+\n\n"
    r"(\*\*Figures\.\*\*\s.+\n\n)?\*\*Outcome\.\*\* .+",
    re.DOTALL,
)


def _records(page: str) -> list[str]:
    return re.split(r"(?m)^## ", (FOLDER / page).read_text())[1:]


@pytest.mark.parametrize("page", PAGES)
def test_records_have_date_context_options_and_outcome(page):
    titles = [record.splitlines()[0] for record in _records(page) if not _FORM.fullmatch(record)]
    assert titles == []


def test_the_first_page_leads_to_every_page():
    linked = re.findall(r"^\| \[.+\]\((.+)\) \|", (FOLDER / "README.md").read_text(), re.MULTILINE)
    assert sorted(linked) == PAGES
