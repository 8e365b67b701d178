"""`transport` is `evaluate` with a visibility, in tiers of one decoder and of two."""

from pathlib import Path

import numpy as np
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.package import TierPart
from rna_sdk.runtime import load
from tests.package.builders import FIBER_INPUTS, INPUTS, make_tier, make_tiny_package

ROWS = 700


def package(folder: Path, apart: bool, kind: str = "surface") -> Path:
    inputs = INPUTS if kind == "surface" else FIBER_INPUTS
    shadowed = {"decoder": "decoders/shadowed.onnx", "inputs": inputs[:3]}
    record = {**shadowed, "decoder_precision": "float32"} if apart else None
    tier = make_tier(inputs=inputs, shadowed=record)
    assert isinstance(tier.parts[0], TierPart)
    return make_tiny_package(folder / "asset.rna", tier, kind=kind)


def arguments(kind: str) -> list[np.ndarray]:
    rng = np.random.default_rng(0)
    rows = [rng.uniform(-1, 1, (ROWS, 3)).astype(np.float32) for _ in range(4)]
    if kind == "fiber":
        rows.insert(2, rng.uniform(-1, 1, ROWS).astype(np.float32))
    return rows


@pytest.mark.parametrize("kind", ["surface", "fiber"])
@pytest.mark.parametrize("apart", [False, True])
@pytest.mark.parametrize("form", ["bool", "share", "colour"])
def test_transport_blends_by_visibility(tmp_path, kind, apart, form):
    asset, rows = load(package(tmp_path, apart, kind)), arguments(kind)
    rng = np.random.default_rng(1)
    v = rng.choice(np.float32([0, 0.25, 1]), (ROWS, 3))
    v = {"bool": v[:, 0] > 0.5, "share": v[:, 0], "colour": v}[form]
    visible, shadowed = asset.evaluate(*rows)
    share = np.float32(v).reshape(ROWS, -1)
    expected = share * visible + (1 - share) * shadowed
    np.testing.assert_allclose(asset.transport(*rows, v), expected, rtol=1e-6, atol=1e-7)
    assert np.abs(visible - shadowed).max() > 0.01


@pytest.mark.parametrize("apart", [False, True])
@pytest.mark.parametrize("columns", [1, 3])
def test_any_visibility_gives_transport(tmp_path, apart, columns):
    """spec/RNA.md, 8.1: values outside [0, 1] are clamped; values that are not finite are 0."""
    asset, rows = load(package(tmp_path, apart, "surface")), arguments("surface")
    odd = np.float32([0.3, -1, 2, -1e30, 1e30, np.nan, np.inf, -np.inf])
    v = np.random.default_rng(2).choice(odd, (ROWS, columns))
    known = np.isfinite(v).all(axis=1)
    share = np.clip(np.where(known[:, None], v, 0), 0, 1)
    visible, shadowed = asset.evaluate(*rows)
    expected = np.where(known[:, None], share * visible + (1 - share) * shadowed, 0)
    actual = asset.transport(*rows, v[:, 0].copy() if columns == 1 else v)
    np.testing.assert_allclose(actual, expected, rtol=1e-6, atol=1e-7)
    assert known.any() and not known.all()


def test_no_visibility_is_refused(tmp_path):
    asset, rows = load(package(tmp_path, True)), arguments("surface")
    for wrong in (None, np.ones(ROWS - 1, bool), np.ones((ROWS, 2), np.float32), np.ones(ROWS)):
        with pytest.raises(QueryError, match="visibility"):
            asset.transport(*rows, wrong)
