"""The five files of a release, made by one script and installed where nothing else of ours is."""

import json
import os
import shutil
import subprocess
import sys
import sysconfig
import tomllib
import venv
from pathlib import Path
from zipfile import ZipFile

import pytest

import rna_sdk
from tests.conftest import REPOSITORY

VERSION = rna_sdk.__version__
TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
PACKAGES = ["rna_sdk", "rna_work", "rna_trace", "rna_render", "rna_gpu", "rna_view", "rna_export"]


def _run(*command: object, folder: Path) -> str:
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    done = subprocess.run(
        [*map(str, command)],
        capture_output=True,
        text=True,
        cwd=folder,
        env=environment,
        timeout=600,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """The folder of the five files."""
    if shutil.which("npm") is None:
        pytest.skip("no Node; on Debian: apt-get install nodejs npm")
    folder = tmp_path_factory.mktemp("release")
    pip = [sys.executable, "-m", "pip"]
    index = [*pip, "download", "--quiet", "--no-deps", "--dest", str(folder / "index"), "build"]
    if subprocess.run(index, capture_output=True).returncode:
        pytest.skip("the index of Python packages does not answer")
    command = [REPOSITORY / "scripts" / "release-files", folder / "dist"]
    environment = {**os.environ, "PYTHON": sys.executable}
    subprocess.run(command, check=True, capture_output=True, env=environment, timeout=600)
    return folder / "dist"


def test_all_five_have_the_version(files):
    assert {path.name for path in files.iterdir()} == {
        f"rna_sdk-{VERSION}.tar.gz",
        f"rna_sdk-{VERSION}-py3-none-any.whl",
        f"rna-three-{VERSION}.tgz",
        f"rna-viewer-{VERSION}.tgz",
        f"rna_sdk-blender-{VERSION}.zip",
    }
    with ZipFile(files / f"rna_sdk-blender-{VERSION}.zip") as extension:
        manifest = tomllib.loads(extension.read("blender_manifest.toml").decode())
    assert manifest["version"] == VERSION
    assert f"## [{VERSION}]" in (REPOSITORY / "CHANGELOG.md").read_text()


def test_the_wheel_works_without_the_repository(files, tmp_path):
    """Dependencies are those of this environment, whose editable installation is not seen.

    scripts/release renders with it, too, which compiles kernels for minutes.
    """
    empty = tmp_path / "empty"
    venv.create(empty, symlinks=True)
    python = empty / "bin" / "python"
    wheel = files / f"rna_sdk-{VERSION}-py3-none-any.whl"
    install = ["install", "--quiet", "--no-deps", "--no-index", wheel]
    _run(sys.executable, "-m", "pip", "--python", python, *install, folder=tmp_path)
    (packages,) = empty.glob("lib/python*/site-packages")
    (packages / "dependencies.pth").write_text(sysconfig.get_path("purelib"))
    names = json.dumps(PACKAGES)
    look = f"import importlib; print(*[importlib.import_module(n).__file__ for n in {names}])"
    where = _run(python, "-c", look, folder=tmp_path).split()
    assert [Path(path).parent.parent for path in where] == [packages] * len(PACKAGES)
    _run(empty / "bin" / "rna-validate", TOY, folder=tmp_path)
    _run(empty / "bin" / "rna-view", TOY, "--export", "site", folder=tmp_path)
    assert (tmp_path / "site" / "rna-viewer.js").is_file()
    for command in ("rna-run", "rna-make", "rna-capture", "rna-train", "rna-export"):
        assert VERSION in _run(empty / "bin" / command, "--version", folder=tmp_path)


def test_the_npm_packages_are_installed_together(files, tmp_path):
    (tmp_path / "package.json").write_text('{"private": true, "type": "module"}')
    names = ("rna-three", "rna-viewer")
    packages = [files / f"{name}-{VERSION}.tgz" for name in names]
    options = ["--offline", "--legacy-peer-deps", "--no-audit", "--no-fund"]
    _run("npm", "install", *options, *packages, folder=tmp_path)
    three = REPOSITORY / "runtime" / "web" / "node_modules" / "three"
    (tmp_path / "node_modules" / "three").symlink_to(three)
    (tmp_path / "look.js").write_text(
        'import { RnaViewer } from "rna-viewer"; import { RnaLoader } from "rna-three";\n'
        "console.log(typeof RnaViewer, typeof RnaLoader);\n"
    )
    assert _run("node", "look.js", folder=tmp_path) == "function function\n"
    for name in names:
        manifest = json.loads((tmp_path / "node_modules" / name / "package.json").read_text())
        assert (manifest["version"], manifest["license"]) == (VERSION, "Apache-2.0")
