"""Pages that import the packed rna-three, in headless Chromium."""

import os
import shutil
import subprocess
import tarfile
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import pytest

from tests.render.chromium import SOFTWARE_GPU, Page, open_page
from tests.web.pages import TIMEOUT, served_folder

REPOSITORY = Path(__file__).parents[3]
TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
TINY = REPOSITORY / "spec" / "conformance" / "packages" / "surface-tiny.rna"
PAGE = Path(__file__).parent / "page.html"
"""Has the module, a renderer and what takes pictures, as `test`."""
MODULES = REPOSITORY / "runtime" / "web" / "node_modules"
THREE = Path(os.environ.get("RNA_THREE", MODULES / "three"))
"""The release of three.js that pages have; scripts/web-threes names others."""


_TARBALLS = tempfile.TemporaryDirectory(prefix="rna-npm-")


@cache
def packed(name: str) -> Path:
    """The tarball of an npm package of ours, packed once; do not change it."""
    if shutil.which("npm") is None:
        pytest.skip("no Node; on Debian: apt-get install nodejs npm")
    script = REPOSITORY / "scripts" / "npm-package"
    command = [script, name, _TARBALLS.name]
    subprocess.run(command, check=True, capture_output=True, timeout=300)
    (tarball,) = Path(_TARBALLS.name).glob(f"{name}-*.tgz")
    return tarball


def installed(folder: Path, three: Path = THREE) -> Path:
    """The packed package and a release of three.js below `folder`/node_modules; the tarball."""
    tarball = packed("rna-three")
    modules = folder / "node_modules"
    modules.mkdir()
    with tarfile.open(tarball) as archive:
        archive.extractall(modules, filter="data")
    (modules / "package").rename(modules / "rna-three")
    (modules / "three").symlink_to(three)
    return tarball


@contextmanager
def opened(
    folder: Path, name: str, width: int = 96, height: int = 60, begin: str = ""
) -> Iterator[Page]:
    """A page of the folder, served and loaded. begin: JavaScript that runs before its scripts."""
    with (
        served_folder(folder) as url,
        open_page(width, height, SOFTWARE_GPU) as page,
    ):
        page.call("Page.enable")
        page.call("Page.addScriptToEvaluateOnNewDocument", source=begin)
        page.call("Page.navigate", url=url + name)
        page.wait_for("document.readyState === 'complete'", TIMEOUT)
        yield page
