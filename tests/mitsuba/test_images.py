"""Pictures by Mitsuba with `rna_mitsuba` and by rna-run have the same mean, by Welch's test."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.render.studio import one_thread
from tests.render.test_second_opinion import LEVEL, coarser, student_limit, welch

SIZE, BATCHES = (24, 16), 16


@pytest.mark.parametrize(
    ("name", "samples"),
    [("sun", 32), ("environment and ground", 128), ("lamp and red wall", 160), ("curls", 512)],
)
def test_both_show_the_same(name: str, samples: int, tmp_path: Path) -> None:
    from benchmarks.mitsuba_scenes import Ours, Theirs, pairs

    pair = pairs(tmp_path)[name]
    theirs = Theirs(pair, SIZE, samples)
    reference = np.stack([theirs(seed) for seed in range(BATCHES)])
    with one_thread():
        ours = Ours(tmp_path, pair, SIZE, samples)
        mine = np.stack([ours(seed) for seed in range(BATCHES)])
    for size in (1, 4, None):  # pixels, tiles and the whole
        t = welch(coarser(mine, size), coarser(reference, size))
        assert np.abs(t).max() < student_limit(1 - (1 - LEVEL) ** (1 / t.size), BATCHES - 1)
    means = [coarser(x, None).mean(axis=0).ravel() for x in (mine, reference)]
    np.testing.assert_allclose(*means, rtol=0.04)
