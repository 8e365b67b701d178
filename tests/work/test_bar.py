"""Progress in a pipe: lines that follow one another, ten seconds apart."""

import io
import re

import pytest

from rna_work import bar as bar_module
from rna_work.bar import Bar


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.fixture
def now(monkeypatch):
    """The clock, whose last entry is the time."""
    times = [0.0]
    monkeypatch.setattr(bar_module, "monotonic", lambda: times[-1])
    return times


def test_a_log_has_a_line_every_ten_seconds_and_one_at_the_end(now, monkeypatch):
    log = io.StringIO()
    monkeypatch.setattr("sys.stderr", log)
    with Bar(total=100, desc="rays", unit="ray", mininterval=0.0, miniters=1) as bar:
        for k in range(100):
            now.append(0.25 * (k + 1))
            bar.update()
        bar.write("a note", file=log)
    lines = log.getvalue().splitlines()
    assert "\r" not in log.getvalue()
    assert [re.match(r"rays: +(\d+)%\| \d+/100 \[", line) is not None for line in lines] == [
        *(True, True, False, True)
    ]
    assert [line.split("%")[0] for line in lines] == [
        "rays:  40",
        "rays:  80",
        "a note",
        "rays: 100",
    ]


def test_a_stage_that_begins_is_a_line_and_a_bar_that_leaves_is_none(now, monkeypatch):
    log = io.StringIO()
    monkeypatch.setattr("sys.stderr", log)
    with Bar(total=10, bar_format="{desc}: {percentage:3.0f}%|{bar}|", leave=False) as bar:
        bar.set_description_str("round 1")
        bar.update(5)
        bar.set_description_str("round 2")
    assert log.getvalue() == "round 1:   0%|\nround 2:  50%|\n"


def test_a_terminal_has_a_bar(monkeypatch):
    shown = Terminal()
    monkeypatch.setattr("sys.stderr", shown)
    with Bar(total=4, desc="rays", mininterval=0.0, miniters=1) as bar:
        bar.update(2)
    assert "\rrays:  50%|#" in shown.getvalue()
