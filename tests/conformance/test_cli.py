"""`rna-conform`: its table, its verdicts, and what it says of readers that cannot be run."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from rna_sdk.conformance import kit
from rna_sdk.conformance import rna_conform as cli
from tests.conformance.conftest import KIT, MINIMAL

MINIMAL_COMMAND = "--", sys.executable, str(MINIMAL)


def reader(tmp_path: Path, body: str) -> tuple[str, ...]:
    """The arguments that run a Python program with this body; `call` is its arguments."""
    script = tmp_path / "reader.py"
    script.write_text(f"import sys, time\ncall = sys.argv[1:]\n{body}\n")
    return "--", sys.executable, str(script)


def test_a_table_and_a_verdict_of_the_minimal_host(capsys):
    assert cli.main(list(MINIMAL_COMMAND)) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].split()[:6] == ["level", "package", "tier", "rows", "right", "tolerances"]
    assert "FAIL" not in "".join(lines)
    for level, verdict in zip(("evaluate", "nearby"), lines[-2:], strict=True):
        count = sum(line.split()[:1] == [level] for line in lines)
        assert verdict.startswith(f"{level}: pass, {count} of {count} cases")


def shell_reader(tmp_path: Path) -> tuple[str, ...]:
    """The arguments that run a validator to which everything is valid: a shell, for its speed."""
    script = tmp_path / "reader"
    script.write_text("#!/bin/sh\nif test $1 = levels; then echo validate; exit; fi\nexit 0\n")
    script.chmod(0o755)
    return "--", str(script)


def test_a_validator_to_which_everything_is_valid_fails(tmp_path, capsys):
    assert cli.main(shell_reader(tmp_path)) == 1
    out = capsys.readouterr().out
    assert "wrong_crc" in out and "found valid, expected invalid ZIP_CRC" in out
    assert "surface-float32" not in out


def test_an_optional_extension_need_not_be_known(tmp_path, capsys):
    """Readers that warn of what they do not know, and that refuse it where it is required."""
    words = shell_reader(tmp_path)
    script = Path(words[1])
    text = script.read_text()
    for answer, others in (
        ("echo EXTENSION_UNKNOWN", True),
        ("echo EXTENSION_REQUIRED; exit 1", True),
        ("echo EXTENSION_REQUIRED", False),
    ):
        script.write_text(text.replace("exit 0", answer))
        assert cli.main(["--json", *words]) == 1
        scores = {score["package"]: score for score in json.loads(capsys.readouterr().out)}
        assert scores["coded_entry_of_no_stream"]["passed"] == others
        assert not scores["wrong_crc"]["passed"]


def test_json(tmp_path, capsys):
    assert cli.main(["--json", "--kit", str(KIT), *shell_reader(tmp_path)]) == 1
    scores = {score["package"]: score for score in json.loads(capsys.readouterr().out)}
    assert scores["surface-float32"]["passed"] and not scores["wrong_crc"]["passed"]
    assert scores["wrong_crc"]["note"] == "found valid, expected invalid ZIP_CRC"


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ("", "levels: found nothing"),
        ("print('evaluate\\nfly')", "levels: found fly"),
        ("sys.exit('no such thing')", "levels: exit status 1: no such thing"),
        ("time.sleep(60)", "levels: no answer after 1 s"),
        ("print('validate')", "--level evaluate: the reader only claims validate"),
    ],
)
def test_readers_that_cannot_be_asked(body, message, tmp_path, capsys):
    call = "--timeout", "1", "--level", "evaluate", *reader(tmp_path, body)
    assert cli.main(call) == 1
    error = capsys.readouterr().err
    assert error.startswith("error: ") and message in error and error.count("\n") == 1


def test_a_command_that_is_not_there(capsys):
    assert cli.main(["--", "./no-such-reader"]) == 1
    assert capsys.readouterr().err == (
        "error: cannot start ./no-such-reader: No such file or directory\n"
    )
    with pytest.raises(SystemExit) as usage:
        cli.main([])
    assert usage.value.code == 2 and "no COMMAND" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ("open(call[5], 'wb').write(bytes(10))", "the reader wrote 10 bytes, expected"),
        ("pass", "the reader wrote no file, expected"),
        ("print('all is lost', file=sys.stderr); sys.exit(3)", "exit status 3: all is lost"),
        (
            "n = len(open(call[4], 'rb').read()) // 64; m = len(open(call[4], 'rb').read()) // 40\n"
            "open(call[5], 'wb').write(bytes(24 * n if call[0] == 'evaluate' else 12 * m))",
            "): found 0 0 0",
        ),
        (
            "n = len(open(call[4], 'rb').read()); transport = call[0] == 'evaluate'\n"
            "n = n // 64 * 6 if transport else n // 40 * 3\n"
            "import struct; open(call[5], 'wb').write(struct.pack('<f', float('nan')) * n)",
            "found nan nan",
        ),
    ],
)
def test_wrong_answers_fail_with_a_reason(body, message, tmp_path, capsys):
    indented = body.replace("\n", "\n    ")
    program = f"if call == ['levels']: print('evaluate')\nelse:\n    {indented}"
    assert cli.main(reader(tmp_path, program)) == 1
    lines = capsys.readouterr().out.splitlines()
    failed = [line for line in lines if "FAIL: " in line]
    assert len(failed) == len(lines) - 3 and all(message in line for line in failed)
    assert lines[-1].startswith("evaluate: FAIL, 0 of ")


def test_a_kit_that_is_not_whole(folder_of_kit, capsys):
    call = ["--kit", str(folder_of_kit), *MINIMAL_COMMAND]
    assert cli.main(call) == 1
    assert "cannot read a file" in capsys.readouterr().err
    first = next(iter(json.loads((folder_of_kit / "kit.json").read_text())["files"]))
    (folder_of_kit / first).parent.mkdir()
    (folder_of_kit / first).write_bytes(b"other")
    assert cli.main(call) == 1
    assert "the kit was modified" in capsys.readouterr().err
    for text in ("[]", "nonsense", "{}"):
        (folder_of_kit / "kit.json").write_text(text)
        assert cli.main(call) == 1
        assert "kit.json: " in capsys.readouterr().err
    assert cli.main(["--kit", "/nowhere", *MINIMAL_COMMAND]) == 1
    assert "not the index of a conformance kit" in capsys.readouterr().err


def test_an_installed_sdk_asks_for_the_kit(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(kit, "__file__", str(tmp_path / "a" / "b" / "kit.py"))
    assert cli.main(list(MINIMAL_COMMAND)) == 1
    assert "pass --kit PATH" in capsys.readouterr().err


def test_help_starts_with_a_command_and_imports_little():
    code = (
        "import sys; from rna_sdk.conformance.rna_conform import main\n"
        "try: main(['--help'])\n"
        "except SystemExit: print(sorted({'numba', 'onnxruntime', 'pydantic'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "rna-conform -- ./my-reader" in done.stdout and done.stdout.endswith("[]\n")
