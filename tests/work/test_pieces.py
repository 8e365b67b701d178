"""Pieces of an image are kept over a stop."""

import os
import signal
from contextlib import nullcontext
from math import prod
from pathlib import Path

import pytest

from rna_render.command.finished_pieces import FinishedPieces, Piece, missing_pieces
from rna_render.command.pieces import PieceWorker, render_pieces
from rna_render.command.rna_run import main as render
from rna_render.image.film import Film
from rna_render.image.output import Output
from rna_render.scene.scene_file import SceneFile, read_scene
from rna_sdk.commands.console import INTERRUPTED
from rna_sdk.errors import SceneError
from rna_work.executors import this_machine
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package
from tests.render.test_sequence import SCENE

STOPPED = 2  # pieces that are finished before


@pytest.fixture
def scene_file(tmp_path):
    write_lambert_package(tmp_path / "ball.rna", sphere(4))
    (tmp_path / "scene.yaml").write_text(SCENE.replace("[12, 8]", "[400, 200]"))
    return read_scene(tmp_path / "scene.yaml")


@pytest.fixture
def rendered(monkeypatch):
    """The pieces that workers render; the one after the first `STOPPED` fails once."""
    pieces: list[Piece] = []
    original = PieceWorker.run

    def run(self: PieceWorker, piece: Piece) -> object:
        pieces.append(piece)
        if len(pieces) == STOPPED + 1:
            raise SceneError("stopped")
        return original(self, piece)

    monkeypatch.setattr(PieceWorker, "run", run)
    return pieces


def stop(scene_file: SceneFile, folder: Path) -> None:
    with pytest.raises(SceneError, match="stopped"):
        render_pieces(scene_file, this_machine(), 1, folder)


def test_finished_pieces_are_not_rendered_again(scene_file, rendered, tmp_path):
    folder, whole, pieces = tmp_path / "kept", tmp_path / "a.exr", tmp_path / "b.exr"
    stop(scene_file, folder)
    film, finished = render_pieces(scene_file, this_machine(), 1, folder)
    count = len(rendered) - 1
    assert len(set(rendered)) == count > STOPPED + 1  # one of them twice, which had failed
    Output(pieces).write(scene_file.scene, film)
    assert render([str(scene_file.path), "--out", str(whole)]) == 0
    assert whole.read_bytes() == pieces.read_bytes()
    finished.remove()
    assert not folder.exists()


def test_pieces_of_another_image_are_rendered_again(scene_file, rendered, tmp_path):
    folder = tmp_path / "kept"
    stop(scene_file, folder)
    write_lambert_package(tmp_path / "ball.rna", sphere(3))
    render_pieces(scene_file, this_machine(), 1, folder)
    assert rendered[:STOPPED] == rendered[STOPPED + 1 : 2 * STOPPED + 1]


def test_damaged_pieces_are_rendered_again(scene_file, rendered, tmp_path):
    folder = tmp_path / "kept"
    stop(scene_file, folder)
    first = min(folder.iterdir())
    first.write_bytes(first.read_bytes()[:-1000])
    render_pieces(scene_file, this_machine(), 1, folder)
    assert rendered.count(rendered[0]) == 2 and rendered.count(rendered[1]) == 1


def test_ctrl_c_says_how_much_of_the_image_is_kept(
    scene_file,
    monkeypatch,
    tmp_path,
    capsys,
):
    keep = FinishedPieces.keep

    def keep_and_press(self: FinishedPieces, piece: Piece, film: Film) -> None:
        keep(self, piece, film)
        os.kill(os.getpid(), signal.SIGINT)

    monkeypatch.setattr(FinishedPieces, "keep", keep_and_press)
    opened = nullcontext(this_machine())
    monkeypatch.setattr("rna_work.executors.open_executor", lambda address: opened)
    out = tmp_path / "a.exr"
    assert render([str(scene_file.path), "--out", str(out), "--cluster", "a:1"]) == INTERRUPTED
    pieces = tmp_path / "a.exr.pieces"
    start, stop = min(path.stem for path in pieces.glob("*.safetensors")).split("-")
    share = (int(stop) - int(start)) / prod(scene_file.scene.resolution)
    assert 0.01 < share < 0.5 and not out.exists()
    assert capsys.readouterr().err.splitlines()[-1] == (
        f"stopped: no image was written; {share:.0%} of its pixels, each with all 4 samples, are "
        f"in {pieces}; the same command goes on"
    )


def test_what_is_missing_between_pieces():
    there = [Piece(3, 5), Piece(5, 8)]
    assert list(missing_pieces(10, there)) == [Piece(0, 3), Piece(8, 10)]
    assert list(missing_pieces(8, [Piece(0, 8)])) == []


def test_a_full_disk_is_one_line(tmp_path):
    blocked = tmp_path / "file"
    blocked.touch()
    with pytest.raises(SceneError, match="cannot be written"):
        FinishedPieces(blocked, "key").keep(Piece(0, 4), Film((4, 1)))
