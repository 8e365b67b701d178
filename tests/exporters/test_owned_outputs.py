"""Commands delete and replace nothing of the user's, and one of them writes a folder at a time."""

import hashlib
import json
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from safetensors.numpy import load_file, save_file

from rna_export.capture import capture_run as capture_run
from rna_export.capture.blender_process import blender_env
from rna_export.capture.capture_settings import MAX_LIGHTS
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.rna_capture import main as capture
from rna_export.compare.rna_compare import main as compare
from rna_export.export.rna_export import main as export
from rna_export.make.rna_make import main as make
from rna_export.training import report
from rna_export.training import training_run as training_run
from rna_export.training.rna_train import main as train
from rna_sdk.errors import TrainingError
from rna_sdk.files.owned_folder import owned
from rna_sdk.package.command.rna_pack import main as pack
from rna_view.rna_view_command import main as view
from tests.conftest import REPOSITORY
from tests.exporters.synthetic import make_dataset

TOY = (REPOSITORY / "examples" / "quickstart" / "toy.rna").read_bytes()
USERS = ("notes.txt", "scratch/mine.exr", "rays/mine", "train/work.part", "s.obj", "t.rna")
"""Files of a user's folder, some under names that commands use."""


@pytest.fixture
def home(tmp_path, monkeypatch, dataset):
    """A folder of the user, which is the working directory; returns its contents."""
    home = tmp_path / "home"
    for name in USERS:
        (home / name).parent.mkdir(parents=True, exist_ok=True)
        (home / name).write_bytes(TOY if name.endswith(".rna") else name.encode())
    monkeypatch.chdir(home)
    monkeypatch.setattr(blender_env, "find_python", lambda: Path("python"))
    return lambda: {
        path.relative_to(home).as_posix(): path.read_bytes()
        for path in sorted(home.rglob("*"))
        if path.is_file()
    }


@pytest.fixture(scope="module")
def dataset(tmp_path_factory):
    return make_dataset(tmp_path_factory.mktemp("data") / "ball.rays").dataset


FOREIGN = [
    (make, "s.obj --out new.rna --work ."),
    (make, "s.obj --out train.rna --work train"),
    (capture, "s.obj --out ."),
    (capture, "s.obj --out scratch"),
    (train, "DATASET --out ."),
    (compare, "t.rna s.obj --out ."),
    (view, "t.rna --export ."),
]


def arguments(text: str, dataset: Dataset) -> list[str]:
    return text.replace("DATASET", str(dataset.folder)).split()


@pytest.mark.parametrize(("command", "text"), FOREIGN, ids=[text for _, text in FOREIGN])
def test_a_folder_of_the_user_is_refused(
    command,
    text,
    dataset,
    home,
    capsys,
):
    before = home()
    assert command(arguments(text, dataset)) == 1
    error = capsys.readouterr().err
    assert error.startswith("error: ") and error.count("\n") == 1
    assert "expected a new or empty" in error or "work folder" in error
    assert home() == before


REPLACES = [
    (make, "s.obj --out s.obj"),
    (make, "s.obj --out ./rays/../s.obj"),
    (make, "s.obj --out new.rna --work scratch"),
    (make, "s.obj --out new.make"),
    (capture, "s.obj --out s.obj"),
    (train, "DATASET --out DATASET"),
    (export, "best.ckpt --out best.ckpt"),
    (export, "best.ckpt --poster p.png --out p.png"),
    (compare, "t.rna s.obj --out t.rna"),
    (pack, "t.rna --out t.rna"),
    (pack, "t.rna --poster p.png --out p.png"),
    (view, "t.rna --export t.rna"),
]


