"""Sizes of the scripts as the documents tell them."""

import gzip
import re
import tarfile

import pytest

from rna_view.site_files import ELEMENT, viewer_file
from tests.conftest import REPOSITORY
from tests.web.three.pages import packed

TOLD = {
    "element.md": r"without dependencies \((\d+) kB, (\d+) kB compressed\)",
    "web.md": r"br or gzip \((\d+) kB, (\d+) kB\)",
    "three.md": r"\| module \| (\d+) kB, (\d+) kB gzipped",
}
BOTH = r"size without assets, compressed \| (\d+) kB \| (\d+) kB, and three"
TOLERANCE = 0.03


def _told(document: str, pattern: str) -> list[int]:
    found = re.search(pattern, (REPOSITORY / "docs" / document).read_text())
    assert found is not None, f"{document}: no {pattern}"
    return [int(size) for size in found.groups()]


def _sizes(script: bytes) -> list[float]:
    return [len(script) / 1e3, len(gzip.compress(script, 9)) / 1e3]


def test_sizes_are_those_of_the_documents():
    with tarfile.open(packed("rna-three")) as archive:
        module = archive.extractfile("package/rna-three.js")
        assert module is not None
        three = _sizes(module.read())
    element = _sizes(viewer_file(ELEMENT))
    for document in ("element.md", "web.md"):
        assert _told(document, TOLD[document]) == pytest.approx(element, rel=TOLERANCE)
    assert _told("three.md", TOLD["three.md"]) == pytest.approx(three, rel=TOLERANCE)
    assert _told("web.md", BOTH) == pytest.approx([element[1], three[1]], rel=TOLERANCE)
