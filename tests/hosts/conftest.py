"""The C host, compiled once for all its tests."""

from pathlib import Path

import pytest

from tests.hosts.c_host import build


@pytest.fixture(scope="session")
def programs(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """The host's programs by name, for any CPU of this kind."""
    names = ("librna.so", "conform", "render")
    paths = build(tmp_path_factory.mktemp("c-host"), *names, arch="")
    return dict(zip(names, paths, strict=True))


@pytest.fixture(scope="session")
def library(programs: dict[str, Path]) -> Path:
    return programs["librna.so"]
