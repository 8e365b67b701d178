"""Strands far thinner than a pixel: how much of the image they cover, and how evenly."""

import numpy as np
import pytest

from rna_sdk.package import Curves
from tests.render.assets import FiberProbe
from tests.render.stage import image

SIDE, DISTANCE, COUNT = 48, 1000.0, 10
UPRIGHT, LYING = (0, 1, 0), (1, 0, 0)


def slanted(width: float) -> tuple[Curves, np.ndarray, np.ndarray]:
    """Ten strands across the image, each a little more or less than upright.

    One unit is a pixel. Returns the place of each at height 0, and the area it covers.
    """
    rng = np.random.default_rng(3)
    place = 4.5 * (np.arange(COUNT) - 4.5) + rng.uniform(-0.5, 0.5, COUNT)
    slope = rng.uniform(-0.04, 0.04, COUNT)
    height = np.tile(np.linspace(-30, 30, 41), (COUNT, 1))
    points = np.stack([place[:, None] + slope[:, None] * height, height, 0 * height], axis=2)
    curves = Curves(
        points=points.reshape(-1, 3).astype(np.float32),
        radii=np.full(height.size, width / 2, np.float32),
        offsets=np.arange(0, height.size + 1, height.shape[1], dtype=np.uint32),
    )
    return curves, place, width * SIDE * np.sqrt(1 + slope**2)


def alpha(curves: Curves, samples: int, seed: int, up=UPRIGHT) -> np.ndarray:
    """(SIDE, SIDE) coverage, turned so that the strands stand upright."""
    camera = {"position": (0, 0, DISTANCE), "look_at": (0, 0, 0), "up": up}
    camera["vertical_fov_deg"] = 2 * np.degrees(np.arctan(SIDE / 2 / DISTANCE))
    changes = {"camera": camera, "resolution": (SIDE, SIDE), "samples": samples, "seed": seed}
    plane = image([(FiberProbe(curves), {})], [], **changes)["A"].astype(np.float64)
    return plane if up == UPRIGHT else np.rot90(plane, -1)


def around(plane: np.ndarray, place: float) -> np.ndarray:
    """The columns that a strand may touch."""
    middle = SIDE / 2 + place
    return plane[:, int(middle - 2) : int(np.ceil(middle + 2))]


@pytest.mark.parametrize("up", [UPRIGHT, LYING])
@pytest.mark.parametrize("width", [0.3, 0.04])
def test_mean_alpha_is_the_area_covered(width, up):
    curves, place, area = slanted(width)
    plane = alpha(curves, 256, seed=1, up=up)
    assert plane.sum() == pytest.approx(area.sum(), rel=0.01)
    for x, expected in zip(place, area, strict=True):
        strand = around(plane, x)
        assert strand.sum() == pytest.approx(expected, rel=0.08)
        # No part of a strand is lost: eight pixels of it, at 0.04 wide, are some 80 hits.
        pieces = strand.reshape(6, SIDE // 6, -1).sum(axis=(1, 2))
        np.testing.assert_allclose(pieces, expected / 6, rtol=0.3)


def test_samples_are_spread_over_the_pixel():
    """At 64 samples a pixel, chance alone would make the image's coverage vary far more."""
    curves, _, area = slanted(0.04)
    share, samples = area.sum() / SIDE**2, 64
    means = [alpha(curves, samples, seed).mean() for seed in range(12)]
    by_chance = share * (1 - share) / (samples * SIDE**2)
    assert np.var(means, ddof=1) < 0.4 * by_chance
