"""Imports among our modules: no cycles, short chains, rooms in order, small folders."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from tests.conftest import REPOSITORY
from tests.test_faces import FACES, homes

ROOTS = {"rna_sdk": ".", "rna_export": "exporters", "rna_bench": "benchmarks"} | dict.fromkeys(
    ("rna_work", "rna_trace", "rna_render", "rna_gpu", "rna_mitsuba", "rna_view"), "runtime"
)

LONGEST = 20
MOST_FILES = 20


def modules() -> dict[str, Path]:
    """Name -> file, of all packages."""
    actual = {}
    for package, folder in ROOTS.items():
        root = REPOSITORY / folder
        for path in (root / package).rglob("*.py"):
            actual[".".join(path.relative_to(root).with_suffix("").parts)] = path
    return actual


@cache
def parsed(path: Path) -> ast.Module:
    return ast.parse(path.read_text())


def statements(tree: ast.Module, late: bool) -> Iterator[ast.stmt]:
    """Imports, but not those for type checkers alone. late: those in functions, too."""
    todo: list[ast.AST] = list(tree.body)
    while todo:
        node = todo.pop()
        if isinstance(node, ast.Import | ast.ImportFrom):
            yield node
        elif isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            todo += node.orelse
        elif late or not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            todo += (n for n in ast.iter_child_nodes(node) if not isinstance(n, ast.expr))


def imports(name: str, path: Path, known: set[str], late: bool = False) -> set[str]:
    """The modules of ours that a module names in its imports. late: in functions, too."""
    actual = set()
    package = name.split(".") if path.name == "__init__.py" else name.split(".")[:-1]
    for node in statements(parsed(path), late):
        if isinstance(node, ast.Import):
            actual |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            source = ".".join([*base, *([node.module] if node.module else [])])
            inner = {f"{source}.{alias.name}" for alias in node.names}
            whole = {source} if not all(n in known for n in inner) else set()
            actual |= (inner & known) | whole
    return (actual & known) - {name}


def behind_faces(name: str, path: Path, known: set[str]) -> set[str]:
    """As `imports` with late ones, and the modules that define what it takes from lazy faces."""
    actual = imports(name, path, known, late=True)
    for node in statements(parsed(path), late=True):
        if isinstance(node, ast.ImportFrom) and node.module in FACES:
            home = homes(node.module)
            actual |= {home[alias.name] for alias in node.names if alias.name in home}
    return actual - {name}


def room(module: str) -> str:
    """Folder of rna_render that a module of it is in, or the module itself."""
    return ".".join(module.split(".")[:2])


def longest_chain(graph: dict[str, set[str]]) -> list[str]:
    """Modules, each of which imports the next."""

    @cache
    def chain(name: str) -> tuple[str, ...]:
        return (name, *max(map(chain, graph[name]), key=len, default=()))

    return list(max(map(chain, graph), key=len))


def cycle(graph: dict[str, set[str]]) -> list[str]:
    """The modules of one cycle in order; none where there is no cycle."""
    finished: set[str] = set()

    def walk(name: str, way: list[str]) -> list[str]:
        if name in way:
            return way[way.index(name) :]
        if name in finished:
            return []
        for target in sorted(graph[name]):
            if actual := walk(target, [*way, name]):
                return actual
        finished.add(name)
        return []

    return next((actual for name in sorted(graph) if (actual := walk(name, []))), [])


FILES = {name.removesuffix(".__init__"): path for name, path in modules().items()}


@cache
def whole() -> dict[str, set[str]]:
    """Name -> `behind_faces`, of all modules."""
    return {name: behind_faces(name, path, set(FILES)) for name, path in FILES.items()}


def test_there_are_none():
    assert len(whole()) > 400
    assert cycle(whole()) == []


def test_the_longest_chain_is_short():
    """A face ends a chain: an importer need not know the modules behind it."""
    longest = longest_chain({name: imports(name, path, set(FILES)) for name, path in FILES.items()})
    assert len(longest) <= LONGEST, longest


def test_rooms_of_the_renderer_have_an_order():
    """Folders of rna_render, the modules outside of which (`conformance_reader`) are above them."""
    rooms: dict[str, set[str]] = {}
    for name, targets in whole().items():
        if name.startswith("rna_render."):
            inner = {room(target) for target in targets if target.startswith("rna_render.")}
            rooms.setdefault(room(name), set()).update(inner - {room(name)})
    assert len(rooms) > 8
    assert cycle(rooms) == []


def test_folders_are_small():
    folders = Counter(path.parent for path in FILES.values())
    assert {str(path): count for path, count in folders.items() if count > MOST_FILES} == {}


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
def test_what_counts_as_an_import(text, expected, tmp_path):
    path = tmp_path / "d.py"
    path.write_text(text)
    assert imports("a.d", path, {"a", "a.b", "a.d"}) == expected


def test_imports_in_functions_make_cycles(tmp_path):
    path = tmp_path / "d.py"
    path.write_text("class C:\n    def f(self):\n        if self:\n            import a.b")
    assert imports("a.d", path, {"a.b", "a.d"}, late=True) == {"a.b"}


def test_a_cycle_is_found():
    graph = {"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": set()}
    assert cycle(graph) == ["b", "c"]


def test_the_longest_chain_is_found():
    assert longest_chain({"a": {"b", "d"}, "b": {"d"}, "c": set(), "d": set()}) == ["a", "b", "d"]


def test_what_is_behind_a_face():
    path = FILES["rna_gpu.loading"]
    assert "rna_sdk.runtime.asset" not in imports("rna_gpu.loading", path, set(FILES))
    assert "rna_sdk.package.package" in whole()["rna_gpu.loading"]
