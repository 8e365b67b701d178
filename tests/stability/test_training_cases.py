"""Cases about training data and chance."""

import numpy as np
import pytest

from rna_bench.stability.cases import little_data, luck, near_light, noise
from rna_bench.stability.chosen import ChosenSamples, light_numbers, rows_of
from tests.exporters.synthetic import LIGHTS_A_SHARD, RAYS, make_dataset


@pytest.mark.parametrize(("spread", "passes"), [(0.29, True), (0.31, False)])
def test_luck(spread, passes):
    rows = [{"seed": k, "psnr": 30.0 + spread * k / 4} for k in range(5)]
    assert luck.judge(rows).passed == passes


def test_bias_is_the_share_of_light_that_is_lost(tmp_path):
    views = make_dataset(tmp_path).validation_views()
    right = [view.samples["radiance"] for view in views]
    assert noise.row_of(right, views)["bias"] == pytest.approx(0.0, abs=1e-6)
    dark = noise.row_of([0.9 * r for r in right], views)
    assert dark["bias"] == pytest.approx(-0.1, abs=1e-6)


@pytest.mark.parametrize(("bias", "passes"), [(-0.01, True), (-0.05, False), (0.05, False)])
def test_noise_is_judged_from_four_paths_on_by_the_chosen_loss(bias, passes):
    rows = [
        {"paths": paths, "loss": loss, "chosen": chosen, "bias": bias if chosen else -0.1}
        for paths in noise.PATHS
        for loss, chosen in (("log", paths > 4), ("unbiased", paths <= 4))
    ]
    rows[0]["bias"] = rows[1]["bias"] = -0.4  # of one path
    assert noise.judge(rows).passed == passes


def test_lights_are_counted_and_chosen(tmp_path):
    dataset = make_dataset(tmp_path)
    light = light_numbers(dataset.training_samples())
    assert np.array_equal(np.unique(light, return_counts=True)[1], [RAYS] * 3 * LIGHTS_A_SHARD)
    rows = little_data.subset(light, np.array([2, 5]), 100)
    assert len(rows) == 100 and set(light[rows]) == {2, 5}
    some = ChosenSamples(dataset, lambda samples: rows_of(samples, rows))
    assert len(some.training_samples()["visible"]) == 100
    assert len(dataset.training_samples()["visible"]) == len(light)


@pytest.mark.parametrize(
    ("psnr_of_few", "gap", "passes"), [(29.5, 0.5, True), (28.0, 0.5, False), (29.5, 2.0, False)]
)
def test_little_data(psnr_of_few, gap, passes):
    rows = [
        {"series": "lights", "lights": 1000, "points": 100, "psnr": psnr_of_few, "gap_db": 5.0},
        {"series": "lights", "lights": 3000, "points": 100, "psnr": 30.0, "gap_db": 5.0},
        {"series": "points", "lights": 3000, "points": 10_000, "psnr": 33.0, "gap_db": gap},
    ]
    assert little_data.judge(rows).passed == passes


@pytest.mark.parametrize(("near", "passes"), [(31.0, True), (28.0, False)])
def test_near_light(near, passes):
    rows = [{"distance": d, "psnr": near if d < 1.0 else 33.0} for d in near_light.DISTANCES]
    assert near_light.judge(rows).passed == passes
