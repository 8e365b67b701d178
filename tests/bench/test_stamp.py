"""What stands beside a result: commit, command, machine."""

import json
import subprocess

import pytest

from rna_bench.checkout import ROOT
from rna_bench.results import write_results
from rna_bench.stamp import commit, cpu_features, stamp


@pytest.fixture
def checkout(tmp_path):
    """A repository with one commit."""
    for command in (
        ["init", "--quiet"],
        ["config", "user.email", "a@b"],
        ["config", "user.name", "a"],
        ["commit", "--quiet", "--allow-empty", "--message", "one"],
    ):
        subprocess.run(["git", *command], cwd=tmp_path, check=True)
    return tmp_path


def test_changes_are_told(checkout):
    clean = commit(checkout)
    assert len(clean) == 12 and int(clean, 16) >= 0
    (checkout / "new.txt").write_text("")
    assert commit(checkout) == f"{clean}+changes"


def test_without_a_repository_the_commit_is_unknown(tmp_path):
    assert commit(tmp_path) == "unknown"


def test_the_stamp_says_what_ran_where(monkeypatch):
    monkeypatch.setenv("NUMBA_CPU_NAME", "")
    actual = stamp(
        ["scenes", str(ROOT / "examples" / "a.rna"), "/elsewhere/b c.py", "--samples", "4"]
    )
    assert actual["command"] == "rna-bench scenes examples/a.rna 'b c.py' --samples 4"
    assert actual["cores"] >= 1 and len(actual["load"]) == 3 and actual["cpu"]
    assert set(actual) == {
        *("command", "commit", "date", "cpu", "cpu_features", "cores", "load", "system")
    }


def test_restricted_processors_are_told(monkeypatch):
    monkeypatch.setenv("NUMBA_CPU_NAME", "haswell")
    assert cpu_features() == ["restricted to haswell"]


def test_results_are_stamped_and_written_whole(tmp_path):
    path = tmp_path / "new" / "a.json"
    write_results(path, {"commit": "1"}, {"rate": 2.0})
    assert list(json.loads(path.read_text())) == ["stamp", "rate"]
    with pytest.raises(TypeError):
        write_results(path, {"commit": "2"}, {"rate": object()})
    assert json.loads(path.read_text())["stamp"] == {"commit": "1"}
    assert [p.name for p in path.parent.iterdir()] == ["a.json"]
