"""The table of ten materials."""

from __future__ import annotations

import numpy as np

from rna_bench.accuracy.materials_command import NAMES, sheet


def test_the_sheet_has_a_row_a_material_and_enlarges_small_pictures() -> None:
    red = np.full((64, 64, 3), (200, 0, 0), np.uint8)
    blue = np.full((96, 96, 3), (0, 0, 200), np.uint8)
    actual = np.asarray(sheet([("wax", [red, blue]), ("fur", [blue])]))
    assert actual.shape == (2 * 150, 2 * 128, 3)
    assert (actual[22:150, :128] == (200, 0, 0)).all()
    assert (actual[172:300, :128] == (0, 0, 200)).all()
    assert (actual[172:300, 128:] == 255).all()


def test_the_recipe_has_every_material() -> None:
    from rna_bench.accuracy.materials_command import RECIPE

    text = RECIPE.read_text()
    assert all(f'"{name}": ' in text for name in (*NAMES, "glass", "volume"))
