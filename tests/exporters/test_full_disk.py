"""A full disk ends a command with one line that names the file, and nothing half-written."""

import errno
import os
from pathlib import Path

import numpy as np
import OpenEXR
import pytest

from rna_export.capture.blender_process import exchanged_files
from rna_export.capture.blender_process.blender_process import BlenderProcess, Source
from rna_export.capture.blender_process.exchanged_files import read_render
from rna_export.pictures import write_picture
from rna_export.training.checkpoint import save_checkpoint
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.training_run import padded_bounds
from rna_sdk.errors import CaptureError
from rna_sdk.package.command.rna_pack import main as pack
from tests.conftest import REPOSITORY
from tests.exporters.synthetic import make_dataset, tiny

FULL = OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def no_space(*_: object) -> None:
    raise FULL


def test_an_image_of_blender_that_is_not_whole(tmp_path, monkeypatch):
    path = tmp_path / "out.exr"
    noise = np.random.default_rng(0).random((64, 64), np.float32)
    channels = {f"ViewLayer.Combined.{c}": noise + k for k, c in enumerate("RGBA")}
    header = {"compression": OpenEXR.NO_COMPRESSION, "type": OpenEXR.scanlineimage}
    with OpenEXR.File(header, channels) as file:
        file.write(str(path))
    assert set(read_render(path)) == {f"Combined.{c}" for c in "RGBA"}
    with pytest.raises(CaptureError, match=r"out\.exr: .* is not whole: it has no Position"):
        read_render(path, "Position")
    path.write_bytes(path.read_bytes()[:9000])
    monkeypatch.setattr(exchanged_files, "_LITTLE", 1 << 62)  # as if no space were left
    with pytest.raises(CaptureError, match=r"out\.exr: .* is not whole: No space left on device"):
        read_render(path)


def test_a_blender_that_ends(tmp_path, monkeypatch):
    monkeypatch.setattr(exchanged_files, "_LITTLE", 1 << 62)
    worker = BlenderProcess(Path("/bin/false"), Source(tmp_path / "a.py"), tmp_path / "w", 1, "w")
    with pytest.raises(CaptureError, match=r"/w: No space left on device$"), worker:
        pass


def test_a_checkpoint_and_a_picture(tmp_path, monkeypatch):
    dataset = make_dataset(tmp_path / "ball.rays")
    model = NeuralAsset(tiny().model, padded_bounds(dataset))
    monkeypatch.setattr(Path, "write_bytes", no_space)
    out = tmp_path / "run"
    out.mkdir()
    with pytest.raises(OSError, match="No space left on device") as caught:
        save_checkpoint(out / "last.ckpt", model, {})
    assert caught.value.filename == str(out / "last.ckpt")
    with pytest.raises(OSError, match="No space left on device") as caught:
        write_picture(out / "view.png", np.zeros((2, 2, 3), np.uint8))
    assert caught.value.filename == str(out / "view.png")
    assert not list(out.iterdir())


def test_a_package(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(os, "fsync", no_space)
    out = tmp_path / "out.rna"
    assert pack([str(REPOSITORY / "examples/quickstart/toy.rna"), "--out", str(out)]) == 1
    assert capsys.readouterr().err == f"error: {out}: No space left on device\n"
    assert not list(tmp_path.iterdir())
