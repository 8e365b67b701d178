"""docs/architecture.md: its layers, its files, and the files that a render goes through."""

from __future__ import annotations

import ast
import re
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from types import FrameType

import pytest

from rna_render.command.rna_run import main
from tests.conftest import REPOSITORY

PAGE = (REPOSITORY / "docs" / "architecture.md").read_text()
WALK = re.findall(r"^\| \d+ \| `(.*?)` \|", PAGE, re.MULTILINE)


LAYERS = re.findall(r"^\| `(rna_\w+)` \| `(.*?)` \|[^|]*\|(.*?)\|", PAGE, re.MULTILINE)


def imported(path: Path) -> set[str]:
    """Modules of ours that a file imports anywhere."""
    actual = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            actual |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            actual.add(node.module)
    return {name for name in actual if name.startswith("rna_")}


def imports(folder: Path) -> set[str]:
    """Packages of ours that a folder's files import anywhere."""
    return {name.split(".")[0] for path in folder.rglob("*.py") for name in imported(path)}


@pytest.mark.parametrize(("package", "folder", "ours"), LAYERS, ids=[row[0] for row in LAYERS])
def test_layers(package: str, folder: str, ours: str) -> None:
    packages = {row[0] for row in LAYERS}
    actual = imports(REPOSITORY / folder) & packages - {package}
    assert ours.strip() == "all" or actual == set(re.findall(r"`(\w+)`", ours))


def test_references_share_nothing_with_what_they_check() -> None:
    kinds = {
        name
        for path in ("base_color", "lobes", "nearby")
        for name in imported(REPOSITORY / "tests" / "reference" / f"{path}.py")
    }
    assert kinds <= {"rna_sdk.package"}


def test_files_exist() -> None:
    """Each row names files whole, or beside the file before."""
    for row in re.findall(r"^\|.*\|$", PAGE, re.MULTILINE):
        folder = REPOSITORY
        for name in re.findall(r"`([\w/]+\.(?:py|wgsl|md|txt|toml))`", row):
            path = REPOSITORY / name if "/" in name else folder / name
            assert path.is_file() or (REPOSITORY / name).is_file(), f"{name} in {row}"
            folder = path.parent


def test_the_walk_is_short() -> None:
    assert len(set(WALK)) == len(WALK) <= 15


def test_the_walk_is_what_a_render_does(tmp_path: Path) -> None:
    """No file of ours is on the stack of the decoder, in its thread or in the main one, but these.

    The kernel that fills the decoder's inputs is compiled, and so on no stack of Python's.
    """
    scene = REPOSITORY / "examples" / "quickstart" / "scene.yaml"
    decoder, main_thread = REPOSITORY / WALK[-1], threading.main_thread()
    entered: set[str] = set()

    def profile(frame: FrameType, event: str, argument: object) -> None:
        if frame.f_code.co_filename == str(decoder) and threading.current_thread() != main_thread:
            entered.update(files_on_stack(frame))
            entered.update(files_on_stack(sys._current_frames()[main_thread.ident]))

    small = ["--samples", "1", "--resolution", "32x18"]
    threading.setprofile(profile)
    try:
        assert main([str(scene), "--out", str(tmp_path / "a.exr"), *small]) == 0
    finally:
        threading.setprofile(None)  # type: ignore[arg-type]
    compiled = {"rna_sdk/runtime/kernels/query_kernel.py"}
    assert entered | compiled == set(WALK)


def files_on_stack(frame: FrameType | None) -> Iterator[str]:
    """Files below rna_sdk and runtime of a frame and of its callers."""
    while frame is not None:
        path = Path(frame.f_code.co_filename)
        if (
            path.is_relative_to(REPOSITORY)
            and "tests" not in path.parts
            and ".venv" not in path.parts
        ):
            yield path.relative_to(REPOSITORY).as_posix()
        frame = frame.f_back
