"""Finds the Python of the SDK's environment, which runs all of its commands."""

import os
import shutil
from pathlib import Path

import bpy

VARIABLE = "RNA_SDK_PYTHON"
SOURCE = Path(__file__).parent / "sdk"
"""The SDK as the extension brings it, for an environment of its own."""
DONE = "installed"
"""File in that environment with the installed version; it exists after pip's end."""


class SdkError(Exception):
    """The SDK's environment is missing, or a command in it failed."""


def find_python():
    """The interpreter: the preference's, the variable's, our environment's, or `rna-run`'s.

    Raises SdkError, which says how to get one.
    """
    named = preferences().sdk_python or os.environ.get(VARIABLE)
    if named:
        python = Path(bpy.path.abspath(named))
        if not python.is_file():
            raise SdkError(f"no Python of the RNA SDK: {python} is missing")
        return python
    if is_set_up():
        return python_in(default_folder())
    command = shutil.which("rna-run")
    if command and python_in(Path(command).parent.parent).is_file():
        return python_in(Path(command).parent.parent)
    raise SdkError(
        "the RNA SDK is not installed: press Set Up in the preferences of this extension, or name "
        "its Python there"
    )


def preferences():
    """The extension's preferences."""
    return bpy.context.preferences.addons[__package__].preferences


def default_folder():
    """Default folder of the SDK's environment."""
    # As rna_sdk.files.owned_folder.cache_folder, which is not installed yet.
    named = Path(os.environ.get("XDG_CACHE_HOME", ""))
    return (named if named.is_absolute() else Path.home() / ".cache") / "rna-sdk" / "sdk"


def is_set_up():
    """Whether that environment is whole and of this version of the extension."""
    done = default_folder() / DONE
    return done.is_file() and done.read_text() == version()


def version():
    """Digest of the files of the bundled SDK; empty if none is bundled."""
    path = SOURCE / "version"
    return path.read_text() if path.is_file() else ""


def python_in(folder):
    """Path of the interpreter in a virtual environment, which need not exist."""
    return folder / "Scripts" / "python.exe" if os.name == "nt" else folder / "bin" / "python"
