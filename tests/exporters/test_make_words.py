"""What rna-make says and leaves for the next step: time left, a picture in training, a scene."""

import io
from types import SimpleNamespace

import pytest

from rna_export.make import make_progress as progress_module
from rna_export.make import rna_make
from rna_export.make.goal import Goal
from rna_export.make.make_progress import Clock, Progress
from rna_export.make.phases import copy_sheet
from rna_export.make.starter import write_starter
from rna_export.pictures import training_picture_of
from rna_render.scene.scene_file import read_scene
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package


@pytest.mark.parametrize(
    ("spent", "limit", "done", "expected"),
    [
        (60.0, 1200.0, 0.0, ", 19 min left"),
        (1190.0, 1200.0, 0.5, ", 10 s left"),
        (1300.0, 1200.0, 0.5, ", 2 min over time"),
        (110.0, None, 0.25, ", 30 s left of this step"),
        (110.0, None, 0.0, ""),
    ],
)
def test_time_left_is_that_of_the_limit_or_of_the_step(spent, limit, done, expected):
    assert Clock(lambda: spent, limit, stage=100.0).left(done) == expected


def test_a_resumed_bar_goes_on_where_it_was(monkeypatch):
    shown = io.StringIO()
    monkeypatch.setattr(progress_module, "_FORMAT", progress_module._FORMAT + "\n")
    monkeypatch.setattr("sys.stderr", shown)
    progress = Progress(8.0, Clock(lambda: 754.0, 1200.0), done=2.0)
    progress.stage("round 2: training small", 1.0).done()
    progress.close()
    last = shown.getvalue().strip().splitlines()[-1]
    assert "38%" in last and "12:34, 446 s left" not in last and "12:34, 7 min left" in last


def test_the_picture_is_that_of_the_newest_training(tmp_path):
    picture = training_picture_of(tmp_path / "helmet.rna")
    assert picture == tmp_path / "helmet.training.png"
    copy_sheet(tmp_path / "run", picture)
    assert not picture.exists()
    (tmp_path / "run").mkdir()
    (tmp_path / "run" / "sheet.png").write_bytes(b"a sheet")
    copy_sheet(tmp_path / "run", picture)
    assert picture.read_bytes() == b"a sheet"
    copy_sheet(tmp_path / "run", tmp_path / "no" / "folder.png")  # ends no training


def test_a_starter_scene_is_written_once(tmp_path):
    package = write_lambert_package(tmp_path / "my ball.rna", sphere(2))
    scene = write_starter(package)
    assert scene == tmp_path / "scene.yaml"
    assert read_scene(scene).scene == read_scene(package).scene
    scene.write_text("mine")
    assert write_starter(package) is None and scene.read_text() == "mine"


def test_the_cheapest_tier_that_meets_the_goal_is_named():
    def tier(name: str, psnr: float, ns: float) -> SimpleNamespace:
        return SimpleNamespace(
            name=name,
            validation=SimpleNamespace(psnr=psnr, flip=0.04),
            cost=SimpleNamespace(ns_per_query=ns),
        )

    tiers = [tier("hq", 38.0, 900.0), tier("small", 36.5, 150.0), tier("small-int8", 35.9, 80.0)]
    made = SimpleNamespace(lead="hq", why="goal met", rounds=2, without_noise=False)

    def closing(goal: Goal, *shown: SimpleNamespace) -> str:
        return rna_make._outcome(made, SimpleNamespace(tiers=shown), goal)

    goal = Goal("min_psnr", 36.0)
    assert closing(goal, *tiers).startswith(f"goal met: {goal}, cheapest by small: 150 ns/query; ")
    assert closing(goal, tiers[0]).startswith(f"goal met: {goal}; ")
    assert "cheapest by small-int8" in closing(Goal("max_error", 0.05), *tiers)
    assert closing(Goal("min_psnr", 39.0), *tiers).startswith("goal not met")
    made.without_noise = True
    assert closing(Goal("min_psnr", 39.0), *tiers).endswith("validation images; capture rounds: 2")
