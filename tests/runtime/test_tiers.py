"""Tiers by the error that an asset may have at its size in the image."""

import math

import pytest

from rna_sdk.errors import QueryError
from rna_sdk.package import Package
from rna_sdk.runtime import choose_tier, expected_error, load
from tests.package.builders import make_measured_tier, make_tiny_package

HQ = make_measured_tier("hq", 0.02, 9000, (160, 0.02), (80, 0.019))
SMALL = make_measured_tier("small", 0.04, 900, (160, 0.04), (80, 0.03), (40, 0.02), (20, 0.01))
PLAIN = make_measured_tier("plain", 0.05, 90)
RAW = make_measured_tier("raw", None, 1)


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return make_tiny_package(tmp_path_factory.mktemp("tiers") / "a.rna", HQ, SMALL, PLAIN, RAW)


@pytest.mark.parametrize(
    ("pixels", "error"),
    [
        (None, 0.04),
        (1000, 0.04),
        (160, 0.04),
        (math.sqrt(160 * 80), 0.035),
        (40, 0.02),
        (20, 0.01),
        (5, 0.01),
        (0, 0.01),
        (math.inf, 0.04),
    ],
)
def test_between_recorded_heights_the_error_follows_the_logarithm(pixels, error):
    assert expected_error(SMALL, pixels) == pytest.approx(error)


def test_without_heights_the_error_is_that_of_whole_images():
    assert expected_error(PLAIN, 20) == expected_error(PLAIN) == 0.05
    assert expected_error(RAW, 20) == math.inf


@pytest.mark.parametrize(
    ("max_error", "pixels", "name"),
    [
        (0.02, None, "hq"),
        (0.02, 41, "hq"),
        (0.02, 40, "small"),
        (0.04, 500, "small"),
        (0.01, 20, "small"),
        (0.05, None, "plain"),
    ],
)
def test_a_small_asset_gets_a_cheaper_tier(path, max_error, pixels, name):
    assert load(path, max_error=max_error, pixels=pixels).tier.name == name


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            {"max_error": 0.01, "pixels": 80},
            "no tier within 0.01 at 80 pixels; recorded are: hq 0.019, small 0.03, plain 0.05, raw",
        ),
        ({"max_error": 0.001}, "no tier within 0.001; recorded"),
        ({"max_error": math.nan}, "no tier within nan"),
        ({"max_error": "low"}, "max_error: expected a number of mean FLIP, found 'low'"),
        ({"max_error": 0.1, "pixels": -1}, "pixels: expected 0 or more, found -1"),
        ({"max_error": 0.1, "pixels": math.nan}, "pixels: expected 0 or more, found nan"),
        ({"max_error": 0.1, "pixels": "40"}, "pixels: expected a number"),
        ({"max_error": 0.1, "min_psnr": 30}, "give only one"),
        ({"max_error": 0.1, "name": "hq"}, "give only one"),
    ],
)
def test_what_cannot_be_chosen_is_said(path, arguments, message):
    with Package.open(path) as package, pytest.raises(QueryError, match=message):
        choose_tier(package, **arguments)  # type: ignore[arg-type]
