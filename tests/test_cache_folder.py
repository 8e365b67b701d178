"""All caches are in one folder, that of the XDG Base Directory Specification."""

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

from rna_export.capture.blender_process import blender_env
from rna_sdk.files.owned_folder import cache_folder
from rna_sdk.runtime.engine import costs
from rna_work.cached import sources_folder
from tests.conftest import REPOSITORY


@pytest.fixture(scope="module")
def of_extension():
    """The extension runs in Blender's Python, without the SDK: it has a copy of the rule."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(sys.modules, "bpy", ModuleType("bpy"))
        path = REPOSITORY / "exporters" / "blender_extension" / "sdk.py"
        spec = importlib.util.spec_from_file_location("extension_sdk", path)
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    return module.default_folder


@pytest.mark.parametrize(
    ("named", "expected"),
    [
        ("/var/cache", "/var/cache"),
        ("", "~/.cache"),
        ("relative", "~/.cache"),
        ("./x", "~/.cache"),
        (None, "~/.cache"),
    ],
)
def test_empty_and_relative_names_are_ignored(
    named,
    expected,
    of_extension,
    tmp_path,
    monkeypatch,
):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    if named is not None:
        monkeypatch.setenv("XDG_CACHE_HOME", named)
    folder = Path(expected).expanduser() / "rna-sdk"
    assert cache_folder() == folder
    assert blender_env.default_folder().parent == folder
    assert costs._file() == folder / "costs.json"
    assert sources_folder() == folder / "sources"
    assert of_extension() == folder / "sdk"


def test_no_other_file_reads_the_variable():
    folders = ("rna_sdk", "runtime", "exporters", "benchmarks")
    files = (path for name in folders for path in (REPOSITORY / name).rglob("*.py"))
    found = {path.name for path in files if 'get("XDG_CACHE_HOME' in path.read_text("utf-8")}
    assert found == {"owned_folder.py", "sdk.py"}
