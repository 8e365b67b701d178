"""`rna-bench frontier` from a dataset to its chart, on a tiny grid."""

import json

import numpy as np
import pytest
from PIL import Image

from rna_bench.cli import main
from rna_bench.frontier import frontier_study as study_module
from rna_bench.frontier.chart_points import front, last_tenth
from rna_bench.frontier.findings import findings, sentences
from rna_bench.frontier.frontier_chart import draw
from rna_bench.frontier.trials.grid import full_grid
from rna_bench.frontier.trials.trial import Trial
from rna_bench.frontier.trials.trial_pool import TrialWorkers
from rna_work.threads import Threads
from tests.exporters.synthetic import make_dataset, tiny
from tests.frontier.hurried import hurried_trials


def grid(kind: str, steps: int) -> list[Trial]:
    models = {"ours": tiny(steps=steps), "paper-small": tiny("paper-small", steps=steps)}
    return [
        Trial(name="ours", family="ours", preset=models["ours"]),
        Trial(name="paper-small", family="paper", preset=models["paper-small"]),
        Trial(
            name="paper-inputs",
            family="ablation",
            preset=models["ours"].with_model(inputs=models["paper-small"].model.inputs),
            tables=("paper-inputs",),
        ),
    ]


@pytest.fixture(scope="module", autouse=True)
def hurried():
    with hurried_trials():
        yield


@pytest.fixture(scope="module")
def dataset(tmp_path_factory):
    return make_dataset(tmp_path_factory.mktemp("data") / "ball.rays")


@pytest.fixture(scope="module")
def out(dataset, tmp_path_factory):
    """The folder of a finished study, whose worker is in this process: as `hurried` as it."""
    folder = tmp_path_factory.mktemp("study")
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(study_module, "short_grid", grid)
        patched.setattr(TrialWorkers, "backend", lambda _: Threads(1))
        command = ["frontier", str(dataset.folder), "--out", str(folder)]
        assert main([*command, "--short", "--steps", "12", "--workers", "1"]) == 0
    return folder


def test_json_has_cost_and_error_of_every_model(out):
    report = json.loads((out / "frontier.json").read_text())
    assert {p["name"] for p in report["points"]} == {"ours", "paper-small", "paper-inputs"}
    for point in report["points"]:
        assert point["ns"] > 0.0 and point["ns_one_thread"] > 0.0 and point["bytes"] > 1000
        assert 0.0 < point["share_of_gemm"] < 2.0
        assert point["psnr"] > 0.0 and point["flip"] > 0.0 and point["p99"] > 0.0
    assert report["costs"]["gemm_gflops"] > 0.0
    assert (out / "frontier.svg").stat().st_size > 10_000
    with Image.open(out / "tables.png") as sheet:
        assert sheet.width > 200 and sheet.height > 200  # Cycles and one ablation, its error below
        assert np.asarray(sheet.convert("L")).std() > 30.0


def test_finished_study_trains_nothing_again(out, dataset, monkeypatch):
    monkeypatch.setattr(study_module, "short_grid", grid)
    monkeypatch.setattr(study_module, "TrialPool", None)
    before = (out / "costs.json").read_bytes()
    command = ["frontier", str(dataset.folder), "--out", str(out)]
    assert main([*command, "--short", "--steps", "12", "--workers", "1"]) == 0
    assert (out / "costs.json").read_bytes() == before


def test_unknown_trial_is_one_line(out, dataset, capsys):
    command = ["frontier", str(dataset.folder), "--out", str(out), "--short"]
    assert main([*command, "--trials", "w7"]) == 1
    assert "--trials: found w7; expected of ours, " in capsys.readouterr().err


def test_trials_are_chosen_by_name_family_and_table():
    trials = full_grid("surface")
    tables = study_module._chosen(trials, ["architecture", "channels"])
    assert tables == study_module._chosen(trials, ["paper"]) and len(tables) == 13
    names = {trial.name for trial in study_module._chosen(trials, ["nrhints", "paper-inputs"])}
    assert names == {"nrhints", "w64-paper-inputs", "w256-paper-inputs"}


def point(name: str, family: str, ns: float, psnr: float) -> dict[str, object]:
    flip = 10.0 ** (-psnr / 20.0)
    known = {"name": name, "family": family, "ns": ns, "psnr": psnr, "flip": flip}
    return {**known, "precision": "float32-float16"}


def test_chart_takes_short_and_long_trainings_of_one_asset(out, tmp_path):
    report = json.loads((out / "frontier.json").read_text())
    longer = {**report, "points": [{**p, "steps": 10 * p["steps"]} for p in report["points"]]}
    drawn = []
    for name, reports in (("one", [report]), ("both", [report, longer])):
        draw(reports, tmp_path / f"{name}.png")
        drawn.append(np.asarray(Image.open(tmp_path / f"{name}.png")))
    one, both = drawn
    assert one.shape == both.shape  # one row
    assert np.any(one != both)


def test_last_tenth_is_what_a_training_still_wins():
    assert last_tenth([(50, 30.0), (90, 34.0), (95, 34.5), (100, 35.0)], 100) == 1.0
    assert last_tenth([(100, 35.0)], 100) is None


def test_front_holds_what_none_beats_at_its_cost():
    points = [
        point("a", "ours", 10, 20.0),
        point("b", "ours", 20, 19.0),
        point("c", "paper", 30, 25.0),
        point("d", "ablation", 5, 40.0),
    ]
    assert [p["name"] for p in front(points, "ns")] == ["a", "c"]


def test_findings_compare_with_the_papers_two():
    points = [
        point("cheap", "ours", 10, 30.0),
        point("middle", "ours", 40, 33.0),
        point("dear", "ours", 400, 40.0),
        point("paper-small", "paper", 50, 25.0),
        point("paper-hq", "paper", 800, 29.0),
    ]
    actual = findings(points)
    assert actual["as_accurate_as_paper_hq"]["name"].startswith("cheap")
    assert actual["as_accurate_as_paper_hq"]["times_as_cheap"] == 80.0
    assert actual["as_cheap_as_paper_small"]["name"].startswith("middle")
    assert actual["as_cheap_as_paper_small"]["db_better"] == 8.0
    assert len(sentences(actual)) == 2
    assert sentences(findings(points[:3])) == []
