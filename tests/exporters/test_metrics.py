import numpy as np
import pytest

from rna_export.metrics import (
    DARK,
    NoiselessPsnr,
    display,
    emission_exposure,
    exposure_of,
    flip,
    plain,
    psnr,
    psnr_without_noise,
    relative_error_p99,
    relative_mse,
    to_png,
)


def test_psnr_is_under_irradiance_pi():
    reference = np.full((100, 3), 0.2, np.float32)
    assert psnr(reference + np.float32(0.1 / np.pi), reference) == pytest.approx(20.0, abs=1e-3)


def test_psnr_clamps_to_display_white():
    bright = np.full((10, 3), 5.0, np.float32)
    assert psnr(2.0 * bright, bright) > 100.0
    assert psnr(-bright, 0.0 * bright) > 100.0


def test_relative_mse_does_not_clamp():
    bright = np.full((10, 3), 5.0, np.float32)
    assert relative_mse(1.1 * bright, bright) == pytest.approx(0.01, rel=1e-4)


def test_flip_knows_where_the_error_is():
    reference = np.full((32, 32, 3), 0.1, np.float32)
    image = reference.copy()
    image[8:16, 8:16] = 0.25
    mean, where = flip(image, reference)
    assert 0.0 < mean < 0.5
    assert where.shape == (32, 32)
    assert where[12, 12] > 10 * where[28, 28]
    assert flip(reference, reference)[0] == pytest.approx(0.0, abs=1e-6)


def test_png_is_srgb_under_irradiance_pi():
    image = np.array([[[0.0, 0.5 / np.pi, 10.0]]], np.float32)
    assert to_png(image).tolist() == [[[0, 188, 255]]]  # linear 0.5 is sRGB 188
    assert display(image).max() == 1.0


def test_relative_error_p99_is_of_the_worst_hundredth():
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


def test_psnr_without_noise_finds_a_known_error():
    true = grey(0.5)
    actual = psnr_without_noise(true + 0.01 / np.pi, *noisy(true, 0.03, seed=1))
    assert actual.high is not None and actual.low <= 40.0 <= actual.high
    assert actual.high - actual.low < 1.0


def test_psnr_without_noise_interval_holds_the_truth_19_times_in_20():
    true = grey(0.3, 2_000)
    actual = [psnr_without_noise(true + 0.03 / np.pi, *noisy(true, 0.1, s)) for s in range(300)]
    truth = -20.0 * np.log10(0.03)
    inside = [f.high is None or f.low <= truth <= f.high for f in actual]
    assert 0.92 < np.mean(inside) < 0.98


@pytest.mark.parametrize("noise", [0.02, 0.31, 1.0])
@pytest.mark.parametrize("level", [0.2, 0.9, 1.0, 1.2])
def test_a_perfect_model_is_at_least_as_good_as_noise_lets_one_see(noise, level):
    true = grey(level)
    halves = noisy(true, noise, seed=4)
    actual = psnr_without_noise(true, *halves)
    # The mean of 300,000 products of two noises, 1.96 of its standard deviations; more where
    # fewer numbers are within the display range. Of noise that carries a reference across white,
    # a twentieth stays.
    visible = -10.0 * np.log10(1.96 * noise**2 / np.sqrt(true.size))
    if actual.high is not None and actual.high - actual.low < 3.0:
        assert 0.8 < level < 1.0 and actual.low > psnr(true, halves.mean(axis=0)) + 10.0
    else:
        assert level > 0.8 or actual.db > visible - 6.0


@pytest.mark.parametrize("noise", [0.0, 0.05, 0.4])
@pytest.mark.parametrize("rows", [3, 2_000])
def test_taking_noise_out_never_lowers_the_psnr(rows, noise):
    rng = np.random.default_rng(5)
    for gain in (0.0, 0.5, 1.0, 1.02, 3.0):
        true = rng.gamma(0.7, 0.6, (rows, 3)) / np.pi  # some of it is white as displayed
        halves = np.maximum(noisy(true, noise, seed=6), 0.0)
        for shift in (-0.05, 0.0, 0.05):
            ours = gain * true + shift
            with_noise = psnr(ours, halves.mean(axis=0))
            actual = psnr_without_noise(ours, *halves)
            assert actual.db >= with_noise - 1e-9 and actual.low >= with_noise - 1e-9


