"""Checks of the files that a command is to write, before it spends time on them."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from rna_sdk.atomic_file import temporary_path
from rna_sdk.errors import RnaError


def check_outputs(outputs: Iterable[Path], inputs: Iterable[Path]) -> None:
    """Raises RnaError for an output that is an input, too, or that cannot be written."""
    there = [path for path in inputs if path.exists()]
    for output in outputs:
        for path in there if output.exists() else []:
            if os.path.samefile(output, path):
                raise RnaError(f"{output}: is an input ({path}); expected another name to write to")
        check_writable(output)


def check_writable(path: Path) -> None:
    """Raises RnaError if no file can be written there."""
    if path.is_dir():
        raise RnaError(f"{path}: cannot be written: it is a folder")
    temporary = temporary_path(path)
    try:
        temporary.touch()
        temporary.unlink()
    except OSError as error:
        raise RnaError(f"{path}: cannot be written: {error.strerror}") from error
