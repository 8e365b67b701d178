"""No module of ours imports another that imports it while it loads."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.conftest import REPOSITORY

ROOTS = {"rna_sdk": ".", "rna_export": "exporters", "rna_bench": "benchmarks"} | dict.fromkeys(
    ("rna_work", "rna_trace", "rna_render", "rna_gpu", "rna_mitsuba", "rna_view"), "runtime"
)


def modules() -> dict[str, Path]:
    """Name -> file, of all packages."""
    found = {}
    for package, folder in ROOTS.items():
        root = REPOSITORY / folder
        for path in (root / package).rglob("*.py"):
            found[".".join(path.relative_to(root).with_suffix("").parts)] = path
    return found


def loaded_with(tree: ast.Module) -> Iterator[ast.stmt]:
    """Imports that run when the module loads: not in functions, not for type checkers alone."""
    todo: list[ast.stmt] = list(tree.body)
    while todo:
        node = todo.pop()
        if isinstance(node, ast.Import | ast.ImportFrom):
            yield node
        elif isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            todo += node.orelse
        elif not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            todo += [child for child in ast.iter_child_nodes(node) if isinstance(child, ast.stmt)]


def imports(name: str, path: Path, known: set[str]) -> set[str]:
    """The modules of ours that a module names in its imports."""
    found = set()
    package = name.split(".") if path.name == "__init__.py" else name.split(".")[:-1]
    for node in loaded_with(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            source = ".".join([*base, *([node.module] if node.module else [])])
            inner = {f"{source}.{alias.name}" for alias in node.names}
            whole = {source} if not all(n in known for n in inner) else set()
            found |= (inner & known) | whole
    return (found & known) - {name}


def cycle(graph: dict[str, set[str]]) -> list[str]:
    """The modules of one cycle in order; none where there is no cycle."""
    finished: set[str] = set()

    def walk(name: str, way: list[str]) -> list[str]:
        if name in way:
            return way[way.index(name) :]
        if name in finished:
            return []
        for target in sorted(graph[name]):
            if found := walk(target, [*way, name]):
                return found
        finished.add(name)
        return []

    return next((found for name in sorted(graph) if (found := walk(name, []))), [])


def test_there_are_none() -> None:
    files = {name.removesuffix(".__init__"): path for name, path in modules().items()}
    graph = {name: imports(name, path, set(files)) for name, path in files.items()}
    assert len(graph) > 400
    assert cycle(graph) == []


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("import a.b", {"a.b"}),
        ("from a import b", {"a.b"}),
        ("from a import b, c", {"a", "a.b"}),
        ("from .b import c", {"a.b"}),
        ("try:\n    import a.b\nexcept ImportError:\n    pass", {"a.b"}),
        ("if TYPE_CHECKING:\n    import a.b", set()),
        ("def f():\n    import a.b", set()),
    ],
)
def test_what_counts_as_an_import(text: str, expected: set[str], tmp_path: Path) -> None:
    path = tmp_path / "d.py"
    path.write_text(text)
    assert imports("a.d", path, {"a", "a.b", "a.d"}) == expected


def test_a_cycle_is_found() -> None:
    graph = {"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": set()}
    assert cycle(graph) == ["b", "c"]
