import os
import re
import struct
import zipfile
from pathlib import Path

import pytest
import torch

from rna_export.training.checkpoint import load_checkpoint, load_progress
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.presets import ModelConfig
from rna_export.training.report import Curves
from rna_export.training.training_run import Run, train
from rna_sdk.errors import ExportError, TrainingError
from tests.exporters.synthetic import tiny


@pytest.fixture(scope="module")
def checkpoint(dataset, tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Curves, "draw", lambda _: None)
        return train(Run(dataset, tiny(steps=10), "small", tmp_path_factory.mktemp("run"), seed=3))


def test_says_all_that_is_needed_to_repeat_it(checkpoint, dataset):
    trained = load_checkpoint(checkpoint)
    rows = len(dataset.training_samples()["wo"])
    assert trained.preset == tiny(steps=10, loss="log").for_rows(rows)  # a capture without noise
    assert (trained.preset_name, trained.seed, trained.steps) == ("small", 3, 10)
    assert trained.capture == dataset.manifest
    assert trained.dataset == dataset.folder.resolve()


class Exploit:
    """Pickled, it makes a folder when it is read."""

    def __init__(self, folder: Path):
        self.folder = folder

    def __reduce__(self):
        return os.mkdir, (str(self.folder),)


def test_a_checkpoint_runs_no_code(checkpoint, tmp_path):
    saved = torch.load(checkpoint, weights_only=True)
    saved["record"]["exploit"] = Exploit(tmp_path / "made")
    torch.save(saved, tmp_path / "bad.ckpt")
    with pytest.raises(ExportError, match=r"bad\.ckpt: not a checkpoint"):
        load_checkpoint(tmp_path / "bad.ckpt")
    assert not (tmp_path / "made").exists()


@pytest.fixture(params=["export", "continue"])
def refuses(request):
    """That the reader of rna-export, or of a run that goes on, refuses a file in one line."""
    load, error = {
        "export": (load_checkpoint, ExportError),
        "continue": (load_progress, TrainingError),
    }[request.param]

    def check(path: Path) -> None:
        with pytest.raises(error, match=re.escape(str(path))) as caught:
            load(path)
        assert len(str(caught.value).splitlines()) == 1

    return check


@pytest.mark.parametrize(
    "damage",
    [
        lambda s: s.pop("record"),
        lambda s: s["record"].pop("seed"),
        lambda s: s["record"].update(seed="three"),
        lambda s: s["record"]["preset"]["model"].update(width=17),
        lambda s: s["record"]["preset"]["model"].update(inputs=["magic"]),
        lambda s: s["model"].pop("decoder.0.weight"),
        lambda s: s["model"].update({3: torch.zeros(1)}),
        lambda s: s.update(model=[1]),
        lambda s: s["record"]["capture"].update(surprise=1),
    ],
    ids=[
        *("no record", "no seed", "no number", "another width", "unknown input"),
        *("a weight less", "a weight without a name", "no weights", "manifest"),
    ],
)
def test_a_damaged_checkpoint_is_refused(
    checkpoint,
    tmp_path,
    damage,
    refuses,
):
    saved = torch.load(checkpoint, weights_only=True)
    damage(saved)
    torch.save(saved, tmp_path / "bad.ckpt")
    refuses(tmp_path / "bad.ckpt")


@pytest.mark.parametrize("content", [b"", b"not a checkpoint", b"PK\x03\x04 half a zip"])
def test_another_file_is_refused(tmp_path, content, refuses):
    (tmp_path / "x.ckpt").write_bytes(content)
    refuses(tmp_path / "x.ckpt")


@pytest.mark.parametrize("share", [0.1, 0.5, 0.99])
def test_a_checkpoint_cut_short_is_refused(checkpoint, tmp_path, share, refuses):
    data = checkpoint.read_bytes()
    (tmp_path / "cut.ckpt").write_bytes(data[: int(share * len(data))])
    refuses(tmp_path / "cut.ckpt")


