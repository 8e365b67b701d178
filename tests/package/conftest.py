"""A good package of each kind for the tests here."""

import pytest

from tests.package.builders import make_tiny_fiber_package, make_tiny_package, read_entries
from tests.package.corpus.registry import good_entries
from tests.package.lantern import make_lantern


@pytest.fixture(scope="session")
def tiny(tmp_path_factory):
    """Path of a good package; do not change it."""
    return make_tiny_package(tmp_path_factory.mktemp("package") / "tiny.rna")


@pytest.fixture(scope="session")
def entries(tiny):
    """Its entries, name -> data."""
    return read_entries(tiny)


@pytest.fixture(scope="session")
def tuft(tmp_path_factory):
    """Path of a good package of fibers; do not change it."""
    return make_tiny_fiber_package(tmp_path_factory.mktemp("package") / "tuft.rna")


@pytest.fixture(scope="session")
def fiber_entries(tuft):
    """Its entries, name -> data."""
    return read_entries(tuft)


@pytest.fixture(scope="session")
def lantern(tmp_path_factory):
    """Path of a good package of two parts with light and holes; do not change it."""
    return make_lantern(tmp_path_factory.mktemp("package") / "lantern.rna")


@pytest.fixture(scope="session")
def good(tmp_path_factory):
    """Entries of the packages that the corpus breaks."""
    return good_entries(tmp_path_factory.mktemp("good"))
