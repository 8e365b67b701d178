"""Recognise a package whose archive another ZIP program wrote again, and take its entries out."""

import json
import os
import zipfile
from dataclasses import replace
from os import PathLike
from pathlib import Path

from rna_sdk.errors import PackageError
from rna_sdk.files.regular_file import check_regular
from rna_sdk.package.limits import MAX_DEFLATE_RATIO

_EXPECTED = "the file as it was exported, or as rna-pack writes it: readers use entries in place"


def explained(error: PackageError, path: str | PathLike[str], manifest: str) -> PackageError:
    """The error of a container; of an archive that was zipped again, an error that says so."""
    issue = error.issues[0]
    if not issue.code.startswith("ZIP_") or not (traces := _traces(path, manifest)):
        return error
    found = f"a package that a ZIP program wrote again ({', '.join(traces)})"
    return PackageError([replace(issue, found=found, expected=_EXPECTED)])


def zipped_entries(path: str | PathLike[str], manifest: str) -> list[tuple[str, bytes]] | None:
    """The manifest and the entries that it names, of a package that was zipped again.

    None where it was not, or is damaged, or holds far more than its size.
    """
    if not _traces(path, manifest):
        return None
    try:
        with zipfile.ZipFile(path) as archive:
            size = sum(entry.file_size for entry in archive.infolist())
            if size > MAX_DEFLATE_RATIO * os.path.getsize(path):
                return None
            (place,) = (n for n in archive.namelist() if f"/{n}".endswith(f"/{manifest}"))
            names = [manifest, *json.loads(archive.read(place))["entries"]]
            return [(name, archive.read(place.removesuffix(manifest) + name)) for name in names]
    except Exception:  # as for `_traces`
        return None


def _traces(path: str | PathLike[str], manifest: str) -> list[str]:
    """Signs that another program wrote this archive; none if it holds no manifest."""
    try:
        check_regular(Path(path))
        with zipfile.ZipFile(path) as archive:
            entries = archive.infolist()
    except Exception:  # whatever zipfile makes of a broken archive
        return []
    names = [entry.filename for entry in entries]
    inside = [name for name in names if name.endswith(f"/{manifest}")]
    if manifest not in names and not inside:
        return []
    traces = {
        "entries compressed": any(entry.compress_type != zipfile.ZIP_STORED for entry in entries),
        "entries in another order": names[0] != manifest and manifest in names,
        "entries in a folder": manifest not in names,
        "time stamps": any(entry.date_time != (1980, 1, 1, 0, 0, 0) for entry in entries),
    }
    return [text for text, is_so in traces.items() if is_so]
