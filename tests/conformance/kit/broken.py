"""Broken packages: one for each constraint of the schemas, and what of the corpus is small."""

import io
import json
import zipfile
from dataclasses import dataclass
from pathlib import Path

from rna_sdk.package.issues import Code, Severity
from rna_sdk.package.manifest.extension_checks import KNOWN_EXTENSIONS
from rna_sdk.package.validator import validate
from tests.package.corpus.every import CASES
from tests.package.corpus.registry import good_entries
from tests.package.corpus.schema_cases import schema_cases

LARGEST = 48 * 1024
"""Larger cases (a decoder of 64 MiB, a manifest of 1 MiB) stay with the unit tests."""


@dataclass(frozen=True)
class Broken:
    """A package with the code that it gets; extension: an optional one that it uses."""

    data: bytes
    code: str
    extension: str | None

    @property
    def is_valid(self) -> bool:
        """All the same, since the code is that of a warning."""
        return Code[self.code].severity is Severity.WARNING


def broken_packages(folder: Path) -> dict[str, Broken]:
    """By name, in its order; folder: for files on the way."""
    good, result = good_entries(folder), {}
    for name, (data, _) in schema_cases(good, folder).items():
        result[name] = Broken(data, _code_of(data, folder / "broken.rna"), _extension(data))
    for case in sorted(CASES, key=lambda case: case.name):
        data = case.breaker(good[case.base])
        if len(data) <= LARGEST:
            result[case.name] = Broken(data, case.code, _extension(data))
    return result


def _code_of(data: bytes, path: Path) -> str:
    """The code of the only issue."""
    path.write_bytes(data)
    (code,) = {issue.code for issue in validate(path)}
    return code


def _extension(data: bytes) -> str | None:
    """The extension of the spec that a package uses, as far as it can be read."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            manifest = json.loads(archive.read("manifest.json"))
        return min(KNOWN_EXTENSIONS & set(manifest["extensionsUsed"]), default=None)
    except (zipfile.BadZipFile, ValueError, KeyError, TypeError, NotImplementedError, EOFError):
        return None
