"""The suite's frame: finished cases are kept, skipped cases have a reason."""

import json
from dataclasses import replace

import pytest

from rna_bench.cli import main
from rna_bench.stability.case import Case, Result, Verdict
from rna_bench.stability.cases import CASE_NAMES
from rna_bench.stability.fixtures import Fixtures, Subject
from rna_bench.stability.stability_report import read_results, table
from rna_bench.stability.suite import CASES, run_cases
from rna_sdk.errors import TrainingError
from tests.exporters.synthetic import make_dataset


def counting(measured: list[int]) -> Case:
    def measure(fixtures: Fixtures) -> list[dict]:
        measured.append(1)
        return [{"value": len(measured)}]

    return Case(
        name="counting",
        title="Counting",
        varies="nothing",
        mark="one",
        measure=measure,
        judge=lambda rows: Verdict(rows[0]["value"] == 1, str(rows[0]["value"])),
        draw=lambda figure, rows: None,
    )


def test_the_command_knows_every_case():
    assert tuple(case.name for case in CASES) == CASE_NAMES


def test_a_finished_case_is_measured_once(tmp_path):
    measured: list[int] = []
    fixtures = Fixtures(tmp_path / "work", Subject(), 100, 1)

    def run(again: bool = False, steps: int = 100) -> list[Result]:
        case = counting(measured)
        return run_cases([case], fixtures, tmp_path, {"steps": steps}, again, lambda _: None)

    assert run()[0].status == "pass" and run()[0].status == "pass" and len(measured) == 1
    assert run(again=True)[0].status == "fail" and len(measured) == 2
    with pytest.raises(TrainingError, match="other"):
        run(steps=7)


def test_cases_say_why_they_are_left_out(tmp_path):
    fixtures = Fixtures(tmp_path / "work", Subject(make_dataset(tmp_path / "ball")), 100, 1)
    lit = replace(counting([]), needs=("dataset", "source"))
    hair = replace(counting([]), kinds=("fiber",))
    results = run_cases([lit, hair], fixtures, tmp_path, {}, False, lambda _: None)
    assert [r.skipped for r in results] == ["no source given", "not for assets of kind surface"]
    assert table(results).count("| skipped |") == 2


def test_a_tiny_run(tmp_path):
    dataset = make_dataset(tmp_path / "ball")
    out = tmp_path / "out"
    command = ["stability", str(dataset.folder), "--out", str(out), "--short", "--steps", "80"]
    cases = ["--cases", "grazing", "zoom"]
    assert main([*command, *cases]) == 0
    saved = json.loads((out / "results.json").read_text())
    assert [c["status"] for c in saved["cases"]][1] == "skipped"
    assert {row["model"] for row in saved["cases"][0]["rows"]} > {"package"}
    for name in ("summary.md", "grazing.svg"):
        assert (out / name).stat().st_size > 0
    assert not (out / "zoom.png").exists()
    stamp, _, _, results = read_results(out / "results.json", CASES)
    assert main(["stability", "--redraw", str(out / "results.json"), "--out", str(out / "2")]) == 0
    assert table(results) == (out / "2" / "summary.md").read_text()
    assert stamp["command"].startswith("rna-bench stability ball --out out")
    assert read_results(out / "2" / "results.json", CASES)[0] == stamp


def test_a_missing_file_is_one_line(tmp_path, capsys):
    assert main(["stability", "--package", "no.rna", "--out", str(tmp_path)]) == 1
    assert capsys.readouterr().err == "error: no.rna: no such file\n"
