"""Results of finished steps, which a resumed run does not make again."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from safetensors.numpy import load_file

from rna_export.capture.dataset.sample_files import write_arrays
from rna_sdk.errors import RnaError
from rna_sdk.files.atomic_file import write_atomically

Arrays = dict[str, np.ndarray]

_SETTINGS = "settings.json"


class StoredResults:
    """A folder of results that were all made with the same settings."""

    def __init__(self, folder: Path, settings: dict[str, Any], again: bool, remedy: str):
        """again: forget results of other settings.

        Raises RnaError, which names the remedy, where there is some and it is not to be forgotten.
        """
        self._folder, self._settings = folder, json.dumps(settings, indent=1).encode()
        path = folder / _SETTINGS
        earlier = json.loads(path.read_text()) if path.is_file() else None
        if earlier is not None and again:
            for made in ("*.safetensors", "*.json"):
                for result in folder.glob(made):
                    result.unlink()
        elif earlier not in (None, settings):
            differ = [k for k in settings if earlier.get(k) != settings[k]]
            differences = ", ".join(f"{k} {earlier.get(k)}, now {settings[k]}" for k in differ)
            raise RnaError(f"{folder} was made with other settings ({differences}): {remedy}")

    def arrays(self, name: str, make: Callable[[], Arrays]) -> Arrays:
        """The result of `make`, or the stored result of an earlier call."""
        path = self._folder / f"{name}.safetensors"
        if not path.is_file():
            made = make()
            self._store_settings()
            write_arrays(path, made)
        return load_file(path)

    def record(self, name: str, make: Callable[[], dict[str, Any]]) -> dict[str, Any]:
        """The result of `make`, JSON values, or the stored one."""
        path = self._folder / f"{name}.json"
        if not path.is_file():
            made = make()
            self._store_settings()
            write_atomically(path, json.dumps(made, indent=1).encode())
        return json.loads(path.read_text())

    def _store_settings(self) -> None:
        """With the first result, and not before: a folder without any takes all settings."""
        self._folder.mkdir(parents=True, exist_ok=True)
        write_atomically(self._folder / _SETTINGS, self._settings)
