"""Compares the files of a dataset with its manifest's plan, and with the captures' records."""

import json
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

from pydantic import TypeAdapter, ValidationError

from rna_export.capture.capture_tasks import all_tasks
from rna_export.capture.dataset.dataset_folder import FOLDERS, Dataset
from rna_sdk.errors import CaptureError
from rna_sdk.files.atomic_file import write_atomically
from rna_work.cached import content_hash

_RECORD = "files.json"
_REPLACED = "replaced since the capture"
_SHOWN = 3  # names of files


def check_complete(dataset: Dataset, accepts: bool) -> None:
    """Raises CaptureError for a dataset whose files are not those that its manifest names.

    accepts: says so on stderr instead.
    """
    found = differences(dataset)
    if not found:
        return
    said = f"{dataset.folder}: {'; '.join(found)}"
    if not accepts:
        raise CaptureError(
            f"{said}: delete the replaced files and run the same rna-capture again, or add "
            "--incomplete to use the others"
        )
    print(f"warning: {said}", file=sys.stderr)


def check_kept(dataset: Dataset) -> None:
    """Raises CaptureError for a dataset with replaced files, before a capture goes on with it.

    The capture makes again what is missing.
    """
    groups, total = _groups(dataset)
    if names := groups[_REPLACED]:
        raise CaptureError(
            f"{dataset.folder}: {_phrase(names, total, _REPLACED)}: delete them, and the same "
            "command captures them again"
        )


def differences(dataset: Dataset) -> list[str]:
    """Uncaptured, missing and replaced files, a phrase each with numbers and names."""
    groups, total = _groups(dataset)
    return [_phrase(names, total, what) for what, names in groups.items() if names]


def _groups(dataset: Dataset) -> tuple[dict[str, list[str]], int]:
    """Names of files by their fault, and the number of files of a whole dataset."""
    folder, recorded = dataset.folder, _recorded(dataset.folder)
    paths = (task.path(dataset) for task in all_tasks(dataset))
    planned = [path.relative_to(folder).as_posix() for path in paths]
    absent = {name for name in {*planned, *recorded} if not (folder / name).is_file()}
    groups = {
        "not captured yet": [name for name in planned if name in absent and name not in recorded],
        "missing": [name for name in recorded if name in absent],
        _REPLACED: [
            name
            for name in recorded
            if name not in absent and content_hash(folder / name) != recorded[name]
        ],
    }
    return groups, len({*planned, *recorded})


def _phrase(names: Sequence[str], total: int, what: str) -> str:
    more = ", ..." if len(names) > _SHOWN else ""
    return f"{len(names)} of {total} files are {what} ({', '.join(names[:_SHOWN])}{more})"


def record_files(dataset: Dataset) -> None:
    """Note the contents of all files that are there, once."""
    folder, recorded = dataset.folder, _recorded(dataset.folder)
    paths = [path for inner in FOLDERS for path in sorted((folder / inner).rglob("*"))]
    names = (path.relative_to(folder).as_posix() for path in paths if path.is_file())
    new = {name: content_hash(folder / name) for name in names if name not in recorded}
    if new:
        _write(folder, {**recorded, **new})


def forget(dataset: Dataset, paths: Iterable[Path]) -> None:
    """Drop the records of files that are going to be captured anew."""
    names = {path.relative_to(dataset.folder).as_posix() for path in paths}
    recorded = _recorded(dataset.folder)
    if names & recorded.keys():
        _write(dataset.folder, {k: v for k, v in recorded.items() if k not in names})


def _write(folder: Path, recorded: dict[str, str]) -> None:
    text = json.dumps(dict(sorted(recorded.items())), indent=1)
    write_atomically(folder / _RECORD, f"{text}\n".encode())


def _recorded(folder: Path) -> dict[str, str]:
    """SHA-256 by name, of the files that were there when a capture had finished."""
    path = folder / _RECORD
    try:
        return TypeAdapter(dict[str, str]).validate_json(path.read_bytes())
    except FileNotFoundError:
        return {}
    except ValidationError as error:
        raise CaptureError(f"{path}: expected SHA-256 by names of files") from error
