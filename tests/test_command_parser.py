"""What every command has: --version, short errors of usage; next commands that can be copied."""

import shlex
import tomllib
from importlib import import_module

import pytest

import rna_sdk
from rna_sdk.commands.console import command_line, command_parser
from tests.conftest import REPOSITORY

COMMANDS = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["project"]["scripts"]


def main_of(command: str):
    module, name = COMMANDS[command].split(":")
    return getattr(import_module(module), name)


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_says_its_version(command, capsys, monkeypatch):
    monkeypatch.setattr("sys.argv", [command, "--version"])
    with pytest.raises(SystemExit) as ended:
        main_of(command)()
    assert ended.value.code == 0
    assert capsys.readouterr().out == f"{command} {rna_sdk.__version__}\n"


def test_a_name_of_two_lines_makes_an_error_of_one(capsys):
    with pytest.raises(SystemExit):
        main_of("rna-export")(["two\nlines.rna", "--out", "out.rna"])
    assert "found two; lines.rna, expected checkpoints" in capsys.readouterr().err.splitlines()[1]


@pytest.mark.parametrize("command", COMMANDS)
def test_bad_usage_is_an_example_and_the_error(command, capsys, monkeypatch):
    monkeypatch.setattr("sys.argv", [command])
    with pytest.raises(SystemExit) as ended:
        main_of(command)()
    assert ended.value.code == 2
    usage, error = capsys.readouterr().err.splitlines()
    assert usage.startswith(f"usage: {command} ") and f"{command} --help" in usage
    assert error.startswith(f"{command}: error: ")


def test_an_unknown_option_names_the_likely_one(capsys):
    parser = command_parser("rna-x", "Do it.", "rna-x")
    parser.add_argument("--samples")
    for given, hint in ((["--sampels", "4"], "; did you mean --samples?"), (["--zzz"], "")):
        with pytest.raises(SystemExit):
            parser.parse_args(given)
        said = capsys.readouterr().err.splitlines()[-1]
        assert said == f"rna-x: error: unrecognized arguments: {' '.join(given)}{hint}"


def test_names_with_spaces_are_quoted_in_commands():
    line = command_line("rna-view", "my toy.rna", "a'b.yaml")
    assert shlex.split(line) == ["rna-view", "my toy.rna", "a'b.yaml"]
    assert command_line("rna-view", "toy.rna") == "rna-view toy.rna"
