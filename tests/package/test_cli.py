"""`rna-validate`: what it prints, and its exit status."""

import json

import pytest

from rna_sdk.package import Code, Issue
from rna_sdk.package.command import rna_validate as cli
from rna_sdk.package.validator import Inspection, inspect
from tests.package.corpus.content_cases import mesh_outside_the_bounds
from tests.package.corpus.manifest_cases import wrong_hash


@pytest.fixture
def broken(entries, tmp_path):
    path = tmp_path / "broken.rna"
    path.write_bytes(wrong_hash(entries))
    return path


def test_valid(tiny, capsys):
    assert cli.main([str(tiny)]) == 0
    assert capsys.readouterr().out == f"{tiny}: valid\n"


def test_parts_are_told(lantern, capsys):
    assert cli.main([str(lantern)]) == 0
    assert capsys.readouterr().out.splitlines() == [
        f"{lantern}: part body: surface, transmittance, emission",
        f"{lantern}: part tuft: fiber",
        f"{lantern}: valid",
    ]
    assert cli.main(["--json", str(lantern)]) == 0
    (report,) = json.loads(capsys.readouterr().out)
    body = {"name": "body", "kind": "surface", "transmittance": True, "emission": True}
    assert report["parts"] == [body, {"name": "tuft", "kind": "fiber"}]


def test_invalid_names_code_severity_and_pointer(tiny, broken, capsys):
    assert cli.main([str(tiny), str(broken)]) == 1
    lines = capsys.readouterr().out.splitlines()
    pointer = "/entries/features~1small.safetensors/sha256"
    assert lines[1].startswith(f"{broken}: error ENTRY_HASH at {pointer}: ")
    assert lines[2] == f"{broken}: invalid"


def test_warning_is_valid(entries, tmp_path, capsys):
    path = tmp_path / "warned.rna"
    path.write_bytes(mesh_outside_the_bounds(entries))
    assert cli.main([str(path)]) == 0
    assert "warning GEOMETRY_OUTSIDE at /parts/0/bounds" in capsys.readouterr().out


def test_json(tiny, broken, capsys):
    assert cli.main(["--json", str(tiny), str(broken)]) == 1
    first, second = json.loads(capsys.readouterr().out)
    parts = [{"name": "asset", "kind": "surface"}]
    assert first == {"file": str(tiny), "valid": True, "parts": parts, "issues": []}
    assert second["valid"] is False
    (issue,) = second["issues"]
    assert issue["code"] == "ENTRY_HASH"
    assert issue["severity"] == "error"
    assert issue["pointer_or_offset"] == "/entries/features~1small.safetensors/sha256"
    assert issue["expected"] == "0" * 64


def test_usage_error(capsys):
    with pytest.raises(SystemExit) as caught:
        cli.main([])
    assert caught.value.code == 2
    assert "FILE" in capsys.readouterr().err


@pytest.mark.parametrize("options", [[], ["--json"]])
@pytest.mark.parametrize(
    ("defect", "said"),
    [
        (RuntimeError("defect"), "internal error, RuntimeError('defect'); try --debug"),
        (MemoryError("Unable to allocate 8 TiB"), "not enough memory: Unable to allocate 8 TiB"),
        (MemoryError(), "not enough memory"),
    ],
)
def test_a_defect_takes_no_other_report_along(
    tiny,
    broken,
    options,
    defect,
    said,
    monkeypatch,
    capsys,
):
    def defect_of_one(path: str) -> Inspection:
        if path == "defect.rna":
            raise defect
        return inspect(path)

    monkeypatch.setattr(cli, "inspect", defect_of_one)
    assert cli.main([*options, str(tiny), "defect.rna", str(broken)]) == 1
    output = capsys.readouterr()
    assert output.err == f"defect.rna: {said}\n"
    if options:
        assert [report["file"] for report in json.loads(output.out)] == [str(tiny), str(broken)]
    else:
        lines = output.out.splitlines()
        assert lines[0] == f"{tiny}: valid" and lines[-1] == f"{broken}: invalid"


def test_what_is_found_is_shown_as_printable_text():
    issue = Issue.of(Code.PLANES_DTYPE, "features/a", "\ud800 \x1b[31m café\n", "F16")
    assert issue.found == r"\ud800 \x1b[31m café\n"
