"""`rna-bench assets`: errors as the commands of the SDK say them."""

import json

import pytest

from rna_bench.cli import main
from rna_export.export.package_build import build_package
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.training_run import Run, train
from rna_sdk.commands.error_words import error_in_words
from tests.exporters.synthetic import make_dataset, tiny


@pytest.fixture(scope="module")
def part(tmp_path_factory):
    """A dataset; beside it a training, `run`, and its package, `ball.rna`."""
    folder = tmp_path_factory.mktemp("words")
    part = make_dataset(folder / "ball.rays")
    best = train(Run(part, tiny(loss="log"), "small", folder / "run"), say=lambda _: None)
    models = [load_checkpoint(best)]
    build_package(models, part.dataset, folder / "ball.rna", None, "CC0-1.0", lambda _: None)
    return part


def test_the_table_has_what_packages_record_and_the_same_measured_anew(part, tmp_path, capsys):
    package, out = part.folder.parent / "ball.rna", tmp_path / "assets.json"
    assert main(["assets", str(package), "--out", str(out)]) == 0
    (recorded,) = json.loads(out.read_text())["assets"]
    words = error_in_words(recorded["flip"]).partition(":")[0]
    table = capsys.readouterr().out
    assert f"| {recorded['asset']}, `small` | {recorded['flip']:.3f} |" in table
    assert f"| {words} |" in table
    assert main(["assets", str(package), "--datasets", str(part.folder), "--out", str(out)]) == 0
    (measured,) = json.loads(out.read_text())["assets"]
    assert measured["flip"] == pytest.approx(recorded["flip"], abs=2e-4)
    lit = [measured[name]["images"] for name in ("from_front", "from_behind") if name in measured]
    assert sum(lit) == measured["images"] == 2


def test_a_dataset_for_each_package(part, capsys):
    package = str(part.folder.parent / "ball.rna")
    assert main(["assets", package, package, "--datasets", str(part.folder)]) == 1
    assert "found 1 datasets, 2 packages; expected one for each" in capsys.readouterr().err
