"""Where the error of strands is: shares of a known residual are found again."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import torch

from rna_bench.accuracy.crossed_variance import crossed_parts
from rna_bench.accuracy.strand_light import strand_light
from rna_bench.accuracy.strand_points import VIEWS, point_parts, seen_points
from rna_bench.accuracy.strand_views import pixel_errors, view_parts
from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.metrics import IRRADIANCE
from rna_export.training.model.neural_asset import NeuralAsset
from rna_sdk.errors import CaptureError
from tests.exporters.synthetic import tiny
from tests.render.strands import curls

BOUNDS = torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])


def model_of(preset: str = "small") -> NeuralAsset:
    torch.manual_seed(0)
    return NeuralAsset(tiny(preset, "fiber").model, BOUNDS)


def queries(n: int, rng: np.random.Generator) -> dict[str, np.ndarray]:
    vectors = {k: rng.normal(size=(n, 3)).astype(np.float32) for k in ("tangent", "wo", "wi")}
    unit = {k: v / np.linalg.norm(v, axis=1, keepdims=True) for k, v in vectors.items()}
    position = rng.uniform(-1.0, 1.0, (n, 3)).astype(np.float32)
    return {**unit, "position": position, "h": rng.uniform(-1.0, 1.0, n).astype(np.float32)}


def whole_view(size: int, light: np.ndarray, noise: float = 0.0) -> ValidationView:
    """An image that is full of strands; noise: standard deviation of each half."""
    n = size**2
    rng = np.random.default_rng(1)
    samples = {
        **queries(n, rng),
        "radiance": light,
        "direct": np.zeros_like(light),
        "visible": (rng.random(n) < 0.5).astype(np.uint8),
    }
    halves = (light + noise * rng.normal(size=(2, n, 3))).astype(np.float32)
    return ValidationView(0, size, np.arange(n, dtype=np.int32), samples, halves)


def test_parts_of_a_residual_are_found_under_its_noise() -> None:
    rng = np.random.default_rng(0)
    points, views, lights = 4000, 4, 6
    sizes = ((points, 1, 1), (points, views, 1), (points, 1, lights), (points, views, lights))
    spread = (0.5, 1.0, 0.7, 0.3)
    residual = sum(
        (s * rng.normal(size=size) for s, size in zip(spread, sizes, strict=True)),
        np.zeros((points, views, lights)),
    )
    noise = rng.normal(size=(2, points, views, lights))
    found = crossed_parts(residual + noise[0], residual + noise[1])
    assert np.allclose(found, np.square(spread), atol=0.04)
    assert found.total == pytest.approx(np.sum(np.square(spread)), abs=0.05)


def test_errors_of_single_strands_fade_in_larger_pixels_and_errors_of_brightness_stay() -> None:
    rng = np.random.default_rng(0)
    size = 64
    light = np.full((size**2, 3), 0.5 / IRRADIANCE, np.float32)
    view = whole_view(size, light, noise=0.01)
    strands = (light + 0.02 / IRRADIANCE * rng.normal(size=light.shape)).astype(np.float32)
    errors = pixel_errors(view, strands, (1, 2, 4))
    assert errors == pytest.approx([4e-4, 1e-4, 2.5e-5], rel=0.25)
    brighter = pixel_errors(whole_view(size, light), light * np.float32(1.1), (1, 2, 4))
    assert brighter == pytest.approx([0.0025] * 3, rel=1e-4)


def test_an_image_is_divided_by_kind_of_light() -> None:
    model = model_of()
    view = whole_view(8, np.full((64, 3), 0.05, np.float32))
    light = strand_light(model, view.queries, view.visible)
    assert not light.direct[view.visible == 0].any()
    exact = light.direct + light.scattered
    same = ValidationView(
        0, 8, view.pixel, {**view.samples, "radiance": exact}, np.stack([exact, exact])
    )
    parts = view_parts(model, same)
    assert min(parts["psnr"], parts["psnr_lit"], *parts["psnr_of_pixels"]) >= 100.0
    assert parts["psnr_with_direct_of_cycles"] < 60.0  # `same` says there is none


def test_a_model_of_the_paper_has_no_direct_light_of_its_own() -> None:
    rng = np.random.default_rng(0)
    with pytest.raises(CaptureError, match="does not tell direct light from scattered"):
        strand_light(model_of("paper-small"), queries(4, rng), np.ones(4))


def test_all_views_of_a_point_hit_it_and_its_own_light_is_told_apart() -> None:
    scene = AssetScene([curls(60, radius=0.01)])
    seen = seen_points(scene, np.random.default_rng(0), points=40)
    by_point = seen.queries["position"].reshape(-1, VIEWS, 3)
    assert len(by_point) >= 36  # strands may hide a point that is at a joint
    assert np.ptp(by_point, axis=1).max() < 2e-4 * scene.radius

    def radiance_of_place(origins: np.ndarray, directions: np.ndarray, *_: Any) -> Any:
        """Light that depends on the place alone."""
        x = scene.shade_points(origins, directions).position
        value = 1.0 + np.sin(x / np.float32(0.02 * scene.radius))
        return SimpleNamespace(radiance=value, direct=np.zeros_like(value))

    worker = SimpleNamespace(render_rays=radiance_of_place)
    parts = point_parts(model_of(), scene, worker, samples=2, points=40)  # type: ignore[arg-type]
    assert parts["shares"]["point"] > 0.9
