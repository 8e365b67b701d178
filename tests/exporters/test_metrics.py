from __future__ import annotations

import numpy as np
import pytest

from rna_export.metrics import (
    NoiselessPsnr,
    display,
    flip,
    psnr,
    psnr_without_noise,
    relative_error_p99,
    relative_mse,
    to_png,
)


def test_psnr_is_under_irradiance_pi() -> None:
    reference = np.full((100, 3), 0.2, np.float32)
    assert psnr(reference + np.float32(0.1 / np.pi), reference) == pytest.approx(20.0, abs=1e-3)


def test_psnr_clamps_to_display_white() -> None:
    bright = np.full((10, 3), 5.0, np.float32)
    assert psnr(2.0 * bright, bright) > 100.0
    assert psnr(-bright, 0.0 * bright) > 100.0


def test_relative_mse_does_not_clamp() -> None:
    bright = np.full((10, 3), 5.0, np.float32)
    assert relative_mse(1.1 * bright, bright) == pytest.approx(0.01, rel=1e-4)


def test_flip_knows_where_the_error_is() -> None:
    reference = np.full((32, 32, 3), 0.1, np.float32)
    image = reference.copy()
    image[8:16, 8:16] = 0.25
    mean, where = flip(image, reference)
    assert 0.0 < mean < 0.5
    assert where.shape == (32, 32)
    assert where[12, 12] > 10 * where[28, 28]
    assert flip(reference, reference)[0] == pytest.approx(0.0, abs=1e-6)


def test_png_is_srgb_under_irradiance_pi() -> None:
    image = np.array([[[0.0, 0.5 / np.pi, 10.0]]], np.float32)
    assert to_png(image).tolist() == [[[0, 188, 255]]]  # linear 0.5 is sRGB 188
    assert display(image).max() == 1.0


def test_relative_error_p99_is_of_the_worst_hundredth() -> None:
    reference = np.full((1000, 3), 0.5, np.float32)
    image = reference.copy()
    image[:15] += 0.55  # of 0.5 and a tenth of the mean, 0.05: once the reference
    assert relative_error_p99(image, reference) == pytest.approx(1.0, rel=1e-5)
    image[5:] = reference[5:]
    assert relative_error_p99(image, reference) == 0.0


def noisy(true: np.ndarray, noise: float, seed: int) -> np.ndarray:
    """Two independent halves of a reference under white noise of that size as displayed."""
    rng = np.random.default_rng(seed)
    return true + rng.normal(0.0, noise / np.pi, (2, *true.shape))


def grey(level: float, rows: int = 100_000) -> np.ndarray:
    """Radiance that is displayed as `level`."""
    return np.full((rows, 3), level / np.pi)


def test_psnr_without_noise_finds_a_known_error() -> None:
    true = grey(0.5)
    found = psnr_without_noise(true + 0.01 / np.pi, *noisy(true, 0.03, seed=1))
    assert found.high is not None and found.low <= 40.0 <= found.high
    assert found.high - found.low < 1.0


def test_psnr_without_noise_interval_holds_the_truth_19_times_in_20() -> None:
    true = grey(0.3, 2_000)
    found = [psnr_without_noise(true + 0.03 / np.pi, *noisy(true, 0.1, s)) for s in range(300)]
    truth = -20.0 * np.log10(0.03)
    inside = [f.high is None or f.low <= truth <= f.high for f in found]
    assert 0.92 < np.mean(inside) < 0.98


@pytest.mark.parametrize("noise", [0.02, 0.31, 1.0])
@pytest.mark.parametrize("level", [0.2, 0.9, 1.0, 1.2])
def test_a_perfect_model_is_at_least_as_good_as_noise_lets_one_see(
    noise: float, level: float
) -> None:
    true = grey(level)
    found = psnr_without_noise(true, *noisy(true, noise, seed=4))
    # The mean of 300,000 products of two noises, 1.96 of its standard deviations; more where
    # fewer numbers are within the display range.
    visible = -10.0 * np.log10(1.96 * noise**2 / np.sqrt(true.size))
    assert found.high is None or found.high - found.low > 3.0
    assert level > 1.1 or found.db > visible - 6.0


def test_skewed_noise_across_white_is_no_error_of_a_perfect_model() -> None:
    rng = np.random.default_rng(7)
    true = rng.uniform(0.0, 2.0, (200_000, 3)) / np.pi
    halves = [true * rng.gamma(10.0, 0.1, true.shape) for _ in range(2)]
    means = psnr_without_noise(true, *halves)
    assert means.high is None and means.db > 30.0


def test_a_mean_below_zero_is_a_lower_bound_and_not_120_db() -> None:
    true = grey(0.5, 50)
    half = true + 0.1 / np.pi
    other = true - 0.1 / np.pi  # the products are all negative
    assert psnr_without_noise(true + 0.001 / np.pi, half, other).high is None
    found = [psnr_without_noise(true, *noisy(true, 0.1, seed)) for seed in range(40)]
    assert sum(f.high is None for f in found) >= 35
    assert all(f.db < 40.0 for f in found)  # 150 products of two noises of 0.1 tell no more


def test_mean_of_images_narrows_the_interval_and_keeps_a_lower_bound() -> None:
    one = NoiselessPsnr(30.0, 29.0, 31.0)
    four = NoiselessPsnr.mean([one] * 4)
    assert four == NoiselessPsnr(30.0, pytest.approx(29.5), pytest.approx(30.5))
    bound = NoiselessPsnr.mean([one, NoiselessPsnr(40.0, 40.0, None)])
    assert bound.high is None and bound.db == bound.low == pytest.approx(34.5)
    assert str(bound) == "at least 34.50 dB"
    assert str(one) == "30.00 dB (29.00 to 31.00)"


def test_nothing_within_the_display_range_says_nothing() -> None:
    white = grey(3.0, 10)
    assert psnr_without_noise(white, white, white) == NoiselessPsnr(0.0, 0.0, None)
