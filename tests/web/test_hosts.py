"""Packages on servers of others: other origins, pages in the place of a package, requests."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.web.element_pages import SMALL, line, loads, show
from tests.web.pages import Ranges, served_folder

pytestmark = pytest.mark.chromium


@pytest.fixture(scope="module")
def elsewhere(folder) -> Iterator[str]:
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
