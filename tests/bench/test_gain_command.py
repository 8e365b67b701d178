"""`rna-bench gain`: the table of measured assets."""

import json

import pytest

from rna_bench.accuracy.gain_command import SCENES, speeds
from rna_bench.checkout import ROOT
from rna_bench.cli import main as bench
from rna_export.capture.estimate.gain import left_out, table_of
from tests.exporters.test_gain import known, pilot

__all__ = ["known"]


def test_the_table_has_the_measured_speeds_and_an_error_below_3():
    """After new results of `rna-bench scenes`: `rna-bench gain NAME --scenes RESULT`."""
    assets = table_of()
    for name, one in assets.items():
        assert one.scenes == speeds(ROOT / "benchmarks" / "results" / f"scenes-{name}.json"), name
    assert {"toy", "head", "helmet", "curls", "blonde"} <= set(assets)
    assert max(max(off, 1.0 / off) for off in left_out(assets).values()) < 3.0


def test_rna_bench_gain_keeps_a_pilot_for_new_speeds(known, tmp_path, capsys):
    table, result = tmp_path / "table.json", tmp_path / "scenes.json"
    rows = [{"samples": 16, "equal_error": {"times_as_fast": 4.0}}, {"samples": 64}]
    result.write_text(json.dumps({"scenes": {key: {"ours": rows} for key in SCENES}}))
    new = ["--scenes", str(result), "--table", str(table)]
    assert bench(["gain", "toy", *new]) == 1  # no pilot of it yet
    assert "found no asset toy" in capsys.readouterr().err
    assert bench(["gain", "toy", "toy.py", *new]) == 0
    assert table_of(table)["toy"].times == pytest.approx(4.0)
    result.write_text(result.read_text().replace("4.0", "5.0"))
    assert bench(["gain", "toy", *new]) == 0
    assert table_of(table)["toy"].times == pytest.approx(5.0)
    assert table_of(table)["toy"].pilot == pilot(10.0)
    result.write_text(json.dumps({"scenes": {"forest": {"ours": rows}}}))
    assert bench(["gain", "toy", *new]) == 1
    assert "found no scene studio, lamp" in capsys.readouterr().err
    lacking = {key: {"ours": rows[1:] if key == "lamp" else rows} for key in SCENES}
    result.write_text(json.dumps({"scenes": lacking}))
    assert bench(["gain", "toy", *new]) == 1
    assert "found no picture of 16 samples in lamp" in capsys.readouterr().err
