"""The extension needs Blender's Python alone, and of the SDK its public names
and the functions that write files whole, say errors in words and give stand-ins their colours."""

import ast
import sys

import pytest

from tests.conftest import REPOSITORY

EXTENSION = REPOSITORY / "exporters" / "blender_extension"
IN_BLENDER = {"bpy", "bpy_extras", "mathutils", "numpy", *sys.stdlib_module_names}
PUBLIC = {
    "rna_sdk.files.atomic_file",
    "rna_sdk.commands.error_words",
    "rna_sdk.errors",
    "rna_sdk.package",
    "rna_sdk.runtime",
    "rna_sdk.runtime.standin_colors",
}
FILES = sorted(EXTENSION.rglob("*.py"))


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(EXTENSION)))
def test_a_file_imports_what_is_there(path):
    allowed = IN_BLENDER | (PUBLIC if path.parent.name == "sdk_side" else set())
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            names = {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            names = {str(node.module)}
        else:
            continue
        assert {name if name in PUBLIC else name.partition(".")[0] for name in names} <= allowed
