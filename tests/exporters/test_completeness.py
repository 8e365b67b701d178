"""Datasets whose files are not those that their manifest names."""

import json
import shutil
from pathlib import Path

from rna_export.capture.dataset.completeness import differences, forget, record_files
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.training.rna_train import main as rna_train
from tests.exporters.synthetic import make_dataset


def finished(folder: Path) -> Dataset:
    """A dataset of three shards and two views, as a capture leaves it."""
    dataset = make_dataset(folder, shards=3).dataset
    record_files(dataset)
    return Dataset(folder)


def test_a_finished_dataset_is_what_its_manifest_says(tmp_path):
    dataset = finished(tmp_path / "ball.rays")
    assert set(json.loads((dataset.folder / "files.json").read_text())) >= {
        "geometry/asset.safetensors",
        "train/00002.safetensors",
        "validation/01-1.safetensors",
    }
    assert differences(dataset) == []


def test_what_is_missing_replaced_or_not_captured_is_told(tmp_path):
    dataset = finished(tmp_path / "ball.rays")
    dataset.train_path(1).unlink()
    shutil.copy(dataset.train_path(0), dataset.train_path(2))
    geometry = dataset.geometry_path("asset")
    geometry.write_bytes(geometry.read_bytes() + b" ")
    dataset.plan_lights(4 * dataset.manifest.settings.lights_per_shard)
    assert differences(dataset) == [
        "1 of 10 files are not captured yet (train/00003.safetensors)",
        "1 of 10 files are missing (train/00001.safetensors)",
        "2 of 10 files are replaced since the capture "
        "(geometry/asset.safetensors, train/00002.safetensors)",
    ]


def test_what_is_captured_anew_may_differ(tmp_path):
    """As images of `rna-make` do, which grow with the run."""
    dataset = finished(tmp_path / "ball.rays")
    renewed = [dataset.train_path(1), dataset.validation_path(1, 0)]
    forget(dataset, renewed)
    for path in renewed:
        path.write_bytes(path.read_bytes() + b" ")
    record_files(dataset)
    assert differences(dataset) == []


def test_a_capture_that_still_runs_is_not_whole(tmp_path):
    dataset = make_dataset(tmp_path / "ball.rays", shards=3).dataset
    assert differences(dataset) == []
    for half in (0, 1):
        dataset.validation_path(1, half).unlink()
    dataset.train_path(2).unlink()
    assert differences(dataset) == [
        "3 of 8 files are not captured yet (validation/01-0.safetensors, "
        "validation/01-1.safetensors, train/00002.safetensors)"
    ]


def test_training_stops_at_a_gap_unless_it_is_accepted(tmp_path, capfd):
    dataset = finished(tmp_path / "ball.rays")
    dataset.train_path(1).unlink()
    command = [str(dataset.folder), "--out", str(tmp_path / "run"), "--preset", "tiny"]
    command += ["--steps", "2"]
    assert rna_train(command) == 1
    said = capfd.readouterr().err
    assert "1 of 9 files are missing (train/00001.safetensors)" in said
    assert "--incomplete" in said and not (tmp_path / "run").exists()
    assert rna_train([*command, "--incomplete"]) == 0
    assert "warning: " in capfd.readouterr().err
