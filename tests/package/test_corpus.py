"""Every broken package is refused with its code, and every code has a broken package."""

import os
import time
import zipfile

import numpy as np
import pytest

from rna_sdk.errors import PackageError
from rna_sdk.package import Code, Package, Severity, validate
from rna_sdk.package.command import rna_pack
from rna_sdk.package.limits import MAX_FILE_BYTES
from tests.package.builders import pack, read_entries
from tests.package.corpus import container_cases, content_cases, manifest_cases
from tests.package.corpus.every import CASES
from tests.package.corpus.registry import part, tier_part

OUTSIDE_THE_CORPUS = {"FILE_UNREADABLE", "FILE_TOO_LARGE"}
"""Codes about the file itself, with tests of their own below."""

OF_CARRIERS = {code.name for code in Code if code.name.startswith("GLB_")}
"""Codes about a .glb with a package; tests/package/test_carrier.py has its broken files."""


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_broken_package_gets_its_code(case, good, tmp_path):
    path = tmp_path / f"{case.name}.rna"
    path.write_bytes(case.breaker(good[case.base]))
    issues = validate(path)
    assert [issue.code for issue in issues] == [case.code], "\n".join(map(str, issues))
    assert issues[0].found and issues[0].expected
    if issues[0].severity is Severity.ERROR:
        with pytest.raises(PackageError, match=case.code) as caught:
            Package.open(path)
        assert caught.value.issues == issues
    else:
        Package.open(path).close()


def test_every_code_has_a_case():
    assert {case.code for case in CASES} | OUTSIDE_THE_CORPUS | OF_CARRIERS == set(Code.__members__)


def test_missing_file_folder_and_device(tmp_path):
    for path, actual in (
        (tmp_path / "absent.rna", "No such file or directory"),
        (tmp_path, "a folder"),
        ("/dev/null", "a pipe or a device"),
    ):
        (issue,) = validate(path)
        assert (issue.code, issue.found) == ("FILE_UNREADABLE", actual)


def test_pipe_is_refused_and_not_waited_for(tmp_path):
    os.mkfifo(tmp_path / "pipe.rna")
    (issue,) = validate(tmp_path / "pipe.rna")
    assert (issue.code, issue.found) == ("FILE_UNREADABLE", "a pipe or a device")


def test_name_that_no_file_can_have():
    (issue,) = validate("asset\0.rna")
    assert issue.code == "FILE_UNREADABLE"


@pytest.mark.parametrize(
    ("options", "folder", "backwards", "traces"),
    [
        ({"compression": zipfile.ZIP_DEFLATED}, "", False, "entries compressed, time stamps"),
        ({}, "", True, "entries in another order, time stamps"),
        ({}, "tiny/", False, "entries in a folder, time stamps"),
    ],
)
def test_package_that_was_zipped_again_says_so(
    options, folder, backwards, traces, entries, tmp_path
):
    path = tmp_path / "again.rna"
    with zipfile.ZipFile(path, "w", **options) as archive:
        for name, data in sorted(entries.items(), reverse=not backwards, key=_is_manifest):
            archive.writestr(f"{folder}{name}", data)
    (issue,) = validate(path)
    assert issue.found == f"a package that a ZIP program wrote again ({traces})"
    assert rna_pack.main([str(path), "--out", str(tmp_path / "whole.rna")]) == 0
    assert read_entries(tmp_path / "whole.rna") == entries


def _is_manifest(entry: tuple[str, bytes]) -> bool:
    return entry[0] == "manifest.json"


def test_file_too_large_is_not_read(tmp_path):
    path = tmp_path / "sparse.rna"
    with open(path, "wb") as file:
        file.truncate(MAX_FILE_BYTES + 1)
    assert [issue.code for issue in validate(path)] == ["FILE_TOO_LARGE"]


def test_all_issues_of_a_manifest_come_at_once(entries, tmp_path):
    path = tmp_path / "many.rna"

    def edit(manifest: dict) -> None:
        manifest.pop("license")
        tier_part(manifest)["channels"] = -1
        part(manifest)["bounds"]["max"][0] = -7
        manifest["domain"]["wi"] = [{"axis": [0, 1, 0], "halfAngle": -1}]

    path.write_bytes(manifest_cases.with_manifest(entries, edit))
    actual = {(issue.code, issue.pointer_or_offset) for issue in validate(path)}
    assert actual == {
        ("FIELD_MISSING", "/license"),
        ("FIELD_VALUE", "/tiers/0/parts/0/channels"),
        ("BOUNDS_EMPTY", "/parts/0/bounds/max"),
        ("FIELD_VALUE", "/domain/wi/0/halfAngle"),
    }


def test_every_flipped_byte_of_a_header_is_noticed(entries, tmp_path):
    good = pack(entries.items())
    directory = container_cases.read_end(good).directory_offset
    path = tmp_path / "flipped.rna"
    for at in [*range(0, 64), *range(directory, len(good))]:
        path.write_bytes(good[:at] + bytes([good[at] ^ 0x41]) + good[at + 1 :])
        assert any(i.severity is Severity.ERROR for i in validate(path)), f"byte {at}"


@pytest.mark.parametrize("base", ["surface", "fiber", "parts"])
def test_random_damage_never_escapes(base, good, tmp_path):
    """Garbage inside entries whose hashes were made to fit gives issues, not exceptions."""
    entries = good[base]
    rng = np.random.default_rng(7)
    path = tmp_path / "damaged.rna"
    names = [name for name in entries if name != "manifest.json"]
    for _ in range(150):
        name = names[rng.integers(len(names))]
        data = bytearray(entries[name])
        for at in rng.integers(0, min(len(data), 900), 3):
            data[at] = rng.integers(256)
        path.write_bytes(content_cases.with_entry(entries, name, bytes(data)))
        validate(path)


def test_a_key_twice_among_very_many_is_found_at_once(entries, tmp_path):
    """In a time that grows with their number, not with its square: that took minutes."""
    keys = ",".join(f'"{i}":0' for i in [*range(90_000), 89_999])
    path = tmp_path / "keys.rna"
    path.write_bytes(manifest_cases.with_text(entries, '"extras": {}', f'"extras": {{{keys}}}'))
    start = time.process_time()
    assert [issue.code for issue in validate(path)] == ["JSON_DUPLICATE_KEY"]
    assert time.process_time() - start < 5


def test_an_archive_of_another_program_is_told_by_what_differs(tmp_path):
    path = tmp_path / "other.rna"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("a.txt", "x")
    (issue,) = validate(path)
    assert issue.code == "ZIP_HEADER"
    assert "made by 788" in issue.found and "external attributes" in issue.found
    assert "made by 20" in issue.expected and "name size" not in issue.found
