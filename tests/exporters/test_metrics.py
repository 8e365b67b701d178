from __future__ import annotations

import numpy as np
import pytest

from rna_export.metrics import display, flip, psnr, relative_error_p99, relative_mse, to_png


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
