"""A page as a folder that any static web server can serve."""

from __future__ import annotations

import shutil
from pathlib import Path

from rna_sdk.atomic_file import atomic_file
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
    with atomic_file(path) as temporary:
        if isinstance(content, bytes):
            temporary.write_bytes(content)
        else:
            shutil.copyfile(content, temporary)
        temporary.chmod(0o644)  # whatever the umask: a web server reads it
    return path
