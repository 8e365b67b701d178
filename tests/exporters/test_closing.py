"""Last lines of rna-train and rna-export: the work beside the usual work, and its meaning."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from safetensors.numpy import load_file, save_file

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.export.export_summary import closing_lines
from rna_export.export.package_build import build_package
from rna_export.pictures import COLUMNS, comparison_sheet, enlarged, sheet_of, worst_of
from rna_export.training.asset_error import asset_error
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.training_run import Run, train
from rna_export.training.training_summary import Effort
from rna_export.training.training_summary import closing_lines as training_lines
from rna_export.training.validation import exposure, mean_psnr, shade
from rna_sdk.commands.error_words import error_in_words, error_text
from tests.exporters.synthetic import make_dataset, tiny
from tests.exporters.two_parts import make, spikes


def trained(part: DatasetPart, folder: Path) -> Path:
    """Checkpoint of a few steps."""
    run = Run(part, tiny(loss="log"), "small", folder, validations=2)
    return train(run, say=lambda _: None)


def darkened(part: DatasetPart, factor: float) -> DatasetPart:
    """The dataset with its radiance, of samples and validation images, times a factor."""
    for path in part.folder.glob("*/*.safetensors"):
        arrays = load_file(path)
        scaled = {k: (factor * v).astype(v.dtype) for k, v in arrays.items() if "radiance" in k}
        save_file({**arrays, **scaled}, path)
    return Dataset(part.folder).only


def test_little_work_is_told_and_warned_of(tmp_path):
    part = make_dataset(tmp_path / "ball.rays")
    best = trained(part, tmp_path / "run")
    score, light, title, *came_true, warning = training_lines(best, part)
    assert score.startswith("small: FLIP 0.") and score.endswith(
        "; 40 of 20,000 steps, 24 of 2,000 lights"
    )
    assert error_in_words(float(score.split()[2].rstrip(","))) in score
    assert light.startswith("small: reflects ") and light.endswith("% at grazing views")
    assert title == "in 2 lit validation images:"
    worst = tmp_path / "run" / "worst.png"
    assert came_true[-1].endswith(f"{worst} shows it beside Cycles") and worst.is_file()
    assert warning.startswith(
        "warning: 40 of 20,000 steps and 24 of 2,000 lights, less than a tenth"
    )
    with Image.open(tmp_path / "run" / "sheet.png") as sheet:
        assert sheet.width == 4 * 6 * 24  # enlarged


def test_the_usual_work_is_no_warning():
    assert Effort(40_000, 40_000, 2_000, 2_000).warnings(0.2) == []
    assert str(Effort(100_000, 40_000, 3_520, 2_000)) == "100,000 steps, 3,520 lights"
    assert Effort(4_000, 40_000, 200, 2_000).warnings(0.2) == []
    (only,) = Effort(40_000, 40_000, 199, 2_000).warnings(None)
    assert "steps" not in only and "199 of 2,000 lights" in only


@pytest.mark.parametrize(("flip", "is_sketch"), [(0.034, False), (0.12, True), (None, True)])
def test_a_good_model_is_not_called_a_sketch(flip, is_sketch):
    (line,) = Effort(4_000, 40_000, 160, 2_000).warnings(flip)
    assert ("a sketch" in line) == is_sketch == line.startswith("warning: ")
    assert line.endswith("enough for this error") != is_sketch


def test_an_export_says_it_again_with_the_notes_of_the_capture(tmp_path):
    part = make_dataset(tmp_path / "ball.rays")
    dataset = part.dataset
    notes = ("texture wood.png: no such file; black",)
    dataset.manifest = dataset.manifest.model_copy(update={"notes": notes})
    models = [load_checkpoint(trained(part, tmp_path / "run"))]
    package = tmp_path / "ball.rna"
    said: list[str] = []
    manifest = build_package(models, dataset, package, None, "CC0-1.0", said.append)
    lines = closing_lines(package, manifest, models, dataset)
    (tier,) = manifest.tiers
    assert tier.validation is not None
    error = error_text(tier.validation.flip, tier.validation.flip_p95)
    assert lines[0].startswith(f"small: {error}, PSNR {tier.validation.psnr:.2f} dB; ")
    assert "40 of 20,000 steps, 24 of 2,000 lights" in lines[0]
    assert lines[-1] == "note: texture wood.png: no such file; black"
    assert sum(line.startswith("warning: 40 of 20,000 steps") for line in lines) == 1
    with Image.open(sheet_of(package)) as sheet:
        assert sheet.width == 4 * 6 * 24  # enlarged
    assert any(line.endswith(f"{worst_of(package)} shows it beside Cycles") for line in lines)
    assert worst_of(package).is_file()


def test_a_cut_of_direct_light_is_a_note(tmp_path):
    manifest = make_dataset(tmp_path / "ball.rays").dataset.manifest
    assert manifest.all_notes == manifest.notes == ()
    settings = manifest.settings.model_copy(update={"clamp_direct": 20.0})
    (note,) = manifest.model_copy(update={"settings": settings}).all_notes
    assert "cut at a radiance of 20" in note and "capture the source again" in note


def test_strands_are_told_in_pixels_of_several_rays(tmp_path):
    dataset = make(tmp_path / "spikes.rays", {"asset": spikes(400, radius=0.05)})
    preset = tiny(kind="fiber")
    best = train(Run(dataset.only, preset, "small", tmp_path / "run"), say=lambda _: None)
    model, views = load_checkpoint(best), dataset.whole_views()
    error = asset_error([shade(model.model, v.parts[0]) for v in views], views)
    assert str(error) in training_lines(best, dataset.only)[0]
    package = tmp_path / "spikes.rna"
    manifest = build_package([model], dataset, package, None, "CC0-1.0", lambda _: None)
    (tier,) = manifest.tiers
    assert tier.validation.flip == pytest.approx(error.mean, abs=2e-3)
    assert "in pixels of 4 x 4 rays" in tier.validation.definition
    assert tier.validation.flip_at_height[0].height == views[0].resolution // 4


def test_a_black_reference_is_a_warning_and_no_record(tmp_path):
    part = darkened(make_dataset(tmp_path / "ball.rays"), 0.0)
    models = [load_checkpoint(trained(part, tmp_path / "run"))]
    package = tmp_path / "ball.rna"
    manifest = build_package(models, part.dataset, package, None, "CC0-1.0", lambda _: None)
    assert manifest.tiers[0].validation is None and manifest.tiers[0].cost is not None
    lines = closing_lines(package, manifest, models, part.dataset)
    assert "no error is recorded" in lines[0]
    assert any(line.startswith("warning: the validation images are black") for line in lines)


def test_a_dark_asset_has_the_scores_of_a_bright_one(tmp_path):
    bright = make_dataset(tmp_path / "ball.rays")
    views = bright.validation_views()
    off = [np.full_like(v.reference, v.reference.mean()) for v in views]
    expected = mean_psnr(off, views)
    dark = darkened(make_dataset(tmp_path / "dark.rays"), 0.01)
    views = dark.validation_views()
    assert exposure(views) > 10.0
    off = [np.full_like(v.reference, v.reference.mean()) for v in views]
    assert abs(mean_psnr(off, views) - expected) < 15.0  # not 40 dB more


@pytest.mark.parametrize(("width", "times"), [(56, 3), (127, 2), (128, 1), (320, 1)])
def test_small_pictures_of_a_sheet_are_enlarged(width, times):
    dot = (200, 0, 0)
    pictures = [np.full((20, width, 3), value, np.uint8) for value in (40, 80, 120, 160)]
    pictures[0][3, 5] = dot
    sheet = np.asarray(comparison_sheet([(pictures, "caption"), (pictures, "caption")]))
    assert sheet.shape[1] == len(COLUMNS) * width * times >= 4 * 128
    assert np.count_nonzero((sheet == dot).all(axis=2)) == 2 * times**2
    for value in (80, 120):
        assert np.count_nonzero((sheet == value).all(axis=2)) >= 2 * 20 * width * times**2
    square = enlarged(pictures[0])[3 * times : 4 * times, 5 * times : 6 * times]
    assert square.shape[:2] == (times, times) and (square == dot).all()
