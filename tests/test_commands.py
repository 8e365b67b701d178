"""All console scripts: their --help, and what they say where an extra is not installed."""

import argparse
import json
import os
import subprocess
import sys
import tomllib
from functools import cache
from importlib import import_module
from importlib.metadata import distribution, packages_distributions
from pathlib import Path
from typing import NamedTuple

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from tests.conftest import REPOSITORY

PROJECT = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["project"]
COMMANDS = PROJECT["scripts"]
TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"

WITH_BASE_ALONE = """
import contextlib, importlib, io, json, sys
from importlib.abc import MetaPathFinder

refused = set(sys.argv[1].split(","))

class Refuse(MetaPathFinder):
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in refused:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)

sys.meta_path.insert(0, Refuse())
answers = []
for entry, *arguments in json.load(sys.stdin):
    module, function = entry.split(":")
    sys.argv = ["command", *arguments]
    out, error = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(error):
        try:
            status = getattr(importlib.import_module(module), function)()
        except SystemExit as end:
            status = end.code
    answers.append([status or 0, out.getvalue(), error.getvalue()])
print(json.dumps(answers))
"""


class Done(NamedTuple):
    """What a command said."""

    status: int
    out: str
    error: str


@cache
def modules_beyond_the_base() -> frozenset[str]:
    """Top-level modules installed here that the base requirements do not bring."""
    base, todo = set(), list(PROJECT["dependencies"])
    while todo:
        requirement = Requirement(todo.pop())
        name = canonicalize_name(requirement.name)
        wanted = requirement.marker is None or requirement.marker.evaluate({"extra": ""})
        if wanted and name not in base:
            base.add(name)
            todo += distribution(name).requires or []
    return frozenset(
        module
        for module, owners in packages_distributions().items()
        if not any(canonicalize_name(owner) in {*base, "rna-sdk"} for owner in owners)
    )


def run(*commands: list[object]) -> list[Done]:
    """Commands, each with its arguments, in a process that can import the base install alone."""
    refused = ",".join(sorted(modules_beyond_the_base()))
    calls = [[COMMANDS[name], *map(str, arguments)] for name, *arguments in commands]
    done = subprocess.run(
        [sys.executable, "-c", WITH_BASE_ALONE, refused],
        input=json.dumps(calls),
        capture_output=True,
        text=True,
        env={**os.environ, "COLUMNS": "100"},
    )
    assert done.returncode == 0, done.stderr
    return [Done(*answer) for answer in json.loads(done.stdout)]


def test_the_base_is_small():
    beyond = modules_beyond_the_base()
    assert {"torch", "trimesh", "safetensors", "yaml", "embreex", "tqdm"} <= beyond
    assert not {"numpy", "numba", "onnxruntime", "pydantic"} & beyond


@pytest.fixture(scope="module")
def helps():
    return dict(zip(COMMANDS, run(*([name, "--help"] for name in COMMANDS)), strict=True))


@pytest.mark.parametrize("command", COMMANDS)
def test_help_needs_no_extra_and_begins_with_a_command_to_copy(command, helps):
    done = helps[command]
    assert (done.status, done.error) == (0, "")
    usage, sentence, example = done.out.split("\n\n")[:3]
    assert usage.startswith("usage:") or command == "rna-validate"
    if command == "rna-validate":
        sentence, example = usage, sentence
    assert sentence.endswith(".") and sentence[0].isupper() and "\n" not in sentence
    assert example.startswith(f"  {command} ")


def arguments_that_need(command: str, folder: Path) -> list[object]:
    """Good usage, which gets as far as the first import beyond the base."""
    scene, asset = folder / "scene.yaml", folder / "asset.py"
    scene.write_text("assets: []\n")
    asset.write_text("")
    out = folder / "out"
    return {
        "rna-run": [scene, "--out", folder / "a.exr"],
        "rna-make": [asset, "--out", folder / "a.rna"],
        "rna-capture": [asset, "--out", out],
        "rna-train": [folder, "--out", out],
        "rna-export": [folder / "best.ckpt", "--out", folder / "a.rna"],
        "rna-compare": [TOY, asset, "--out", out],
        "rna-motion": [asset, TOY, "--out", folder / "a.rnam"],
        "rna-bench": ["frontier", folder, "--short", "--out", out],
    }[command]


EXTRAS = {
    "rna-run": "render",
    "rna-make": "train",
    "rna-capture": "capture",
    "rna-train": "train",
    "rna-export": "train",
    "rna-compare": "train",
    "rna-motion": "capture",
    "rna-bench": "bench",
}


@pytest.fixture(scope="module")
def refusals(tmp_path_factory):
    """What commands say that get as far as their first import beyond the base."""
    folders = {name: tmp_path_factory.mktemp(name) for name in EXTRAS}
    commands = ([name, *arguments_that_need(name, folders[name])] for name in EXTRAS)
    return dict(zip(EXTRAS, run(*commands), strict=True))


@pytest.mark.parametrize(("command", "extra"), EXTRAS.items())
def test_a_missing_extra_is_one_line(command, extra, refusals):
    done = refusals[command]
    assert done.status == 1
    assert done.error.startswith("error: no module ") and done.error.count("\n") == 1
    assert f"pip install -e '.[{extra}]' in the clone" in done.error
    assert extra in PROJECT["optional-dependencies"]


def test_what_the_base_can_do_it_does():
    output, valid = run(["rna-info", TOY], ["rna-validate", TOY])
    assert output.status == 0 and "PSNR 41.28 dB" in output.out
    part = (
        "part asset: surface, base colour, a decoder of shadowed light, nearby light, 8 lobes, "
        "rays in 3 mixtures of lobes"
    )
    assert (valid.status, valid.out) == (0, f"{TOY}: {part}\n{TOY}: valid\n")
    assert set(COMMANDS) >= set(EXTRAS)


@pytest.mark.parametrize(
    "module",
    [
        "rna_render.command.rna_run:_parser",
        "rna_sdk.package.command.rna_info:parser",
        "rna_export.make.rna_make:parser",
        "rna_export.capture.rna_capture:parser",
        "rna_export.training.rna_train:parser",
        "rna_export.compare.rna_compare:parser",
        "rna_bench.cli:parser",
    ],
)
def test_options_tell_their_default(module):
    name, function = module.split(":")
    todo = [getattr(import_module(name), function)()]
    while todo:
        for action in todo.pop()._actions:
            if isinstance(action, argparse._SubParsersAction):
                todo += action.choices.values()
            elif action.option_strings and not action.required and action.dest != "help":
                assert "default" in (action.help or ""), action.option_strings
