"""rna-bench guided-capture: how many lights of a plain capture a guided one is worth."""

from __future__ import annotations

import pytest

from rna_bench.accuracy.guided_capture import lights_for

ROWS = [
    {"lights": 100, "psnr": 30.0},
    {"lights": 200, "psnr": 32.0},
    {"lights": 300, "psnr": 31.9},
    {"lights": 400, "psnr": 33.0},
]


@pytest.mark.parametrize(
    ("psnr", "lights"), [(30.0, 100.0), (31.0, 100.0 * 2.0**0.5), (32.0, 200.0), (33.0, 400.0)]
)
def test_lights_are_interpolated_in_their_logarithm(psnr: float, lights: float) -> None:
    assert lights_for(psnr, ROWS) == pytest.approx(lights)


@pytest.mark.parametrize("psnr", [29.9, 33.1])
def test_nothing_is_said_beyond_the_measured(psnr: float) -> None:
    assert lights_for(psnr, ROWS) is None
