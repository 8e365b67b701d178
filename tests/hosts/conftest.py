"""The C host, compiled once for all its tests."""

import pytest

from tests.hosts.c_host import build


@pytest.fixture(scope="session")
def programs(tmp_path_factory):
    """The host's programs by name, for any CPU of this kind."""
    names = ("librna.so", "conform", "render")
    paths = build(tmp_path_factory.mktemp("c-host"), *names, arch="")
    return dict(zip(names, paths, strict=True))


@pytest.fixture(scope="session")
def library(programs):
    return programs["librna.so"]
