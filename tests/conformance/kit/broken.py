"""The corpus of broken packages as files, as far as they are small."""

from __future__ import annotations

from pathlib import Path

from rna_sdk.package.issues import Code, Severity
from tests.package.corpus.every import CASES
from tests.package.corpus.registry import good_entries

LARGEST = 48 * 1024
"""Larger cases (a decoder of 64 MiB, a manifest of 1 MiB) stay with the unit tests."""


def broken_packages(folder: Path) -> dict[str, tuple[bytes, str, bool]]:
    """Name -> its bytes, the code that it gets, whether it is valid all the same (a warning).

    folder: for files on the way.
    """
    good, result = good_entries(folder), {}
    for case in CASES:
        data = case.breaker(good[case.base])
        if len(data) <= LARGEST:
            is_valid = Code[case.code].severity is Severity.WARNING
            result[case.name] = data, case.code, is_valid
    return result
