"""How bright answers are over the references."""

import numpy as np
import pytest

from rna_export.brightness import brightness

RNG = np.random.default_rng(0)
REFERENCE = RNG.random((1000, 3)) + 0.1
VISIBLE = RNG.random(1000) < 0.6


def scaled(lit: float, shadowed: float) -> np.ndarray:
    return REFERENCE * np.where(VISIBLE, lit, shadowed)[:, None]


def test_lit_and_shadowed_are_told_apart():
    images = [(scaled(0.9, 0.7)[:400], REFERENCE[:400], VISIBLE[:400])]
    images += [(scaled(0.9, 0.7)[400:], REFERENCE[400:], VISIBLE[400:])]
    actual = brightness(images)
    assert actual.lit == pytest.approx([0.9] * 3)
    assert actual.shadowed == pytest.approx([0.7] * 3)
    assert actual.shadow_share == pytest.approx([0.4] * 3, abs=0.05)


def test_coloured_visibility_is_lit_where_most_passes():
    coloured = VISIBLE[:, None] * np.array([1.0, 0.9, 0.3])
    actual = brightness([(scaled(0.5, 1.0), REFERENCE, coloured)])
    assert actual.lit == pytest.approx([0.5] * 3)


@pytest.mark.parametrize(
    ("lit", "shadowed", "faults"), [(1.0, 1.0, 0), (1.015, 0.96, 0), (0.97, 1.0, 1), (1.05, 0.9, 2)]
)
def test_faults(lit, shadowed, faults):
    assert len(brightness([(scaled(lit, shadowed), REFERENCE, VISIBLE)]).faults) == faults


def test_an_asset_without_shadow_has_no_fault_in_it():
    actual = brightness([(REFERENCE, REFERENCE, np.ones(1000))])
    assert np.isnan(actual.shadowed).all() and not actual.faults
