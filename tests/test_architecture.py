"""docs/architecture.md: its layers, its files, and the files that a render goes through."""

import ast
import re
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from types import FrameType
from typing import NamedTuple

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
def test_layers(package, folder, ours):
    packages = {row[0] for row in LAYERS}
    actual = imports(REPOSITORY / folder) & packages - {package}
    assert ours.strip() == "all" or actual == set(re.findall(r"`(\w+)`", ours))


def test_references_share_nothing_with_what_they_check():
    kinds = {
        name
        for path in ("base_color", "lobes", "nearby")
        for name in imported(REPOSITORY / "tests" / "reference" / f"{path}.py")
    }
    assert kinds <= {"rna_sdk.package"}


def test_files_exist():
    """Each row names files whole, or beside the file before."""
    for row in re.findall(r"^\|.*\|$", PAGE, re.MULTILINE):
        folder = REPOSITORY
        for name in re.findall(r"`([\w/]+\.(?:py|wgsl|md|txt|toml))`", row):
            path = REPOSITORY / name if "/" in name else folder / name
            assert path.is_file() or (REPOSITORY / name).is_file(), f"{name} in {row}"
            folder = path.parent


def test_the_walk_is_short():
    assert len(set(WALK)) == len(WALK) <= 14


MILESTONES = {
    ("scene_file.py", "read_scene"),
    ("world.py", "__init__"),
    ("integrator.py", "__init__"),
    ("instances.py", "intersect"),
}
"""Functions in whose calls the scene is read, its world and its integrator are made, and the first
rays are traced."""


class Rendered(NamedTuple):
    """What a render went through.

    on_stack: files on the stacks of the decoder. way: to the first rays, file by file, from each
    milestone back to what it and the next one were called by.
    """

    on_stack: set[str]
    way: list[str]


@pytest.fixture(scope="module")
def rendered(tmp_path_factory):
    decoder, main_thread = REPOSITORY / WALK[-1], threading.main_thread()
    on_stack: set[str] = set()
    stacks: dict[tuple[str, str], list[str]] = {}

    def profile(frame: FrameType, event: str, argument: object) -> None:
        code, main_frame = frame.f_code, None
        in_main = threading.current_thread() == main_thread
        if code.co_filename == str(decoder) and not in_main:
            on_stack.update(files_on_stack(frame))
            on_stack.update(files_on_stack(sys._current_frames()[main_thread.ident]))
        milestone = Path(code.co_filename).name, code.co_name
        if event == "call" and milestone in MILESTONES and milestone not in stacks:
            if not in_main:
                main_frame = sys._current_frames()[main_thread.ident]
            files = [*files_on_stack(frame), *files_on_stack(main_frame)]
            if files and "rna_work/" not in files[0]:
                stacks[milestone] = files[::-1]

    scene = REPOSITORY / "examples" / "quickstart" / "scene.yaml"
    out = tmp_path_factory.mktemp("walk") / "a.exr"
    small = ["--samples", "1", "--resolution", "32x18"]
    threading.setprofile(profile)
    sys.setprofile(profile)
    try:
        assert main([str(scene), "--out", str(out), *small]) == 0
    finally:
        sys.setprofile(None)
        threading.setprofile(None)  # type: ignore[arg-type]
    assert stacks.keys() == MILESTONES
    return Rendered(on_stack, way_through(list(stacks.values())))


def way_through(stacks: list[list[str]]) -> list[str]:
    """The files of stacks, from the outermost call on; of each what the one before has not."""
    way: list[str] = []
    before: list[str] = []
    for stack in stacks:
        common = 0
        while common < min(len(before), len(stack)) and before[common] == stack[common]:
            common += 1
        way += stack[max(common - 1, 0) :]
        before = stack
    return [file for file, last in zip(way, ["", *way], strict=False) if file != last]


def test_the_walk_is_what_a_render_does(rendered):
    """No file of ours is on the stack of the decoder, in its thread or in the main one, but these.

    The kernel that fills the decoder's inputs is compiled, and so on no stack of Python's.
    """
    compiled = {"rna_sdk/runtime/kernels/query_kernel.py"}
    assert rendered.on_stack | compiled == set(WALK)


def test_the_way_to_the_first_ray_is_short(rendered):
    """Its last file is that of the rays."""
    files = set(rendered.way) - {"runtime/rna_trace/embree/instances.py"}
    assert len(files) <= 12, sorted(files)
    assert len(rendered.way) - len(set(rendered.way)) <= 8, rendered.way


def test_a_way_comes_back_to_what_called_both():
    assert way_through([["a", "b", "c"], ["a", "b", "b", "d"], ["a", "e"]]) == [
        *("a", "b", "c", "b", "d", "a", "e")
    ]


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
