"""`rna-bench scenes`: its figures on known answers, and one tiny run beside Cycles."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from safetensors.numpy import load_file

from rna_bench.checkout import ROOT, TOY
from rna_bench.cli import main
from rna_bench.scenes import scenes_study
from rna_bench.scenes.beside_cycles import Beside, OurScene
from rna_bench.scenes.equal_error import equal_error
from rna_bench.scenes.filled import filled
from rna_bench.scenes.scene_list import NEAR_AND_FAR, find_environment, scenes
from rna_bench.scenes.stage import Stage
from rna_bench.scenes.stored import StoredResults
from rna_bench.scenes.time_to_flip import Wait, sooner, wait_for
from rna_render.scene.transforms import world_from_object
from rna_sdk.errors import RnaError, SceneError
from rna_sdk.runtime import load

SOURCE = TOY.with_suffix(".py")


@pytest.fixture(scope="module")
def stage():
    asset = load(TOY, threads=1)
    return Stage.of(asset, TOY, None, turn_deg=0.0, resolution=(48, 32))


def test_the_wait_for_a_flip_lies_between_samples():
    curve = [{"seconds": t, "flip": f} for t, f in ((1.0, 0.08), (4.0, 0.04), (16.0, 0.02))]
    assert wait_for(0.04 * 2**0.5, curve).seconds == pytest.approx(2.0)
    assert str(wait_for(0.1, curve)) == "at most 1.00 s"
    assert wait_for(0.01, curve, floor=0.015) == Wait(None, False, 0.015)
    assert str(wait_for(0.01, curve)) == "not reached, 0.020"


def test_the_sooner_of_raw_and_denoised_counts():
    raw, denoised = Wait(3.0, False, 0.02), Wait(2.0, True, 0.04)
    assert sooner([raw, denoised]) == denoised
    assert sooner([raw, Wait(None, False, 0.06)]) == raw
    assert sooner([Wait(None, False, 0.06), Wait(None, False, 0.05)]).best == 0.05


def test_waits_of_results_are_told_and_drawn(tmp_path, capsys):
    result, chart = ROOT / "benchmarks/results/scenes-curls.json", tmp_path / "chart.svg"
    assert main(["time-to-flip", str(result), "--targets", "0.15", "0.1", "--out", str(chart)]) == 0
    output = capsys.readouterr().out
    assert "| curly ball, forest | not reached, 0.133 | 14.53 s | not reached, 0.133 |" in output
    assert "until FLIP 0.1, raw or denoised" in chart.read_text()
    assert main(["time-to-flip", str(SOURCE)]) == 1
    assert "found no result of `rna-bench scenes`, expected one" in capsys.readouterr().err


def test_equal_error_is_exact_where_error_and_time_are_as_assumed():
    cycles = [
        {"samples": n, "seconds": 1.0 + 0.5 * n, "psnr": -10 * np.log10(0.08 / n)}
        for n in (4, 8, 16)
    ]
    actual = equal_error({"psnr": -10 * np.log10(0.08 / 10), "seconds": 0.5}, cycles)
    assert actual["cycles_samples"] == pytest.approx(10.0)
    assert actual["cycles_seconds"] == pytest.approx(6.0)
    assert actual["times_as_fast"] == pytest.approx(12.0) and not actual["extrapolated"]
    far = equal_error({"psnr": 40.0, "seconds": 0.5}, cycles)
    assert far["extrapolated"]


def test_brightness_is_that_of_the_asset_in_each_channel():
    asset = np.zeros((4, 6), bool)
    asset[1:3, 2:5] = True
    halves = np.stack([np.full((4, 6, 3), 0.5), np.full((4, 6, 3), 1.5)])
    image = np.where(asset[..., None], [0.9, 1.0, 1.2], 7.0)
    assert Beside.of(halves, asset).brightness(image) == pytest.approx([0.9, 1.0, 1.2])


def test_instances_near_and_far_stand_apart(stage, tmp_path):
    scene = scenes(stage, [], tmp_path)[NEAR_AND_FAR]
    centre = np.array([*stage.centre, 1.0])
    middles = np.array([(world_from_object(a.transform) @ centre)[:3] for a in scene.assets])
    np.testing.assert_allclose(middles[0], stage.centre, atol=1e-6)
    apart = np.linalg.norm(middles[:, None] - middles, axis=-1)
    assert apart[np.triu_indices(len(middles), 1)].min() > 2.0 * stage.radius
    distance = np.linalg.norm(middles - scene.camera.position, axis=1)
    assert distance.max() > 5.0 * distance.min()


def test_the_asset_fills_the_share_of_the_picture_that_is_asked_for(stage):
    fitted = filled(replace(stage, resolution=(160, 90)), 1 / 3)
    near, far = (OurScene(s.scene()).channels(4)["A"].mean() for s in (fitted, stage))
    assert near == pytest.approx(1 / 3, rel=0.03) and far < 0.2
    with pytest.raises(SceneError, match="--share: expected a number between 0 and 1, found 1"):
        filled(stage, 1.0)


def test_flip_is_of_the_asset_and_not_of_what_is_around_it():
    asset = np.zeros((128, 192), bool)
    asset[32:96, 48:144] = True
    reference = np.full((128, 192, 3), 0.4, np.float32)
    beside = Beside.of(np.stack([reference] * 2), asset)
    background = np.where(asset[..., None], reference, 0.1).astype(np.float32)
    inside = np.where(asset[..., None], 0.1, reference).astype(np.float32)
    assert beside.flip(background).mean < 0.1 < 0.4 < beside.flip(inside).mean


def test_what_is_kept_was_made_with_the_same_settings(tmp_path):
    made: list[int] = []

    def make() -> dict[str, int]:
        made.append(1)
        return {"n": len(made)}

    def stored(samples: int, again: bool = False) -> StoredResults:
        return StoredResults(tmp_path / "a", {"samples": samples}, again, "choose another --out")

    assert stored(4).record("x", make) == stored(4).record("x", make) == {"n": 1}
    with pytest.raises(RnaError, match=r"samples 4, now 8\): choose another --out"):
        stored(8)
    assert stored(8, again=True).record("x", make) == {"n": 2}
    assert stored(8).record("x", make) == {"n": 2}


def run(out: Path, *more: str) -> int:
    command = ["scenes", str(TOY), "--source", str(SOURCE), "--out", str(out), "--environment"]
    command += ["--scenes", "lamp", "--resolution", "48", "32", "--samples", "2", "4"]
    command += ["--cycles-samples", "2", "4", "--reference-samples", "8", "--floor-samples", "8"]
    return main([*command, *more])


def roughness(image: np.ndarray) -> float:
    return float(np.abs(np.diff(image, axis=1)).mean() / image.mean())


@pytest.mark.blender
def test_a_tiny_run(tmp_path, monkeypatch, capsys):
    assert run(tmp_path, "--references-only", "--floor-samples", "9") == 0
    assert [path.name for path in (tmp_path / "references").glob("*.safetensors")] == [
        "lamp.safetensors"
    ]
    assert not (tmp_path / "scenes.json").exists()
    assert run(tmp_path) == 0
    report = json.loads((tmp_path / "scenes.json").read_text())
    lamp = report["scenes"]["lamp"]
    assert report["stamp"]["command"].startswith("rna-bench scenes examples/quickstart/toy.rna")
    assert [row["samples"] for row in lamp["ours"]] == [2, 4]
    assert [row["samples"] for row in lamp["cycles_denoised"]] == [2, 4]
    assert all(row["seconds"] > 0.0 and row["psnr"] > 10.0 for row in lamp["cycles"] + lamp["ours"])
    images = load_file(tmp_path / "measured" / "lamp-images.safetensors")
    assert roughness(images["cycles-2-denoised"]) < 0.8 * roughness(images["cycles-2"])
    assert (tmp_path / "scenes.png").stat().st_size > 10_000

    # A second run renders nothing: what is measured is kept, for these settings alone.
    before = (tmp_path / "scenes.json").read_text().partition('"scenes": {')[2]
    monkeypatch.setattr(scenes_study, "cycles", None)
    monkeypatch.setattr(OurScene, "render", None)
    assert run(tmp_path) == 0
    assert (tmp_path / "scenes.json").read_text().partition('"scenes": {')[2] == before
    capsys.readouterr()
    assert run(tmp_path, "--floor-samples", "9") == 1
    assert "floor_samples 8, now 9): choose another --out, or --again" in capsys.readouterr().err


def test_bad_input_is_one_line(tmp_path, capsys):
    assert run(tmp_path, "--scenes", "moon") == 1
    assert capsys.readouterr().err == (
        "error: --scenes: found moon; expected of lamp, wall, near-and-far\n"
    )
    assert run(tmp_path, "--source", "no.py") == 1
    assert capsys.readouterr().err == "error: no.py: no such file\n"


@pytest.mark.blender
def test_an_unknown_environment_is_one_line():
    with pytest.raises(SceneError, match="found moon; expected a file or one of city, courtyard"):
        find_environment("moon")
