"""Every command of rna-bench: its help, its options, and how its modules import one another."""

import argparse
import ast
import re
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

from rna_bench.cli import main, parser_of
from rna_bench.commands import COMMANDS
from tests.conftest import REPOSITORY

PACKAGE = REPOSITORY / "benchmarks" / "rna_bench"
PROGRAMS = {"cli.py", "core_worker.py"}


def imported(path: Path) -> set[str]:
    """Modules of rna_bench that a file imports at its top, for type checks too."""
    names = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("rna_bench."):
            names.add(node.module)
            names |= {f"{node.module}.{alias.name}" for alias in node.names}
    return names


@pytest.mark.parametrize("command", COMMANDS.values(), ids=COMMANDS)
def test_help_tells_what_is_measured_and_every_default(command):
    parser = parser_of(command)
    output = parser.format_help()
    assert command.sentence in output and command.sentence.endswith((".", "?"))
    example = (parser.description or "").split("\n\n")[1]
    assert f"    rna-bench {command.name}" in example
    formatter = parser._get_formatter()
    for action in parser._actions:
        assert action.help, (command.name, action.dest)
        if action.option_strings and not action.required and action.dest != "help":
            assert isinstance(formatter, argparse.HelpFormatter)
            assert "default" in formatter._get_help_string(action), action.option_strings


def test_help_lists_every_command(capsys):
    with pytest.raises(SystemExit) as ended:
        main(["--help"])
    output = capsys.readouterr().out
    assert ended.value.code == 0
    assert all(
        f"  {command.name} " in output and command.sentence in output
        for command in COMMANDS.values()
    )


def test_an_unknown_command_is_bad_usage(capsys):
    with pytest.raises(SystemExit) as ended:
        main(["speed"])
    assert ended.value.code == 2
    assert "invalid choice: 'speed'" in capsys.readouterr().err


def test_documents_name_commands_that_exist():
    pages = [
        REPOSITORY / "README.md",
        *(REPOSITORY / "docs").glob("*.md"),
        PACKAGE.parent / "README.md",
    ]
    pages += (REPOSITORY / "examples").rglob("*.md")
    named = {
        name
        for page in pages
        for name in re.findall(r"rna-bench ([a-z][a-z0-9-]*)", page.read_text())
    }
    assert len(named) > 8 and named <= set(COMMANDS)
    assert not any("python benchmarks/" in page.read_text() for page in pages)


def test_no_module_imports_itself_by_way_of_others():
    files = {
        "rna_bench." + ".".join(path.relative_to(PACKAGE).with_suffix("").parts): path
        for path in PACKAGE.rglob("*.py")
    }
    graph = {name: imported(path) & set(files) for name, path in files.items()}
    assert len(list(TopologicalSorter(graph).static_order())) >= len(files)  # raises CycleError


def test_scripts_stand_in_the_package_alone():
    assert not list((REPOSITORY / "benchmarks").glob("*.py"))
    runnable = {p.name for p in PACKAGE.rglob("*.py") if "__main__" in p.read_text()}
    assert runnable == PROGRAMS
