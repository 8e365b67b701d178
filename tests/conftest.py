"""Tests that need something outside the repository are skipped with a reason."""

import signal
from collections import Counter
from pathlib import Path

import pytest

from rna_export.capture.blender_process.blender_env import find_python
from rna_sdk.errors import CaptureError
from tests.render.chromium import INSTALL, find_chromium

REPOSITORY = Path(__file__).parent.parent
DATA = REPOSITORY.parent / "shared" / "data"
COMPILES = REPOSITORY / "tests" / "render" / "test_asset_emission.py"
SECONDS = {"blender": 3, "chromium": 5}  # about what starting a program takes, by markers


def pytest_configure() -> None:
    """Listen to Ctrl-C, and so do the programs that tests start.

    A script's background job, and all it starts, would ignore it.
    """
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if hasattr(config, "workerinput"):  # one of several processes, see scripts/test
        _longest_files_first(items)
    needs = {"blender": _no_blender, "chromium": _no_chromium, "data": _no_data, "gpu": _no_gpu}
    for marker, reason in needs.items():
        marked = [item for item in items if item.get_closest_marker(marker)]
        if marked and (why := reason()):
            for item in marked:
                item.add_marker(pytest.mark.skip(reason=why))


def _longest_files_first(items: list[pytest.Item]) -> None:
    """Those that start other programs, then those of few tests; many short tests fill up the end.

    One file comes first of all: it compiles what most others load, which both processes would
    otherwise do at the same time.
    """
    tests, seconds = Counter[Path](), Counter[Path]()
    for item in items:
        tests[item.path] += 1
        seconds[item.path] += sum(SECONDS.get(mark.name, 0) for mark in item.iter_markers())
    items.sort(
        key=lambda item: (item.path != COMPILES, -seconds[item.path], tests[item.path], item.path)
    )


@pytest.fixture(scope="session")
def blender_python():
    """The interpreter that can `import bpy`; for tests marked `blender`."""
    return find_python()


@pytest.fixture(scope="session")
def data_folder():
    """The real models; for tests marked `data`."""
    return DATA


def _no_blender() -> str | None:
    try:
        find_python()
    except CaptureError as error:
        return str(error)
    return None


def _no_chromium() -> str | None:
    return None if find_chromium() else INSTALL


def _no_data() -> str | None:
    return None if DATA.is_dir() else f"{DATA} is not there"


def _no_gpu() -> str | None:
    import torch

    return None if torch.cuda.is_available() else "PyTorch finds no CUDA device"
