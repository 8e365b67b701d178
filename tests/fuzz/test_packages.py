"""Mutated packages through the readers: nothing goes wrong, and planted faults are found."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from rna_bench.readers import fuzz_readers
from rna_bench.readers.fuzz_readers import Mutations, run_python, run_viewer
from rna_sdk.package import validator
from tests.hosts.c_host import build, compiler
from tests.hosts.packages import write_fuzz_packages, write_new_fuzz_packages
from tests.hosts.planted import C_BUGS, WEB_BUGS, build_planted_fuzzer, planted_web_reader

pytestmark = pytest.mark.skipif(compiler() is None, reason="needs cc and make")

FUZZED = 1500
PYTHON_FUZZED = 200
WEB_FUZZED = 600
needs_node = pytest.mark.skipif(shutil.which("node") is None, reason="needs Node")


@pytest.fixture(scope="module")
def programs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder of the fuzzer, in which faults can be switched on, and of `mutations`."""
    folder = tmp_path_factory.mktemp("fuzz")
    try:
        build_planted_fuzzer(folder)
    except subprocess.CalledProcessError:
        pytest.skip("the C compiler has no AddressSanitizer")
    build(folder, "mutations")
    return folder


@pytest.fixture(scope="module")
def mutations(programs: Path, tmp_path_factory: pytest.TempPathFactory) -> Mutations:
    """Of packages with what 1.1 added."""
    return Mutations(programs, write_new_fuzz_packages(tmp_path_factory.mktemp("seeds")))


def run(*command: object, **environment: str) -> subprocess.CompletedProcess[str]:
    words = list(map(str, command))
    env = {**os.environ, **environment}
    return subprocess.run(words, capture_output=True, text=True, timeout=120, env=env)


def test_damaged_packages_under_sanitizers(programs: Path, tmp_path: Path) -> None:
    packages = write_fuzz_packages(tmp_path)
    result = run(programs / "fuzz", 0, FUZZED, *packages)
    assert result.returncode == 0, result.stderr[-4000:]
    tally = json.loads(result.stdout)
    assert tally["accepted"] + sum(tally["refused"].values()) == FUZZED
    assert tally["accepted"] > FUZZED // 10 and tally["evaluated"] > 0
    assert len(tally["refused"]) > 30


@pytest.mark.parametrize(
    ("bug", "first"),
    [
        ("a texel beside the texture", 0),
        ("a tensor longer than its file", 50),
        ("a vertex that does not exist", 400),
        ("an accessor past its view", 7800),
    ],
)
def test_planted_fault_of_the_c_host_is_found(bug: str, first: int, mutations: Mutations) -> None:
    """All are reads within the package, which only blocks of an entry's size show.

    first: some mutations before the first that shows it, since the search is not what is tested.
    """
    number = list(C_BUGS).index(bug)
    result = run(*mutations.command("fuzz", first, 100), PLANTED=str(number))
    assert result.returncode != 0 and "AddressSanitizer" in result.stderr, result.stdout


def test_python_reads_what_it_accepts(mutations: Mutations, tmp_path: Path) -> None:
    tally = run_python(mutations, 0, PYTHON_FUZZED, tmp_path)
    assert (tally.mutations, tally.failures) == (PYTHON_FUZZED, [])
    assert tally.accepted > PYTHON_FUZZED // 10 and len(tally.refused) > 20
    assert not tally.disagreements


def test_fault_planted_in_the_validator_is_found(
    mutations: Mutations, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A texture that is shorter than its shape is let through, and then read."""
    monkeypatch.setattr(fuzz_readers, "_verdicts_of_c_host", lambda *_: {})
    for check in ("check_records", "check_normal_maps"):
        monkeypatch.setattr(validator, check, lambda *_: None)
    assert run_python(mutations, 100, 40, tmp_path).failures


@needs_node
def test_viewer_reads_what_it_accepts(mutations: Mutations, tmp_path: Path) -> None:
    tally = run_viewer(mutations, 0, WEB_FUZZED, tmp_path)
    assert (tally.mutations, tally.failures) == (WEB_FUZZED, [])
    assert tally.accepted > WEB_FUZZED // 10 and len(tally.refused) > 20


@needs_node
@pytest.mark.parametrize(
    ("bug", "first"),
    [
        ("a texture longer than its file", 100),
        ("a record past the mesh", 550),
        ("a vertex that does not exist", 450),
    ],
)
def test_planted_fault_of_the_viewer_is_found(
    bug: str, first: int, mutations: Mutations, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    reader = planted_web_reader(tmp_path, WEB_BUGS[bug])
    monkeypatch.setattr(fuzz_readers, "WEB_READER", reader)
    assert run_viewer(mutations, first, 80, tmp_path).failures


def test_a_run_goes_on_where_it_stopped(programs: Path, tmp_path: Path) -> None:
    out = tmp_path / "fuzz.json"
    for count in (20, 50):
        command = [sys.executable, "-m", "rna_bench.cli", "fuzz", "--seeds", "1.0"]
        command += ["--mutations", count, "--build", programs, "--out", out]
        result = run(*command)
        assert result.returncode == 0, result.stderr
        report = json.loads(out.read_text())
        assert (report["mutations"], report["failures"]) == (count, [])
    whole = report["accepted"] + sum(report["refused"].values())
    assert whole == 50
