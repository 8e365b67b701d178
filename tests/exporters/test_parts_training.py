"""A ball with strands, from a dataset of two parts to a package of two parts."""

from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.export.rna_export import main as export
from rna_export.metrics import psnr
from rna_export.training import training_run as run_module
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.optimization.samples import SampleTable
from rna_export.training.part_runs import shared_minutes
from rna_export.training.report import Curves
from rna_export.training.rna_train import main as train
from rna_sdk.package import Package
from rna_sdk.runtime import load
from tests.exporters.synthetic import tiny
from tests.exporters.two_parts import hairy_ball


@pytest.fixture(scope="module")
def dataset(tmp_path_factory):
    return hairy_ball(tmp_path_factory.mktemp("two") / "two.rays")


@pytest.fixture(autouse=True)
def tiny_presets(monkeypatch):
    presets = {kind: {"small": tiny(kind=kind)} for kind in ("surface", "fiber")}
    monkeypatch.setattr("rna_export.training.rna_train.PRESETS", presets)
    monkeypatch.setattr(Curves, "draw", lambda _: None)


def arguments(dataset: Dataset, out: Path, *more: str) -> list[str]:
    return [str(dataset.folder), "--out", str(out), "--device", "cpu", "--steps", "20", *more]


def test_all_parts_are_trained_and_exported(dataset, tmp_path, capsys):
    out, package = tmp_path / "runs", tmp_path / "two.glb"  # with a fallback
    assert train(arguments(dataset, out)) == 0
    said = capsys.readouterr().out
    assert f"next: rna-export {out} --out two.rna" in said
    assert export([str(out), "--out", str(package)]) == 0
    said = capsys.readouterr().out
    asset = load(package)
    with Package.open(package) as opened:
        manifest = opened.manifest
        assert opened.carrier is not None
        facts = opened.carrier.facts()
        assert facts["fallback_meshes"] == 2 and 0.0 < facts["fallback_flip"] < 1.0
        assert f"fallback: FLIP {facts['fallback_flip']:.4f}" in said
        planes = [entry for entry in manifest.entries if entry.startswith("features/")]
    assert [(p.name, p.kind) for p in manifest.parts] == [("surface", "surface"), ("hair", "fiber")]
    assert sorted(planes) == [f"features/{p}/small.safetensors" for p in ("hair", "surface")]
    tier = manifest.tiers[0]
    whole = [
        psnr(
            np.concatenate(
                [
                    p.shaded_by(part_asset)
                    for p, part_asset in zip(v.parts, asset.parts, strict=True)
                ]
            ),
            v.reference,
        )
        for v in dataset.whole_views()
    ]
    assert tier.validation.psnr == pytest.approx(np.mean(whole), abs=0.01)
    adds = [
        load_checkpoint(out / part.name / "best.ckpt").model.multiply_adds for part in dataset.parts
    ]
    assert min(adds) < tier.cost.multiply_adds < max(adds)


def test_a_part_alone_is_the_part_among_the_others(dataset, tmp_path):
    """So it cannot be worse than a model of that part alone."""
    assert train(arguments(dataset, tmp_path / "all")) == 0
    assert train(arguments(dataset, tmp_path / "one", "--part", "hair")) == 0
    assert not (tmp_path / "one" / "surface").exists()
    both = (load_checkpoint(tmp_path / f / "hair" / "best.ckpt").model for f in ("all", "one"))
    ours, alone = (model.state_dict() for model in both)
    assert all(np.array_equal(ours[name], alone[name]) for name in ours)


def test_a_stopped_run_goes_on_with_the_part_that_it_was_at(dataset, tmp_path, monkeypatch):
    trained = []
    real = run_module.train

    def stopping(run: run_module.Run, table: SampleTable) -> Path:
        if run.dataset.name == "hair" and not trained:
            trained.append("stopped")
            raise KeyboardInterrupt
        return real(run, table)

    monkeypatch.setattr(run_module, "train", stopping)
    assert train(arguments(dataset, tmp_path)) == 130
    surface = (tmp_path / "surface" / "best.ckpt").read_bytes()
    assert train(arguments(dataset, tmp_path)) == 0
    assert (tmp_path / "surface" / "best.ckpt").read_bytes() == surface
    assert (tmp_path / "hair" / "best.ckpt").is_file()


@pytest.mark.parametrize(
    ("more", "message"),
    [
        (("--part", "beard"), "found no part 'beard', expected one of surface, hair"),
        (("--cut", "16"), "a cut in 16 gives 17 parts"),
    ],
)
def test_impossible_parts_are_named(more, message, dataset, tmp_path, capsys):
    assert train(arguments(dataset, tmp_path, *more)) == 1
    assert message in capsys.readouterr().err


def test_minutes_are_shared(dataset):
    shares = shared_minutes(10.0, dataset.parts)
    pixels = [sum(len(v.pixel) for v in part.validation_views()) for part in dataset.parts]
    assert sum(shares.values()) == pytest.approx(10.0, abs=0.01)
    assert shares["surface"] == pytest.approx(2.5 + 5.0 * pixels[0] / sum(pixels), abs=0.01)
    assert shared_minutes(None, dataset.parts) == {"surface": None, "hair": None}
    assert shared_minutes(3.0, dataset.parts[:1]) == {"surface": 3.0}