@pytest.mark.parametrize(("command", "text"), REPLACES, ids=[text for _, text in REPLACES])
def test_no_command_replaces_what_it_reads(
    command,
    text,
    dataset,
    home,
    capsys,
):
    Path("best.ckpt").touch()
    Path("p.png").write_bytes(b"\x89PNG\r\n\x1a\n")
    before, manifest = home(), (dataset.folder / "manifest.json").read_bytes()
    assert command(arguments(text, dataset)) == 1
    error = capsys.readouterr().err
    assert error.startswith("error: ") and error.count("\n") == 1
    assert home() == before
    assert (dataset.folder / "manifest.json").read_bytes() == manifest


@pytest.mark.parametrize(
    ("command", "name", "text", "folder"),
    [
        (capture, "rna-capture", "s.obj --out s.rays", "s.rays"),
        (make, "rna-make", "s.obj --out s.rna", "s.make"),
        (train, "rna-train", "DATASET --out runs/s", "runs/s"),
        (compare, "rna-compare", "t.rna s.obj --out c", "c"),
    ],
)
def test_one_command_writes_a_folder_at_a_time(
    command,
    name,
    text,
    folder,
    dataset,
    home,
    capsys,
):
    with owned(Path(folder), name):
        before = home()
        assert command(arguments(text, dataset)) == 1
        error = capsys.readouterr().err
        assert f"{folder}: in use by " in error and error.count("\n") == 1
        assert home() == before


def test_leftovers_are_deleted_by_name(dataset, home, monkeypatch):
    """A dataset is resumed; files of the user stay."""
    Path("s.obj").write_bytes(b"the source")
    out = Path("s.rays")
    make_dataset(out)
    (out / ".rna-capture").touch()
    manifest = json.loads((out / "manifest.json").read_text())
    manifest["sourceSha256"] = hashlib.sha256(b"the source").hexdigest()
    (out / "manifest.json").write_text(json.dumps(manifest))
    for name in ("scratch/mine", "train/notes.part", "train/.00009.safetensors.0123456789ab.part"):
        (out / name).parent.mkdir(exist_ok=True)
        (out / name).touch()
    monkeypatch.setattr(capture_run, "all_tasks", lambda dataset: [])
    assert capture(["s.obj", "--out", "s.rays"]) == 0
    assert {"s.rays/scratch/mine", "s.rays/train/notes.part"} <= set(home())
    assert not list(out.glob("train/.*")) and (out / ".rna-capture").read_bytes() == b""


def poison(path: Path) -> None:
    arrays = load_file(path)
    arrays["asset/radiance"][:7] = np.nan
    save_file(arrays, path)


def test_rows_that_are_no_numbers_are_refused(tmp_path, capsys):
    dataset = make_dataset(tmp_path / "ball.rays").dataset
    path = dataset.train_path(0)
    poison(path)
    assert train([str(dataset.folder), "--out", str(tmp_path / "run")]) == 1
    error = capsys.readouterr().err
    what = "7 rows of asset/radiance are not finite numbers up to 1e+18"
    message = f"damaged ({what}); delete it, and the same"
    assert error.startswith(f"error: {path}: {message}") and error.count("\n") == 1
    assert not (tmp_path / "run").exists()


def test_a_model_that_diverges_is_an_error(dataset, tmp_path, monkeypatch):
    nothing = np.full((9, 3), np.nan, np.float32)
    monkeypatch.setattr(report, "shade", lambda model, view: nothing[:1].repeat(len(view.pixel), 0))
    with pytest.raises(TrainingError, match="run: the model diverged, the PSNR of its validation"):
        report.Report(dataset.only, tmp_path / "run").of(SimpleNamespace(), is_last=True)
    assert not (tmp_path / "run").exists()


def test_a_manifest_with_a_huge_number_of_lights_is_refused(tmp_path, capsys):
    folder = make_dataset(tmp_path / "ball.rays").folder
    manifest = json.loads((folder / "manifest.json").read_text())
    manifest["settings"]["lights"] = 10**15
    (folder / "manifest.json").write_text(json.dumps(manifest))
    assert train([str(folder), "--out", str(tmp_path / "run")]) == 1
    error = capsys.readouterr().err
    assert "manifest.json: settings.lights: " in error and str(MAX_LIGHTS) in error
