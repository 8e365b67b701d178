"""What the element says: to visitors in their language, to makers of pages in the console."""

from pathlib import Path

import pytest

from tests.web.in_node import ELEMENT_SOURCES, in_node

GROUND = "ground: expected an opaque background-color"


@pytest.fixture(scope="module")
def told():
    program = Path(__file__).parent / "element_texts.mjs"
    return in_node(program, ELEMENT_SOURCES.as_uri())


def test_ten_languages_have_every_text(told):
    languages = told["languages"]
    assert len(languages) == 10
    for texts in languages.values():
        assert list(texts) == told["names"] and all(texts.values())
        assert [name for name, text in texts.items() if "{name}" in text] == ["shown"]
    distinct = {texts["prompt"] for texts in languages.values()}
    assert len(distinct) == 10


def test_texts_of_the_page_go_first(told):
    assert told["own"] == "Da: Auto {x}"
    assert all(line.startswith("expected a JSON object of texts") for line in told["refused"])


def test_visitors_see_a_calm_line_and_the_console_has_all(told):
    """No mistakes of the page; a line for a while; permanently in an empty place."""
    german = told["languages"]["de"]
    *visitors, whole = told["steps"]
    assert visitors == [None, [german["unavailable"]], None, [german["failed"]]]
    assert whole == [GROUND, "tiny.rna: HTTP 404"]
    assert told["said"] == [
        ["warn", f"rna-viewer: {GROUND}"],
        ["error", "rna-viewer: WebGPU has no adapter here"],
        ["error", "rna-viewer: tiny.rna: HTTP 404"],
    ]


def test_an_empty_address_is_none(told):
    assert told["empty"] == [None] * 5


def test_names_of_model_viewer_have_a_line(told):
    ar, environment, exposure = told["strangers"]
    assert "no attribute ar," in ar and "there is no AR" in ar
    assert environment.endswith("here it is environment") and "stops" in exposure
    assert told["ours"] == []
