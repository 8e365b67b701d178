"""Figures of `rna-bench lobes-scenes`: errors, and times at equal error."""

import numpy as np
import pytest

from rna_bench.lobes.lobes_scenes import _Judge, _times_as_fast
from rna_bench.lobes.lobes_scenes_chart import draw_errors


def rows(error, seconds):
    return [{"samples": n, "error": error / n, "cpu_seconds": seconds * n} for n in (1, 2, 4)]


def test_half_the_error_in_the_same_time_is_twice_as_fast():
    lobes = {"samples": 1, "error": 0.4, "cpu_seconds": 3.0}
    assert _times_as_fast(lobes, rows(0.8, 3.0)) == pytest.approx(2.0)


def test_an_image_that_is_brighter_by_a_tenth():
    reference = np.full((8, 8, 3), 2.0, np.float32)
    found = _Judge(reference, np.ones((8, 8), bool))(1.1 * reference)
    assert found["brightness"] == pytest.approx([1.1] * 3)
    assert found["error"] == pytest.approx(0.01 / 1.01, rel=1e-4)


def test_the_chart_has_a_panel_for_each_scene():
    scene = {"rays": rows(0.8, 3.0), "lobes": rows(0.2, 4.0)}
    scene |= {"bias": {"samples": 64, "error": 0.01}}
    chart = draw_errors(dict.fromkeys(("a", "b", "c", "d", "e"), scene))
    assert [panel.get_title(loc="left") for panel in chart.axes[:5]] == ["a", "b", "c", "d", "e"]
