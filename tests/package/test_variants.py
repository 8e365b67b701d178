"""Variants of a package: other base colours by name, read, chosen and told."""

import numpy as np
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.package import Package
from rna_sdk.package.command.package_info import info_lines, package_info
from rna_sdk.runtime import load
from tests.package.prints import RED_PIXELS, make_print, make_variants, tiers


@pytest.fixture
def path(tmp_path):
    return make_variants(tmp_path / "print.rna")


def test_a_variant_has_other_images_and_factors_on_the_same_triangles(path):
    with Package.open(path) as package:
        assert package.variants() == ("as it is", "deep red")
        plain, same, red = (package.base_color(0, name) for name in (None, "as it is", "deep red"))
    assert [(c.first, c.count, c.label) for c in red] == [
        (0, 2, "label"),
        (2, 1, "stamp"),
        (3, 1, ""),
    ]
    np.testing.assert_array_equal(red[0].image, RED_PIXELS)
    assert (red[0].factor, red[0].wrap) == ((1.0, 0.5, 0.5), ("repeat", "clamp"))
    assert red[0].transform == (1.0, 0.0, 0.0, 0.0, 1.0, 0.0)  # not that of the record before
    np.testing.assert_array_equal(red[1].image, plain[1].image)
    assert red[2].factor == (0.75, 0.125, 0.0)
    for one, other in zip(plain, same, strict=True):
        np.testing.assert_array_equal(one.image, other.image)
        assert (one.factor, one.transform, one.label) == (
            other.factor,
            other.transform,
            other.label,
        )


def test_an_asset_looks_the_variant_up(path):
    asset, third = load(path, variant="deep red"), np.full(1, 1 / 3, np.float32)
    looked_up = asset.base_color_at(np.uint32([3]), third, third)
    np.testing.assert_allclose(looked_up, [[0.75, 0.125, 0.0]])
    label = np.full((2, 2, 3), 255, np.uint8)  # by the label of the package's own image
    other = asset.with_base_color({"label": label}).base_color_at(np.uint32([0]), third, third)
    np.testing.assert_allclose(other, [[1.0, 0.5, 0.5]])


@pytest.mark.parametrize(
    ("exchange", "message"),
    [
        ({"images": "label.png"}, "images: expected a dict of arrays by label, found 'label.png'"),
        ({"images": RED_PIXELS}, "images: expected a dict of arrays by label, found array"),
        ({"images": {"label": "label.png"}}, r"label: expected an \(H, W, 3\) uint8 array"),
        ({"tint": 0.5}, "tint: expected three numbers of at least 0, found 0.5"),
        ({"tint": ("a", "b", "c")}, "tint: expected three numbers of at least 0"),
        ({"tint": (1.0, 1.0, -1.0)}, "tint: expected three numbers of at least 0"),
    ],
)
def test_what_cannot_be_exchanged_is_refused(path, exchange, message):
    with pytest.raises(QueryError, match=message) as caught:
        load(path).with_base_color(**exchange)
    assert "\n" not in str(caught.value)


def test_an_unknown_variant_is_refused_with_the_known_ones(path, tmp_path):
    with pytest.raises(QueryError, match="variant 'blue', expected one of: 'as it is', 'deep red'"):
        load(path, variant="blue")
    with pytest.raises(QueryError, match="expected one of: none: it has no variants"):
        load(make_print(tmp_path / "plain.rna"), variant="blue")
    plain = make_variants(tmp_path / "without.rna", tiers=tiers(None))
    with pytest.raises(QueryError, match="tier 'small' has no base colour"):
        load(plain, variant="deep red")


def test_info_lists_them(path, tmp_path):
    info = package_info(path)
    assert info["variants"] == ["as it is", "deep red"]
    assert "variants    as it is, deep red" in list(info_lines(info))
    plain = info_lines(package_info(make_print(tmp_path / "plain.rna")))
    assert not any(line.startswith("variants") for line in plain)
