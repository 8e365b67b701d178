"""The files of a dataset: named arrays as safetensors, written atomically.

Arrays are named PART/FIELD; those of one part have a row for each sample of that part.
"""

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from safetensors import SafetensorError, safe_open
from safetensors.numpy import save

from rna_export.capture.dataset.dataset_manifest import BASE_COLOR, MAX_NUMBER
from rna_sdk.errors import CaptureError
from rna_sdk.files.atomic_file import write_atomically

DAMAGED = "{}: damaged ({})"
_MADE_AGAIN = "; delete it, and the same rna-capture makes it again"


_UNIT = ("normal", "tangent", "wo", "wi", "h", BASE_COLOR)
_LARGEST = {**dict.fromkeys(_UNIT, 1.001), "visible": 255.0}
"""Magnitude of the numbers of a field, rounding included; of all others MAX_NUMBER."""


def write_parts(path: Path, parts: Mapping[str, Mapping[str, np.ndarray]]) -> None:
    """Save the samples of each part, name -> field -> rows."""
    arrays = {f"{part}/{field}": v for part, fields in parts.items() for field, v in fields.items()}
    write_arrays(path, arrays)


def read_part(path: Path, part: str, fields: Mapping[str, int]) -> dict[str, np.ndarray]:
    """The named fields of one part's samples, with their numbers of columns.

    Raises CaptureError if the file is damaged, or has arrays of another shape, or numbers that
    are not finite or larger than its field has.
    """
    try:
        with safe_open(path, "np") as file:
            there = set(file.keys())
            missing = [f"{part}/{field}" for field in fields if f"{part}/{field}" not in there]
            if missing:
                raise damaged(path, f"no {', '.join(missing)}")
            arrays = {field: file.get_tensor(f"{part}/{field}") for field in fields}
    except (OSError, TypeError, SafetensorError) as error:
        raise damaged(path, error) from error
    if len({rows.shape[:1] for rows in arrays.values()}) > 1:
        raise damaged(path, "its arrays differ in length")
    for field, rows in arrays.items():
        columns = rows.shape[1:] or (rows.ndim,)
        if rows.dtype.kind not in "fiu" or columns != (fields[field],):
            shape = f"{rows.dtype} {list(rows.shape)}"
            raise damaged(path, f"{part}/{field} is {shape}, expected {fields[field]} columns")
        largest = _LARGEST.get(field, MAX_NUMBER)
        limit = np.float32(largest)  # float16 has no such number
        usable = (rows >= -limit) & (rows <= limit)
        if not usable.all():
            bad = np.count_nonzero(~usable.reshape(len(rows), -1).all(axis=1))
            what = f"{part}/{field} are not finite numbers up to {largest:g}"
            raise damaged(path, f"{bad} rows of {what}")
    return arrays


def rows_of(path: Path, part: str, field: str) -> int:
    """Number of one part's samples, from the file's header. CaptureError if it is damaged."""
    try:
        with safe_open(path, "np") as file:
            return int(file.get_slice(f"{part}/{field}").get_shape()[0])
    except (OSError, SafetensorError) as error:
        raise damaged(path, error) from error


def check_whole(path: Path) -> None:
    """Raises CaptureError unless the file is as long as its header says."""
    try:
        with safe_open(path, "np"):
            pass
    except (OSError, SafetensorError) as error:
        raise damaged(path, error) from error


def damaged(path: Path, reason: object) -> CaptureError:
    """The error for a file that a capture can make again."""
    return CaptureError(DAMAGED.format(path, reason) + _MADE_AGAIN)


def joined(parts: list[dict[str, np.ndarray]]) -> dict[str, np.ndarray]:
    """The rows of all, one array a field."""
    return {name: np.concatenate([p[name] for p in parts]) for name in parts[0]}


def write_arrays(path: Path, arrays: Mapping[str, np.ndarray]) -> None:
    """Save as safetensors; the file is written atomically."""
    write_atomically(path, save({k: np.ascontiguousarray(v) for k, v in arrays.items()}))
