"""FLIP of the asset's pixels: exposure, pixels, noise of references, emission."""

from itertools import pairwise

import numpy as np
import pytest

from rna_export.asset_flip import (
    MOST_STOPS,
    SHOWN_AT,
    UNLIT_STOPS,
    ImageFlip,
    asset_flip,
    luminance_level,
    scene_exposures,
    without_noise,
)
from rna_export.capture.dataset.validation_view import EmissionView, ValidationView
from rna_export.metrics import display, flip
from rna_export.training.asset_error import asset_error, worse_error
from rna_render.lights import LUMINANCE
from rna_sdk.commands.error_words import error_in_words

SIDE = 48


def texture(seed: int = 1) -> np.ndarray:
    """Radiance of a picture's pixels, (SIDE^2, 3), some of it bright."""
    rng = np.random.default_rng(seed)
    coarse = rng.gamma(1.5, 0.05, (SIDE // 8, SIDE // 8, 3))
    return np.kron(coarse, np.ones((8, 8, 1))).reshape(-1, 3).astype(np.float32)


def view_of(reference: np.ndarray, noise: float = 0.0, kind: type = ValidationView) -> object:
    """An image that the asset fills, of a reference with independent noise in both halves."""
    rng = np.random.default_rng(2)
    spread = noise * np.sqrt(reference * reference.mean())
    halves = (reference + rng.normal(size=(2, *reference.shape)) * spread).astype(np.float32)
    pixel = np.arange(SIDE**2, dtype=np.int32)
    return kind(0, SIDE, pixel, {"radiance": halves.mean(axis=0)}, halves)


def test_a_dim_picture_of_the_same_scene_has_the_same_error():
    reference = texture()
    errors = [asset_error([1.2 * k * reference], [view_of(k * reference)]) for k in (1.0, 0.02)]
    assert errors[0].mean > 0.03
    assert errors[1].mean == pytest.approx(errors[0].mean, rel=1e-3)


def test_each_picture_is_exposed_but_a_rim_of_light_is_not_blown_up():
    pictures = [k * texture() for k in (0.2, 0.2, 0.2, 0.05, 0.01)]
    exposures = scene_exposures([luminance_level(picture) for picture in pictures])
    for reference, e in zip(pictures[:4], exposures, strict=False):
        shown = display(reference, e.factor) @ LUMINANCE
        level = np.percentile(reference @ LUMINANCE * np.pi * e.factor, 95)
        assert level == pytest.approx(SHOWN_AT) and e.is_lit
        assert shown.max() <= 1.0 + 1e-6
    assert exposures[4].factor / exposures[0].factor == pytest.approx(2.0**MOST_STOPS)
    assert exposures[4].is_lit  # within five stops
    assert scene_exposures([0.0, 0.0]) == [(1.0, True)] * 2


def test_one_bright_close_up_does_not_rule_the_others():
    """As of the bundled toy: a highlight that fills one picture made all others black."""
    views = [view_of(k * texture(j)) for j, k in enumerate((1.0, 0.8, 1.2, 0.9, 0.5, 0.7, 0.6))]
    ours = [1.3 * view.reference for view in views]
    close_up = view_of(200.0 * texture(9))
    usual = asset_error(ours, views)
    beside = asset_error([*ours, close_up.reference], [*views, close_up])
    of_others = beside.mean * beside.images / usual.images  # the close-up is without error
    assert (usual.images, beside.images) == (7, 8)
    assert usual.mean > 0.05 and of_others == pytest.approx(usual.mean, rel=0.01)


def test_pictures_without_light_do_not_count_and_are_told():
    views = [view_of(texture(k)) for k in range(3)]
    dark = view_of(0.9 * 2.0**-UNLIT_STOPS * texture(2))
    ours = [1.3 * view.reference for view in views]
    error = asset_error([*ours, np.zeros_like(dark.reference)], [*views, dark])
    assert (error.images, error.unlit) == (3, 1)
    assert error.mean == pytest.approx(asset_error(ours, views).mean, rel=1e-3)


def test_background_does_not_count():
    image = np.zeros((64, 64, 3), np.float32)
    image[16:48, 16:48] = 0.2
    worse, covered = 1.3 * image, image[..., 0] > 0
    alone = ImageFlip.of(worse, np.stack([image] * 2), covered, 1.0)
    assert len(alone.errors) == 32 * 32
    assert alone.mean == pytest.approx(flip(worse, image)[1][covered].mean(), rel=1e-6)
    assert alone.mean > 3.0 * flip(worse, image)[0]


@pytest.mark.parametrize("noise", [0.05, 0.15])
@pytest.mark.parametrize("error", [0.03, 0.1, 0.3])
def test_noise_of_the_reference_is_not_counted(noise, error):
    reference = texture()
    ours = reference * (1.0 + error * np.sign(texture(3) - np.median(texture(3))))
    expected = asset_error([ours], [view_of(reference)])
    actual = asset_error([ours], [view_of(reference, noise)])
    assert actual.mean == pytest.approx(expected.mean, rel=0.1, abs=0.004)
    assert actual.p95 == pytest.approx(expected.p95, rel=0.2, abs=0.02)


def test_a_perfect_model_is_very_good_under_noise():
    reference = texture()
    view = view_of(reference, noise=0.15)
    (e,) = scene_exposures([luminance_level(reference)])
    assert flip(view.image(reference), view.image(view.reference), e.factor)[0] > 0.035
    assert error_in_words(asset_error([reference], [view]).mean) == error_in_words(0.0)


def test_noise_is_taken_out_where_colour_distances_add_in_squares():
    distance, variance = 0.3, 0.02
    noisy, noisier = ((distance**2 + k * variance) ** 0.35 for k in (1, 2))
    assert without_noise(noisy, noisier) == pytest.approx(distance**0.7)
    assert without_noise(0.2, 0.19) == 0.2  # never above what was found
    assert without_noise(0.1, 0.5) == pytest.approx(0.025)  # nor nothing, where noise hides it


def test_the_95th_percentile_is_of_the_pixels_of_all_images():
    good, bad = np.full(900, 0.1), np.full(100, 0.5)
    images = [ImageFlip(rows, np.tile(rows, 2)) for rows in (good, bad)]
    assert asset_flip(images).p95 == pytest.approx(0.5)
    assert asset_flip(images).mean == pytest.approx(0.3)
    assert asset_flip([*images, ImageFlip(np.zeros(0), np.zeros(0))]).images == 2


def test_the_worse_of_light_and_emission_counts_and_a_black_board_does_not():
    reference = texture()
    sign = np.zeros_like(reference)
    sign[: SIDE * 4] = 3.0
    wrong = 0.5 * sign
    light = asset_error([1.02 * reference], [view_of(reference)])
    glow = view_of(sign, kind=EmissionView)
    expected = asset_error([wrong], [glow])
    assert expected.mean > 0.15  # of the sign's pixels, which are 8% of the picture
    assert worse_error(light, [(wrong, glow)]) == expected
    assert worse_error(light, [(sign, glow)]) == light
    assert worse_error(light, []) == light


def test_words_get_worse_with_the_error():
    words = [error_in_words(flip) for flip in np.arange(0.0, 0.5, 0.005)]
    assert list(dict.fromkeys(words)) == [
        error_in_words(flip) for flip in (0.0, 0.05, 0.09, 0.15, 0.25, 0.4)
    ]
    assert sum(a != b for a, b in pairwise(words)) == 5
