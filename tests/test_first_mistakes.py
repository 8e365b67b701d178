"""Mistakes of a first hour at the command line: one line that says what to do."""

import tomllib
from importlib import import_module

import pytest

from tests.conftest import REPOSITORY

COMMANDS = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["project"]["scripts"]
MISTAKES = [  # what is typed, the exit status, a part of the last line
    ("rna-run", 2, "the following arguments are required: FILE"),
    ("rna-run scene.yaml", 2, "one of --png, --out and --preview is required"),
    ("rna-run scene.yaml --out b.jpg", 2, "expected a name that ends with .exr or .npz or .png"),
    ("rna-run scene.yaml --out a.exr --sampels 4", 2, "did you mean --samples?"),
    ("rna-run helmet.glb --png a.png", 1, "rna-make helmet.glb --out helmet.rna makes a package"),
    ("rna-run none.rna --png a.png", 1, "none.rna: No such file or directory"),
    ("rna-view helmet.glb", 1, "rna-make helmet.glb --out helmet.rna makes a package"),
    ("rna-info scene.yaml", 1, "a scene, not a package; rna-run scene.yaml --png scene.png"),
    ("rna-make helmet.glb", 2, "expected one of --out and --out-dir"),
    ("rna-make helmet.glb --out a.rna --minutse 5", 2, "did you mean --minutes?"),
    ("rna-make toy.rna --out b.rna", 1, "a package, not a model; rna-run toy.rna --png toy.png"),
    ("rna-capture toy.rna --out b.rays", 1, "a package, not a model"),
]


@pytest.mark.parametrize(("typed", "status", "message"), MISTAKES, ids=[m[0] for m in MISTAKES])
def test_a_mistake_says_what_to_do(
    typed,
    status,
    message,
    tmp_path,
    capsys,
    monkeypatch,
):
    monkeypatch.chdir(tmp_path)
    for name in ("helmet.glb", "toy.rna", "scene.yaml"):
        (tmp_path / name).write_bytes(b"")
    command, *arguments = typed.split()
    module, function = COMMANDS[command].split(":")
    main = getattr(import_module(module), function)
    try:
        actual = main(arguments)
    except SystemExit as ended:
        actual = ended.code
    said = capsys.readouterr().err.splitlines()
    assert (actual, len(said)) == (status, status)  # bad usage has an example before it
    assert message in said[-1]
    assert len(list(tmp_path.iterdir())) == 3
