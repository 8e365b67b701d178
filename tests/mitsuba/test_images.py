"""Pictures by Mitsuba with `rna_mitsuba` and by rna-run have the same mean, by Welch's test."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from tests.conformance.conftest import KIT
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package
from tests.render.studio import one_thread
from tests.render.test_second_opinion import LEVEL, coarser, student_limit, welch

if TYPE_CHECKING:
    from tests.mitsuba.scene_pairs import Pair

SIZE, BATCHES = (24, 16), 24


@pytest.mark.parametrize(
    ("name", "samples"),
    [("sun", 16), ("environment and ground", 40), ("lamp and red wall", 40), ("curls", 128)],
)
def test_both_show_the_same(name, samples, tmp_path):
    from tests.mitsuba.scene_pairs import pairs

    assert_both_alike(pairs(tmp_path)[name], samples, tmp_path)


def test_assets_whose_boxes_overlap_shadow_each_other_alone(tmp_path):
    """A ray that starts on a toy passes through it, and is stopped by the one that stands in it."""
    import mitsuba as mi

    import rna_mitsuba
    from tests.mitsuba.scene_pairs import TOY, Pair, sun

    light = (-0.6, 0.5, 0.7), (2.5, 2.4, 2.2)
    place = {"translation": (0.22, 0.14, 0.18)}
    pair = Pair(
        {
            "assets": [{"path": str(TOY)}, {"path": str(TOY), "transform": place}],
            "lights": [{"type": "directional", "direction": light[0], "irradiance": light[1]}],
        },
        {
            "one": rna_mitsuba.asset(TOY),
            "other": rna_mitsuba.asset(
                TOY, to_world=mi.ScalarTransform4f().translate(place["translation"])
            ),
            "sun": sun(*light),
        },
        {"position": (1.5, 0.95, 1.2), "look_at": (0.45, 0.25, -0.05), "vertical_fov_deg": 30},
        2,
    )
    assert_both_alike(pair, 48, tmp_path)


@pytest.mark.parametrize("name", ["surface", "fiber"])
def test_nearby_light_of_one_ray_a_sample_is_the_same(name, tmp_path):
    import rna_mitsuba
    from tests.mitsuba.scene_pairs import Pair, sun

    package, light = KIT / "packages" / f"{name}-nearby.rna", ((-0.6, 0.5, 0.7), (0.5, 0.4, 0.3))
    pair = Pair(
        {
            "assets": [{"path": str(package)}],
            "lights": [{"type": "directional", "direction": light[0], "irradiance": light[1]}],
        },
        {"asset": rna_mitsuba.asset(package), "sun": sun(*light)},
        {"position": (1.9, 2.2, 1.8), "look_at": (0.0, 0.0, 0.0), "vertical_fov_deg": 35},
        1,
    )
    assert_both_alike(pair, 16, tmp_path)


def test_the_inside_of_a_solid_is_black_to_scattered_rays(tmp_path):
    """On the ground inside a ball the sun does not shine, nor does the ball's inside."""
    import rna_mitsuba
    from tests.mitsuba.scene_pairs import Pair, Theirs, ground, sun

    ball = tmp_path / "ball.rna"
    write_lambert_package(ball, sphere(3))
    entries = {
        "ball": rna_mitsuba.asset(ball),
        "ground": ground((0.8, 0.8, 0.8)),
        "sun": sun((0, 1, 0), (2, 2, 2)),
    }
    camera = {"position": (0.1, 0.3, 0.1), "look_at": (0.2, 0, 0.1), "vertical_fov_deg": 20}
    assert (Theirs(Pair({}, entries, camera, max_depth=3), SIZE, 4)(0) == 0).all()


def assert_both_alike(pair: Pair, samples: int, tmp_path: Path) -> None:
    from tests.mitsuba.scene_pairs import Ours, Theirs

    """`samples` a pixel of ours; four times as many of Mitsuba's, which cost less."""
    theirs = Theirs(pair, SIZE, 4 * samples)
    reference = np.stack([theirs(seed) for seed in range(BATCHES)])
    with one_thread():
        ours = Ours(tmp_path, pair, SIZE, samples)
        mine = np.stack([ours(seed) for seed in range(BATCHES)])
    for size in (1, 4, None):  # pixels, tiles and the whole
        t = welch(coarser(mine, size), coarser(reference, size))
        assert np.abs(t).max() < student_limit(1 - (1 - LEVEL) ** (1 / t.size), BATCHES - 1)
    means = [coarser(x, None).mean(axis=0).ravel() for x in (mine, reference)]
    np.testing.assert_allclose(*means, rtol=0.04)
