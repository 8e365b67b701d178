"""The predicted speed of an asset in scenes before its capture: arithmetic and words."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from rna_export.capture import capture_run
from rna_export.capture.blender_process import blender_env
from rna_export.capture.blender_process.exchanged_files import RenderedRays
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.estimate import gain as gain_module
from rna_export.capture.estimate.gain import (
    MeasuredAsset,
    gain,
    gain_text,
    left_out,
    predicted,
)
from rna_export.capture.estimate.pilot import Pilot, measure_pilot, pilot_paths, variances
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rna_capture import main
from rna_sdk.package import Domain
from tests.exporters.meshes import sphere

EVERYWHERE = Domain(wo="sphere", wi="sphere")


def pilot(ratio: float) -> Pilot:
    """One of a noise ratio."""
    return Pilot(
        path_us=12.0,
        path_variance=(ratio - 1.0) * 0.01,
        pixel_variance=0.01,
        ray_us=0.3,
        query_us=0.16,
    )


def asset(ratio: float, *times: float) -> MeasuredAsset:
    return MeasuredAsset(pilot=pilot(ratio), scenes={str(k): t for k, t in enumerate(times)})


HALF = {str(x): asset(x, 0.5 * x * 2, 0.5 * x / 2) for x in (2.0, 5.0, 20.0)}
"""Exactly half of the noise ratio, as the geometric mean of two scenes."""


def test_variances_are_those_of_paths_and_of_pixels():
    rng, n, samples = np.random.default_rng(0), 200_000, 16
    middle = rng.uniform(0.2, 0.4, n)
    first, again = middle + rng.normal(0.0, 0.08 / np.sqrt(samples), (2, n))
    near = middle + rng.normal(0.0, 0.03, n) + rng.normal(0.0, 0.08 / np.sqrt(samples), n)
    shown = np.stack([first, again, near]).astype(np.float32)
    exposure = 0.8 / np.quantile(shown[:2], 0.95)
    path, pixel = variances(shown, samples)
    assert path == pytest.approx((0.08 * exposure) ** 2, rel=0.02)
    # Of a ray through the middle and one beside it, as each differs from the mean of both.
    assert pixel == pytest.approx((0.03 * exposure) ** 2 / 2.0, rel=0.02)
    assert variances(7.0 * shown, samples) == pytest.approx((path, pixel), rel=1e-4)


def test_highlights_that_a_screen_does_not_show_are_no_noise():
    shown = np.full((3, 1000), 0.5, np.float32)
    shown[0, ::50], shown[1, ::50], shown[2, ::50] = 60.0, 90.0, 120.0
    assert variances(shown, 16) == (0.0, 0.0)
    assert variances(np.zeros((3, 10), np.float32), 16) == (0.0, 0.0)


@dataclass
class NoisyCycles:
    """Answers rays with a brightness that depends on the hit, and noise of a known variance."""

    scene: AssetScene
    deviation: float  # of a path
    kind: str = "surface"

    def render_rays(self, origins, directions, wi, samples, seed, reach=None, normals=False):
        points = self.scene.shade_points(origins, directions)
        bright = 0.5 + 0.2 * np.sin(40.0 * points.position[:, :1])
        noise = np.random.default_rng(seed).normal(0.0, self.deviation, (len(origins), 1))
        radiance = np.repeat(bright + noise / np.sqrt(samples), 3, axis=1).astype(np.float32)
        return RenderedRays(radiance, points.hit.astype(np.float32), points.position, None)


def test_a_pilot_finds_the_noise_of_what_renders():
    scene, settings = AssetScene([sphere(4)]), CaptureSettings(rays=1024)

    def measured(deviation: float) -> Pilot:
        cycles = NoisyCycles(scene, deviation)
        return measure_pilot(scene, cycles, settings, EVERYWHERE, False, 12e-6, lambda: None)

    quiet, noisy = measured(0.1), measured(0.2)
    assert quiet.path_us == pytest.approx(12.0)
    assert 0.0 < quiet.query_us < 1e3 and 0.0 < quiet.ray_us < 1e3
    assert noisy.path_variance == pytest.approx(4.0 * quiet.path_variance, rel=0.15)
    assert noisy.pixel_variance == pytest.approx(quiet.pixel_variance, rel=0.15)
    # The sine's slope within a pixel, 1/50 of the radius, and the rim.
    assert 1.0 < quiet.noise_ratio < noisy.noise_ratio


def test_the_paths_of_a_pilot_are_known_before_it():
    scene, settings = AssetScene([sphere(4)]), CaptureSettings(rays=1024)
    traced = []

    class Counting(NoisyCycles):
        def render_rays(self, origins, *more, **how):
            traced.append(len(origins))
            return super().render_rays(origins, *more, **how)

    measure_pilot(scene, Counting(scene, 0.1), settings, EVERYWHERE, False, 12e-6, lambda: None)
    assert sum(traced) * settings.samples == pilot_paths(settings)


def test_a_share_of_the_noise_ratio_is_found_and_left_out_assets_are_told_exactly():
    assets = list(HALF.values())
    assert predicted(pilot(10.0), assets) == pytest.approx(5.0)
    assert left_out(HALF) == pytest.approx(dict.fromkeys(HALF, 1.0))
    actual = gain(pilot(10.0), HALF)
    assert (actual.low, actual.high) == pytest.approx((actual.times, actual.times))
    assert not actual.extrapolated
    assert gain(pilot(30.0), HALF).extrapolated and gain(pilot(1.5), HALF).extrapolated


def test_the_range_is_the_largest_error_of_a_left_out_asset():
    assets = {**HALF, "odd": asset(5.0, 7.5)}
    worst = max(max(off, 1.0 / off) for off in left_out(assets).values())
    actual = gain(pilot(5.0), assets)
    assert worst > 2.0
    assert actual.high / actual.times == pytest.approx(worst)
    assert actual.times / actual.low == pytest.approx(worst)


@pytest.mark.parametrize(
    ("ratio", "words"),
    [
        (10.0, "gain: about 5 times as fast as Cycles in scenes at 16 samples (5 to 5)"),
        (2.0, "gain: none: about 1 times as fast as Cycles in scenes at 16 samples"),
        (40.0, "extrapolated: no measured asset is so noisy"),
    ],
)
def test_two_lines_are_told(ratio, words):
    cost, of_gain = gain_text(pilot(ratio), HALF).split("\n")
    assert cost == (
        f"a path of Cycles takes 12 us, and its variance is {ratio:.2g} times its pixel's "
        "variance; here a query of small takes 0.16 us and its ray 0.3 us (processor time)"
    )
    assert words in of_gain
    assert ("portability" in of_gain) == (ratio == 2.0)


@pytest.fixture
def known(monkeypatch):
    """A source whose pilot needs no Blender."""
    monkeypatch.setattr(blender_env, "find_python", lambda: Path("python"))
    monkeypatch.setattr(capture_run, "measured_pilot", lambda *_, **__: pilot(10.0))


def test_estimate_prints_and_writes_nothing(known, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(gain_module, "table_of", lambda: HALF)
    (tmp_path / "ball.py").write_text("pass")
    assert main(["ball.py", "--estimate"]) == 0
    lines = "opening ball.py in Blender", gain_text(pilot(10.0), HALF)
    assert capsys.readouterr().out == "\n".join([*lines, ""])
    assert [path.name for path in tmp_path.iterdir()] == ["ball.py"]
