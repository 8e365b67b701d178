"""What the README says can be done."""

import re
import shlex
import tomllib
from collections.abc import Callable
from importlib import import_module

import numpy as np
import pytest

from rna_export.make.rna_make import parser as make_parser
from rna_export.make.starter import write_starter
from tests.conftest import REPOSITORY
from tests.package.builders import make_tiny_package
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package

PAGES = [path.relative_to(REPOSITORY) for path in (REPOSITORY / "docs").rglob("*.md")]
README = (REPOSITORY / "README.md").read_text()


def test_the_example_runs(tmp_path):
    make_tiny_package(tmp_path / "tiny.rna")
    (code,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    code, count = re.subn(
        r'load\("out/toy\.rna".*?\)', f"load({str(tmp_path / 'tiny.rna')!r})", code
    )
    assert count == 1
    names: dict[str, object] = {}
    exec(code, names)
    radiance = names["radiance"]
    assert isinstance(radiance, np.ndarray)
    assert radiance.shape == names["points"].shape and np.isfinite(radiance).all()


COMMANDS = [
    shlex.split(line, comments=True) for line in re.findall(r"^    (rna-.*)$", README, re.M)
]
WEB_NAMES = {"rna-three", "rna-viewer"}  # a package for npm, and an element of HTML
SMALL = ["--samples", "1", "--resolution", "8x6"]


def main_of(command: str) -> Callable[[list[str]], int]:
    scripts = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["project"]["scripts"]
    module, function = scripts[command].split(":")
    main: Callable[[list[str]], int] = getattr(import_module(module), function)
    return main


def test_its_commands_run_in_their_order(tmp_path, monkeypatch):
    """Word for word, with a small package and images in the place of what takes long.

    tests/test_make.py runs rna-make.
    """
    monkeypatch.chdir(tmp_path)
    (tmp_path / "out").mkdir()
    monkeypatch.setattr("rna_render.preview.preview_command.preview", lambda *_: None)
    monkeypatch.setattr("rna_view.rna_view_command._serve", lambda *_: None)
    ran = []
    for command, *arguments in COMMANDS:
        ran.append(command)
        if command == "rna-make":
            options = make_parser().parse_args(arguments)
            assert all((REPOSITORY / model).is_file() for model in options.model)
            assert write_starter(write_lambert_package(options.out, sphere(2)))
        elif command == "rna-capture":
            assert arguments == ["--setup-blender"]
        else:
            more = SMALL if command == "rna-run" else []
            assert main_of(command)([*arguments, *more]) == 0, command
    assert {"rna-make", "rna-view", "rna-run", "rna-info"} <= set(ran)
    actual = {path.name for path in (tmp_path / "out").iterdir()}
    assert {"toy.rna", "scene.yaml", "toy.png", "toy.exr"} == actual


@pytest.mark.parametrize("page", ["README.md", "CONTRIBUTING.md", *map(str, PAGES)])
def test_nothing_is_installed_from_an_index_that_does_not_have_it(page):
    assert not re.search(r"pip install[^\n]*[ ']rna-sdk", (REPOSITORY / page).read_text())


def test_its_commands_exist():
    scripts = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["project"]["scripts"]
    commands = set(re.findall(r"\brna-[a-z]+\b", README)) - {"rna-sdk", *WEB_NAMES}
    assert commands <= set(scripts)


@pytest.mark.parametrize("page", ["README.md", "CONTRIBUTING.md", *map(str, PAGES)])
def test_links_lead_somewhere(page):
    path = REPOSITORY / page
    links = re.findall(r"\]\((?!https?:)([^)#]+)", path.read_text())
    assert [link for link in links if not (path.parent / link).exists()] == []


def test_the_first_look_is_at_a_package_of_the_clone_before_anything_is_baked():
    (first, *_) = re.findall(r"(?:^    .+\n)+", README, re.M)
    demo, look = (line.split("#")[0].split() for line in first.splitlines())
    assert demo == ["./scripts/demo"] and look[0] == ".venv/bin/rna-view"
    assert len(list(REPOSITORY.glob(look[1]))) == 3
    assert (REPOSITORY / "scripts/demo").read_text().splitlines()[-1].endswith(f'{" ".join(look)}"')
    named = re.findall(r"`[^`\n]*(examples/[\w/]+\.rna)`", README)
    assert named and all((REPOSITORY / path).is_file() for path in named)
