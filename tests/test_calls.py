"""Calls say what they pass: no tuple is made only to be unpacked in a call."""

import ast
from collections.abc import Iterator

import pytest

from tests.conftest import REPOSITORY

FOLDERS = ("rna_sdk", "runtime", "exporters", "benchmarks", "examples")


def starred(source: str) -> list[str]:
    """Names `x` of calls `f(*x)` in functions that have `x = a, b`, as `line: x`."""
    functions = [n for n in ast.walk(ast.parse(source)) if isinstance(n, ast.FunctionDef)]
    return sorted({call for function in functions for call in _of_function(function)})


def _of_function(function: ast.FunctionDef) -> Iterator[str]:
    tuples = {name for node in ast.walk(function) for name in _tuples(node)}
    for call in ast.walk(function):
        for value in call.args if isinstance(call, ast.Call) else ():
            if isinstance(value, ast.Starred) and isinstance(value.value, ast.Name):
                if value.value.id in tuples:
                    yield f"{call.lineno}: {value.value.id}"


def _tuples(node: ast.AST) -> Iterator[str]:
    """Names that a statement gives to tuples."""
    if not isinstance(node, ast.Assign) or not isinstance(node.value, ast.Tuple):
        return
    for target in node.targets:
        if isinstance(target, ast.Name):
            yield target.id
        elif isinstance(target, ast.Tuple):
            for name, value in zip(target.elts, node.value.elts, strict=False):
                if isinstance(name, ast.Name) and isinstance(value, ast.Tuple):
                    yield name.id


def test_no_tuple_is_made_to_be_unpacked_in_a_call():
    files = [path for folder in FOLDERS for path in (REPOSITORY / folder).rglob("*.py")]
    found = {str(path.relative_to(REPOSITORY)): starred(path.read_text()) for path in files}
    assert len(found) > 700
    assert {path: calls for path, calls in found.items() if calls} == {}


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("x = a, b\n f(*x)", ["3: x"]),
        ("x, y = (a, b), c\n f(y, *x)", ["3: x"]),
        ("x = a, b\n return x", []),
        ("x = g()\n f(*x)", []),
        ("f(*(a for a in b))", []),
    ],
)
def test_what_counts(body, expected):
    assert starred(f"def h():\n {body}") == expected
