"""A page as a folder that any static web server can serve."""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path

from rna_view.errors import ViewError
from rna_view.site_files import VIEWER_FILES, Site, viewer_file

SERVE_NOTE = (
    "serve the folder over HTTPS, or on this machine: a page opened as a file cannot load the "
    "asset, and plain HTTP from another machine has no WebGPU"
)


def export_site(site: Site, folder: Path) -> list[Path]:
    """Write the page; returns the files. A folder of an earlier export is written over.

    Raises:
        ViewError: the folder holds something else, or cannot be written.
    """
    if folder.exists() and not folder.is_dir():
        raise ViewError(f"{folder}: expected a folder")
    if folder.is_dir() and any(folder.iterdir()) and not (folder / "viewer.js").is_file():
        raise ViewError(f"{folder}: the folder holds other files; expected a new or empty one")
    contents = {name: viewer_file(name) for name in VIEWER_FILES} | site.contents
    contents["index.html"] = site.index()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        return [_write(folder / name, content) for name, content in contents.items()]
    except OSError as error:
        raise ViewError(f"{folder}: {error.strerror}") from error


def _write(path: Path, content: Path | bytes) -> Path:
    """Under a temporary name first, so that a page is never half of one."""
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "wb") as file:
            if isinstance(content, bytes):
                file.write(content)
            else:
                with content.open("rb") as source:
                    shutil.copyfileobj(source, file)
        os.chmod(temporary, 0o644)
        os.replace(temporary, path)
    except BaseException:
        Path(temporary).unlink(missing_ok=True)
        raise
    return path
