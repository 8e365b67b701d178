"""Mutated packages through the readers: nothing goes wrong, and planted faults are found."""

import shutil
import subprocess

import pytest

from rna_sdk.package import validator
from tests.fuzz import packages
from tests.fuzz.package_mutations import mutation
from tests.fuzz.packages import Mutations, run_c_host, run_python, run_viewer
from tests.fuzz.planted import C_BUGS, WEB_BUGS, build_planted, planted_web_reader
from tests.hosts.c_host import compiler
from tests.hosts.packages import write_fuzz_packages

pytestmark = pytest.mark.skipif(compiler() is None, reason="needs cc and make")

FUZZED = 1500
PYTHON_FUZZED = 200
WEB_FUZZED = 600
needs_node = pytest.mark.skipif(shutil.which("node") is None, reason="needs Node")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Folder of the C host's program, in which faults can be switched on."""
    folder = tmp_path_factory.mktemp("fuzz")
    try:
        build_planted(folder)
    except subprocess.CalledProcessError:
        pytest.skip("the C compiler has no AddressSanitizer")
    return folder


@pytest.fixture(scope="module")
def seeds(tmp_path_factory):
    return write_fuzz_packages(tmp_path_factory.mktemp("seeds"))


@pytest.fixture(scope="module")
def older(seeds):
    """Those that the numbers of planted faults are of: all but the last, which has base colour."""
    return seeds[:-1]


def test_mutations_are_the_same_by_number(seeds):
    assert mutation(seeds, 35) == mutation(seeds, 35) != mutation(seeds, 35 + len(seeds))


def test_damaged_packages_under_sanitizers(folder, seeds):
    tally = run_c_host(Mutations(seeds, 0, FUZZED), folder)
    assert tally.failures == []
    assert tally.accepted + tally.refused.total() == FUZZED
    assert tally.accepted > FUZZED // 10 and len(tally.refused) > 30


@pytest.mark.parametrize(
    ("bug", "first"),
    [
        ("a texel beside the texture", 150),
        ("a tensor longer than its file", 150),
        ("a vertex that does not exist", 400),
        ("an accessor past its view", 2250),
    ],
)
def test_planted_fault_of_the_c_host_is_found(bug, first, folder, older, monkeypatch):
    """All are reads within the package, which only blocks of an entry's size show.

    first: some mutations before the first that shows it, since the search is not what is tested.
    """
    monkeypatch.setenv("PLANTED", str(list(C_BUGS).index(bug)))
    (failure,) = run_c_host(Mutations(older, first, 100), folder).failures
    assert "AddressSanitizer" in failure


def test_python_reads_what_it_accepts(folder, seeds):
    tally = run_python(Mutations(seeds, 0, PYTHON_FUZZED), folder)
    assert tally.failures == []
    assert tally.accepted > PYTHON_FUZZED // 10 and len(tally.refused) > 20
    assert not tally.disagreements


def test_fault_planted_in_the_validator_is_found(folder, older, monkeypatch):
    """A texture that is shorter than its shape is let through, and then read."""
    monkeypatch.setattr(packages, "_verdicts_of_c_host", lambda *_: {})
    monkeypatch.setattr(validator._Contents, "check_textures", lambda *_: None)
    assert run_python(Mutations(older, 60, 40), folder).failures


@needs_node
def test_viewer_reads_what_it_accepts(folder, seeds):
    tally = run_viewer(Mutations(seeds, 0, WEB_FUZZED), folder)
    assert tally.failures == []
    assert tally.accepted > WEB_FUZZED // 10 and len(tally.refused) > 20


@needs_node
@pytest.mark.parametrize(
    ("bug", "first"),
    [
        ("a texture longer than its file", 150),
        ("a record past the mesh", 6900),
        ("a vertex that does not exist", 400),
    ],
)
def test_planted_fault_of_the_viewer_is_found(bug, first, older, tmp_path, monkeypatch):
    reader = planted_web_reader(tmp_path, WEB_BUGS[bug])
    monkeypatch.setattr(packages, "WEB_READER", reader)
    assert run_viewer(Mutations(older, first, 80), tmp_path).failures
