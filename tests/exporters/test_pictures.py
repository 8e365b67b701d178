"""Contact sheets."""

from __future__ import annotations

import numpy as np
import pytest

from rna_export.pictures import COLUMNS, comparison_sheet, enlarged

DOT = (200, 0, 0)


@pytest.mark.parametrize(("width", "times"), [(56, 3), (127, 2), (128, 1), (320, 1)])
def test_small_pictures_of_a_sheet_are_enlarged(width: int, times: int) -> None:
    pictures = [np.full((20, width, 3), value, np.uint8) for value in (40, 80, 120, 160)]
    pictures[0][3, 5] = DOT
    sheet = np.asarray(comparison_sheet([(pictures, "caption"), (pictures, "caption")]))
    assert sheet.shape[1] == len(COLUMNS) * width * times >= 4 * 128
    assert np.count_nonzero((sheet == DOT).all(axis=2)) == 2 * times**2
    for value in (80, 120):
        assert np.count_nonzero((sheet == value).all(axis=2)) >= 2 * 20 * width * times**2
    square = enlarged(pictures[0])[3 * times : 4 * times, 5 * times : 6 * times]
    assert square.shape[:2] == (times, times) and (square == DOT).all()
