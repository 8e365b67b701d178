"""Fingers, mouse and wheel: what they do is known before anything moves."""

from pathlib import Path

import pytest

from tests.web.in_node import SOURCES, in_node


@pytest.fixture(scope="module")
def heard():
    """By gesture of gestures.mjs: the actions, with their values."""
    return in_node(Path(__file__).parent / "gestures.mjs", (SOURCES / "ui" / "pointer.js").as_uri())


def test_a_finger_that_scrolls_the_page_moves_nothing(heard):
    """Nor where it goes sideways later: the browser has it."""
    assert heard["upwards"] == heard["panX"] == heard["pages"] == []
    assert [name for name, *_ in heard["sideways"]] == ["orbit"]
    assert [name for name, *_ in heard["upwardsAlone"]] == ["orbit"]


def test_a_gesture_that_the_browser_takes_over_is_undone(heard):
    assert [name for name, *_ in heard["taken"]] == ["orbit", "undone"]


def test_a_mouse_orbits_at_once(heard):
    assert [name for name, *_ in heard["mouse"]] == ["orbit"]


def test_two_fingers_either_pinch_and_pan_or_twist(heard):
    (zoom, factor), (pan, *_) = heard["pinch"]
    assert (zoom, factor, pan) == ("zoom", pytest.approx(40 / 60, abs=1e-3), "pan")
    assert {name for name, *_ in heard["twist"]} == {"light"}
    assert "light" not in {name for name, *_ in heard["pan"]}
    assert heard["left"] == []


def test_a_wheel_that_scrolls_the_page_does_not_zoom_on_its_way(heard):
    """Over it; from beside it; later; with Ctrl; where the element has no focus."""
    assert heard["wheel"] == [2, 0, 1, 1, 0]
