"""`rna-bench exposure`: the same errors, shown as captured and as in a scene."""

from __future__ import annotations

import numpy as np
import pytest

from rna_bench.accuracy.exposure import scores
from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.metrics import IRRADIANCE


def test_exposure_enlarges_errors() -> None:
    radiance = np.full((16, 3), np.float32(0.1 / IRRADIANCE))
    samples = {"radiance": radiance, "visible": np.repeat(np.uint8([0, 1]), 8)}
    view = ValidationView(0, 4, np.arange(16, dtype=np.int32), samples, np.stack([radiance] * 2))
    found = scores(view, 1.1 * radiance)
    assert found["lit"] == 0.5
    assert found["exposure"] == pytest.approx(8.0, rel=1e-4)
    assert found["psnr"] == pytest.approx(40.0, abs=0.01)
    assert found["psnr_exposed"] == pytest.approx(40.0 - 20.0 * np.log10(8.0), abs=0.01)