def test_a_dark_model_of_a_white_asset_has_its_error_without_noise_too():
    actual = psnr_without_noise(grey(0.5, 500), *noisy(grey(3.0, 500), 0.1, seed=1))
    assert actual.high is not None and actual.db == pytest.approx(psnr(grey(0.5), grey(3.0)))


def test_skewed_noise_across_white_is_no_error_of_a_perfect_model():
    rng = np.random.default_rng(7)
    true = rng.uniform(0.0, 2.0, (200_000, 3)) / np.pi
    halves = [true * rng.gamma(10.0, 0.1, true.shape) for _ in range(2)]
    means = psnr_without_noise(true, *halves)
    assert means.high is None and means.db > 30.0


def test_a_mean_below_zero_is_a_lower_bound_and_not_120_db():
    true = grey(0.5, 50)
    half = true + 0.1 / np.pi
    other = true - 0.1 / np.pi  # the products are all negative
    assert psnr_without_noise(true + 0.001 / np.pi, half, other).high is None
    actual = [psnr_without_noise(true, *noisy(true, 0.1, seed)) for seed in range(40)]
    assert sum(f.high is None for f in actual) >= 35
    assert all(f.db < 40.0 for f in actual)  # 150 products of two noises of 0.1 tell no more


def test_mean_of_images_narrows_the_interval_and_keeps_a_lower_bound():
    one = NoiselessPsnr(30.0, 29.0, 31.0)
    four = NoiselessPsnr.mean([one] * 4)
    assert four == NoiselessPsnr(30.0, pytest.approx(29.5), pytest.approx(30.5))
    bound = NoiselessPsnr.mean([one, NoiselessPsnr(40.0, 40.0, None)])
    assert bound.high is None and bound.db == bound.low == pytest.approx(34.5)
    assert str(bound) == "at least 34.50 dB"
    assert str(one) == "30.00 dB (29.00 to 31.00)"


def test_dark_references_are_scored_at_an_exposure_that_shows_them():
    rng = np.random.default_rng(3)
    bright = rng.uniform(0.05, 0.3, (5_000, 3))
    guess = np.full_like(bright, bright.mean())
    assert exposure_of([bright]) == 1.0
    for factor in (0.1, 0.001):
        dark = factor * bright
        e = exposure_of([dark])
        assert np.percentile(display(dark, e), 99.0) == pytest.approx(DARK, rel=1e-3)
        # A constant is no better for the asset's darkness: 9 dB below white, as its 99% are.
        assert psnr(factor * guess, dark, e) < psnr(guess, bright) + 13.0
        assert psnr(factor * guess, dark) > psnr(guess, bright) + 19.0


def test_emission_is_scored_on_its_own_scale():
    rng = np.random.default_rng(3)
    for scale in (1e-4, 1.0, 500.0):
        emitted = scale * rng.uniform(0.0, 1.0, (5_000, 3))
        e = emission_exposure([emitted])
        assert np.percentile(display(emitted, e), 98.0) == pytest.approx(0.99, abs=0.01)
        assert psnr(1.1 * emitted, emitted, e) == pytest.approx(25.0, abs=1.0)


@pytest.mark.parametrize(
    ("references", "expected"),
    [
        ([], "black"),
        ([np.zeros((50, 3))], "black"),
        ([np.full((50, 3), 1e-6)], "black"),
        ([np.full((50, 3), [0.2, 0.0, 0.2])] * 2, "of one colour"),
        ([grey(3.0, 50)], "of one colour"),
        ([grey(0.5, 50), grey(0.6, 50)], None),
        ([0.001 * grey(0.5, 50), 0.001 * grey(0.6, 50)], None),
    ],
)
def test_references_without_a_picture_are_named(references, expected):
    assert plain(references) == expected
