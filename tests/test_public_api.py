"""What renderers may import of the SDK: public names, so that any other renderer has the same."""

from __future__ import annotations

import ast
import importlib

import pytest

from tests.conftest import REPOSITORY

PUBLIC = {
    "rna_sdk",
    "rna_sdk.errors",
    "rna_sdk.package",
    "rna_sdk.runtime",
    "rna_sdk.conformance.reader",
    "rna_sdk.conformance.reader_program",
}
"""Modules for everybody; of those with `__all__`, the names in it."""
OUR_TOOLS = {
    f"rna_sdk.{name}"
    for name in (
        "arrays",
        "atomic_file",
        "compiled",
        "console",
        "cpu",
        "file_kinds",
        "kernel_threads",
        "lazy_face",
        "local_server",
        "outputs",
        "owned_folder",
        "regular_file",
        "size_note",
    )
}
"""How our own commands check arrays, read, write, are compiled, threaded, talk, and serve pages."""
RENDERERS = {"rna_trace": OUR_TOOLS, "rna_render": OUR_TOOLS, "rna_mitsuba": set()}


def imports(source: str) -> list[tuple[str, str]]:
    """(module, name) of each `from module import name`; name is "" of `import module`."""
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            found += [(alias.name, "") for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module:
            found += [(node.module, alias.name) for alias in node.names]
    return found


def strangers(source: str, tools: set[str]) -> list[str]:
    """Imports of the SDK that are no public names."""
    wrong = []
    for module, name in imports(source):
        if module.split(".")[0] != "rna_sdk" or module in tools:
            continue
        names = getattr(importlib.import_module(module), "__all__", None)
        if module not in PUBLIC or (names is not None and name not in names):
            wrong.append(f"{module}: {name}")
    return wrong


@pytest.mark.parametrize("renderer", RENDERERS)
def test_renderers_import_public_names_alone(renderer: str) -> None:
    files = sorted((REPOSITORY / "runtime" / renderer).rglob("*.py"))
    found = {str(f): strangers(f.read_text(), RENDERERS[renderer]) for f in files}
    assert files and {file: names for file, names in found.items() if names} == {}


@pytest.mark.parametrize(
    "line",
    [
        "from rna_sdk.runtime.transforms import Transform",
        "from rna_sdk.package.manifest.extensions import Proxy",
        "from rna_sdk.package import Container",
        "import rna_sdk.package.manifest.manifest_model",
        "from rna_sdk.compiled import compiled",
    ],
)
def test_other_imports_are_noticed(line: str) -> None:
    assert len(strangers(line, set())) == 1
