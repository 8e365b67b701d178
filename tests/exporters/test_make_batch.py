"""Several models in one `rna-make`, and options that are carried on from an earlier run."""

import shutil
from argparse import Namespace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rna_export.make import rna_make
from rna_export.make.batch import SHEET, jobs_of, make_all
from rna_export.make.carry_on import carried_options
from rna_export.make.state import RunSettings, State
from rna_sdk.errors import RnaError, TrainingError
from rna_sdk.package import Package
from tests.conftest import REPOSITORY

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"


def batch(folder: Path, *names: str) -> Namespace:
    models = [folder / name for name in names]
    return Namespace(model=models, out=None, out_dir=folder / "assets", minutes=3.0, more=None)


def test_a_batch_makes_what_it_can_and_lists_failures_at_the_end(tmp_path, capsys):
    def make(job: Namespace) -> None:
        if job.model.stem == "bad":
            raise RnaError("bad.blend: no such file")
        shutil.copy(TOY, job.out)

    jobs = jobs_of(batch(tmp_path, "a.blend", "bad.blend", "c.glb"))
    assert make_all(jobs, make) == 1
    printed = capsys.readouterr().out.splitlines()
    assert printed[0].endswith("assets, 3 minutes each, 9 in all: a.blend, bad.blend, c.glb")
    assert printed[-1] == f"failed: {tmp_path / 'bad.blend'}: bad.blend: no such file"
    assert printed[-2].startswith("made 2 of 3: ")
    assets = tmp_path / "assets"
    names = sorted(path.name for path in assets.iterdir())
    assert names == ["a.png", "a.rna", "c.png", "c.rna", SHEET]
    with Image.open(assets / SHEET) as sheet:
        assert sheet.width == 2 * 320
        assert len(np.unique(np.asarray(sheet.resize((8, 4))).reshape(-1, 3), axis=0)) > 4
    with Package.open(TOY) as package:
        assert (assets / "a.png").read_bytes() == package.poster()


def test_models_of_one_name_are_refused_before_any_work(tmp_path):
    with pytest.raises(RnaError, match=r"two models would write a\.rna"):
        jobs_of(batch(tmp_path, "a.blend", "a.glb"))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["a.blend"], "expected one of --out and --out-dir"),
        (["a.blend", "b.blend", "--out", "a.rna"], "found 2 models, which need --out-dir"),
        (["a.blend", "--out-dir", "d", "--work", "w"], "--work is for one model"),
        (["a.blend", "--out-dir", "d", "--name", "A"], "--name is for one model"),
        (["a.blend", "--out", "a.rna", "--name", "A\nB"], "expected a line of text, found 'A"),
        (["a.blend", "--out", "a.rna", "--name="], "expected a line of text, found ''"),
        (["a.blend", "--out", "a.rna", "--more", "5", "--minutes", "3"], "give no --minutes"),
        (["a.blend", "--out", "a.rna", "--more", "5", "--update"], "give no --update"),
        (["a.blend", "--out", "a.rna", "--more", "0"], "--more: expected a number above 0"),
        (["a.blend", "--out", "a.rna", "--max-error", "36"], "found 36; --min-psnr is for dB"),
    ],
)
def test_bad_usage_exits_with_2(arguments, message, capsys):
    with pytest.raises(SystemExit) as caught:
        rna_make.main(arguments)
    assert caught.value.code == 2 and message in capsys.readouterr().err


@pytest.fixture
def work(tmp_path):
    """Folder of a run of three minutes that is finished."""
    settings = RunSettings(
        source="a.blend",
        source_sha256="0",
        arguments=("--tip", "1"),
        settings={"seed": 7, "sharpest": 0.1},
        scene=None,
        presets=("small", "hq"),
        goal="none",
        minutes=3.0,
        steps=None,
        seed=7,
    )
    State(settings=settings, lights=64, seconds=180.0, is_finished=True).save(tmp_path)
    return tmp_path


def options(**given: object) -> Namespace:
    usual = {"presets": None, "seed": 0, "minutes": None, "more": None, "update": False}
    return Namespace(**{**usual, **given})


def test_more_carries_the_options_of_the_run_on(work):
    carried = carried_options(options(more=10.0), work, ())
    assert (carried.more, carried.minutes) == (10.0, 3.0)
    assert carried.presets == ("small", "hq") and carried.arguments == ("--tip", "1")
    assert carried.settings == {"seed": 7, "sharpest": 0.1} and carried.seed == 7


def test_more_minutes_in_all_are_more_minutes(work):
    assert carried_options(options(minutes=5.0), work, ()).more == pytest.approx(2.0)
    assert carried_options(options(minutes=3.0), work, ()).more is None  # the same command
    with pytest.raises(TrainingError, match=r"--minutes 2: 3\.0 are spent already"):
        carried_options(options(minutes=2.0), work, ())


def test_minutes_of_lobes_are_no_minutes_of_the_run(work):
    assert carried_options(options(minutes=5.0), work, (), 2.0).more is None  # 3 of them, as before
    assert carried_options(options(more=5.0), work, (), 2.0).more == pytest.approx(3.0)


def test_an_update_takes_a_third_of_the_time(work):
    assert carried_options(options(update=True), work, ()).minutes == pytest.approx(1.0)
    assert carried_options(options(update=True, minutes=2.0), work, ()).minutes == 2.0


def test_a_new_run_carries_nothing_on(tmp_path):
    carried = carried_options(options(minutes=5.0, seed=3), tmp_path, ("x",))
    assert (carried.presets, carried.minutes, carried.more) == (("small",), 5.0, None)
    assert (carried.settings, carried.seed, carried.arguments) == ({}, 3, ("x",))
