"""A page as a folder that any static web server can serve."""

import json
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from rna_sdk.errors import ViewError
from rna_sdk.files.atomic_file import atomic_file, is_temporary, remove_leftovers, write_atomically
from rna_view.site_files import SITE_NAME, Site

SERVE_NOTE = (
    "serve the folder over HTTPS, or on this machine: a page opened as a file cannot load the "
    "asset, and plain HTTP from another machine has no WebGPU"
)
EMBED = (
    '<iframe src="{address}?ui=0" title="{title}" allow="fullscreen" '
    'style="width: 100%; aspect-ratio: 16/10; border: 0"></iframe>'
)
"""A line for another page, at any width."""
ELEMENT_LINE = (
    '<script defer src="{address}rna-viewer.js"></script>'
    '<rna-viewer{attributes} alt="{title}" camera-controls></rna-viewer>'
)
"""The same without a frame: the page's own element."""
MARKER = "rna-view.json"
"""Says that a folder is an export of this command, and which of its files are the site's own."""


def export_site(site: Site, folder: Path) -> list[Path]:
    """Write the page; returns its files. Unused files of an earlier export are removed.

    So is what an export that was killed left half written. One that fails, as on a full disk,
    leaves nothing new.

    Raises:
        ViewError: the folder holds something else, or cannot be written.
    """
    if folder.exists() and not folder.is_dir():
        raise ViewError(f"{folder}: expected a folder")
    earlier = _exported(folder)
    there = folder.iterdir() if folder.is_dir() else ()
    if earlier is None and not all(map(is_temporary, there)):
        raise ViewError(
            f"{folder}: the folder holds other files; expected a new or empty one, or an earlier "
            "export"
        )
    used = set(site.contents)
    # The viewer's own files last: none of the site's takes their place.
    contents = {**site.contents, **site.pages()}
    try:
        with _all_or_nothing_new(folder):
            folder.mkdir(parents=True, exist_ok=True)
            remove_leftovers(folder)
            _mark(folder, used | (earlier or set()))
            written = [_write(folder / name, content) for name, content in contents.items()]
            for name in (earlier or set()) - used:
                (folder / name).unlink(missing_ok=True)
            return [*written, _mark(folder, used)]
    except OSError as error:
        raise ViewError(f"{folder}: {error.strerror}") from error


@contextmanager
def _all_or_nothing_new(folder: Path) -> Iterator[None]:
    """Removes the files and the folder that a block has added, if it raises."""
    was_there = folder.is_dir()
    before = {path.name for path in folder.iterdir()} if was_there else set()
    try:
        yield
    except BaseException:
        with suppress(OSError):
            for path in folder.iterdir():
                if path.name not in before:
                    path.unlink()
            if not was_there:
                folder.rmdir()
        raise


def _exported(folder: Path) -> set[str] | None:
    """Names of the site's own files in an earlier export; None if the folder is none."""
    try:
        names = json.loads((folder / MARKER).read_bytes())["files"]
        return {name for name in names if SITE_NAME.fullmatch(name)}
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None


def _mark(folder: Path, names: set[str]) -> Path:
    record = {"generator": "rna-view", "files": sorted(names)}
    write_atomically(folder / MARKER, json.dumps(record).encode())
    return folder / MARKER


def _write(path: Path, content: Path | bytes) -> Path:
    """Under a temporary name first, so that a page is never half of one."""
    with atomic_file(path) as temporary:
        if isinstance(content, bytes):
            temporary.write_bytes(content)
        else:
            shutil.copyfile(content, temporary)
        temporary.chmod(0o644)  # whatever the umask: a web server reads it
    return path
