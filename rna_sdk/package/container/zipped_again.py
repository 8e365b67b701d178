"""Recognise a package whose archive another ZIP program wrote again."""

from __future__ import annotations

import zipfile
from dataclasses import replace
from os import PathLike

from rna_sdk.errors import PackageError

_EXPECTED = "the file as it was exported, since readers use its entries in place"


def explained(error: PackageError, path: str | PathLike[str], manifest: str) -> PackageError:
    """The error of a container, told as what it is if the archive was zipped again."""
    issue = error.issues[0]
    if not issue.code.startswith("ZIP_") or not (traces := _traces(path, manifest)):
        return error
    found = f"a package that a ZIP program wrote again ({', '.join(traces)})"
    return PackageError([replace(issue, found=found, expected=_EXPECTED)])


def _traces(path: str | PathLike[str], manifest: str) -> list[str]:
    """What shows that another program wrote this archive; none if it holds no manifest."""
    try:
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