def test_a_model_alone_cannot_be_trained_on(checkpoint, tmp_path):
    saved = torch.load(checkpoint, weights_only=True)
    torch.save(saved, tmp_path / "last.ckpt")
    with pytest.raises(TrainingError, match="progress"):
        load_progress(tmp_path / "last.ckpt")


def test_a_run_tells_of_a_damaged_checkpoint_of_its_own(dataset, tmp_path):
    (tmp_path / "last.ckpt").write_bytes(b"damaged")
    with pytest.raises(TrainingError, match=r"last\.ckpt.*delete it"):
        train(Run(dataset, tiny(steps=10), "small", tmp_path))


def test_no_file_is_refused(tmp_path):
    with pytest.raises(ExportError, match="no such file"):
        load_checkpoint(tmp_path / "gone.ckpt")


@pytest.mark.parametrize(
    "change",
    [
        {"resolution": 4000},
        {"hidden_layers": 10**9},
        {"hidden_layers": 60, "width": 8192},
        {"channels": 4096},
    ],
)
def test_a_small_file_asks_for_no_large_model(
    change,
    checkpoint,
    tmp_path,
    refuses,
    monkeypatch,
):
    """It is refused before a model takes memory."""
    made, init = [], NeuralAsset.__init__

    def watched(model: NeuralAsset, config: ModelConfig, bounds: torch.Tensor) -> None:
        made.append(bounds.device.type)
        init(model, config, bounds)

    monkeypatch.setattr(NeuralAsset, "__init__", watched)
    saved = torch.load(checkpoint, weights_only=True)
    saved["record"]["preset"]["model"].update(change)
    torch.save(saved, tmp_path / "large.ckpt")
    refuses(tmp_path / "large.ckpt")
    assert "cpu" not in made


def test_weights_that_repeat_one_number_are_refused(checkpoint, tmp_path, refuses):
    saved = torch.load(checkpoint, weights_only=True)
    saved["record"]["preset"]["model"]["resolution"] = 4000
    shape = saved["model"]["triplane.planes"].shape
    saved["model"]["triplane.planes"] = torch.zeros(1).expand(3, 4000, 4000, shape[-1])
    torch.save(saved, tmp_path / "repeats.ckpt")
    refuses(tmp_path / "repeats.ckpt")


def test_compressed_records_are_refused(checkpoint, tmp_path, refuses):
    packed = tmp_path / "packed.ckpt"
    with (
        zipfile.ZipFile(checkpoint) as plain,
        zipfile.ZipFile(packed, "w", compression=zipfile.ZIP_DEFLATED) as archive,
    ):
        for name in plain.namelist():
            archive.writestr(name, plain.read(name))
    refuses(packed)


def test_torch_reads_the_records_that_were_checked(checkpoint, tmp_path, refuses):
    """Two directories: torch finds that of the compressed records, Python that which denies it."""
    with zipfile.ZipFile(checkpoint) as plain:
        names = plain.namelist()
        with zipfile.ZipFile(tmp_path / "two.ckpt", "w", zipfile.ZIP_DEFLATED) as archive:
            for name in names:
                grown = b"\0" * (64 << 20) if name.endswith("/data/0") else b""
                archive.writestr(name, plain.read(name) + grown)
    data = (tmp_path / "two.ckpt").read_bytes()
    end = data.rindex(b"PK\5\6")
    size, start = struct.unpack("<II", data[end + 12 : end + 20])
    denying, entry = bytearray(data[start : start + size]), 0
    while entry < size:
        denying[entry + 10 : entry + 12] = b"\0\0"  # "stored"
        entry += 46 + sum(struct.unpack("<HHH", denying[entry + 28 : entry + 34]))
    (tmp_path / "two.ckpt").write_bytes(data[:end] + denying + data[end:])
    with zipfile.ZipFile(tmp_path / "two.ckpt") as seen:
        assert {record.compress_type for record in seen.infolist()} == {zipfile.ZIP_STORED}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(torch, "load", lambda *_, **__: pytest.fail("torch was asked"))
        refuses(tmp_path / "two.ckpt")
