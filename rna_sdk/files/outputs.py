"""Checks of the files that a command is to write, before it spends time on them."""

import os
from collections.abc import Iterable
from pathlib import Path

from rna_sdk.errors import RnaError
from rna_sdk.files.atomic_file import check_replaceable, remove_leftovers, temporary_path


def check_outputs(outputs: Iterable[Path], inputs: Iterable[Path]) -> None:
    """Raises RnaError for an output that is an input, too, or that cannot be written."""
    there = list(inputs)
    for output in outputs:
        check_no_input(output, there)
        check_writable(output)


def check_package_name(output: Path) -> None:
    """Raises RnaError for a package to write that is not named as one."""
    if output.suffix.lower() not in (".rna", ".glb"):
        raise RnaError(f"--out: expected a name that ends with .rna or .glb, found {output}")


def check_glb_name(output: Path) -> None:
    """Raises RnaError for a binary glTF to write that is not named as one."""
    if output.suffix.lower() != ".glb":
        raise RnaError(f"--glb: expected a name that ends with .glb, found {output}")


def check_no_input(output: Path, inputs: Iterable[Path]) -> None:
    """Raises RnaError if the output is an input, by this or another name."""
    for path in inputs if output.exists() else ():
        if path.exists() and os.path.samefile(output, path):
            raise RnaError(f"{output}: is an input ({path}); expected another name to write to")


def check_outside(folder: Path, paths: Iterable[Path]) -> None:
    """Raises RnaError for a path in a folder that a command writes, and perhaps deletes."""
    for path in paths:
        if path.resolve().is_relative_to(folder.resolve()):
            raise RnaError(f"{path}: is in the work folder {folder}; expected it elsewhere")


def check_writable(path: Path) -> None:
    """Raises RnaError if no file can be written there; removes leftovers of killed processes."""
    if not path.parent.is_dir():
        raise RnaError(f"{path}: there is no folder {path.parent}: make it first")
    try:
        check_replaceable(path)
        temporary = temporary_path(path)
        temporary.touch()
        temporary.unlink()
        remove_leftovers(path.parent)
    except OSError as error:
        raise RnaError(f"{path}: cannot be written: {error.strerror}") from error
