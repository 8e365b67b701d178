"""`rna-capture` before Blender starts: what it refuses, and how."""

import hashlib
import sys

import pytest

from rna_export.capture.blender_process import blender_env
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.rna_capture import main
from rna_sdk.errors import CaptureError
from tests.exporters.synthetic import manifest_of
from tests.render.assets import sphere


@pytest.fixture
def source(tmp_path):
    path = tmp_path / "asset.py"
    path.write_text("pass")
    return path


@pytest.fixture
def some_python(monkeypatch):
    """An interpreter is named; it has no bpy, and nothing here gets as far as starting it."""
    monkeypatch.setenv(blender_env.VARIABLE, sys.executable)


@pytest.fixture
def begun(source, tmp_path):
    """A dataset begun from `source` with the default settings."""
    sha256 = hashlib.sha256(source.read_bytes()).hexdigest()
    manifest = manifest_of(
        CaptureSettings(lights=64), name="asset", source=source.name, source_sha256=sha256
    )
    folder = Dataset.create(tmp_path / "begun.rays", manifest, {"asset": sphere(1)}).folder
    (folder / ".rna-capture").touch()
    return folder


def refusal(capsys: pytest.CaptureFixture[str], *arguments: object) -> str:
    """The one line that the command prints before it exits with 1."""
    assert main([str(a) for a in arguments]) == 1
    error = capsys.readouterr().err
    assert error.startswith("error: ") and error.count("\n") == 1
    return error


def test_without_blender_it_says_how_to_get_it(source, tmp_path, monkeypatch, capsys):
    monkeypatch.delenv(blender_env.VARIABLE, raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "empty"))
    error = refusal(capsys, source, "--out", tmp_path / "x.rays")
    assert "rna-capture --setup-blender" in error
    assert not (tmp_path / "x.rays").exists()


def test_a_named_interpreter_that_is_not_there(source, tmp_path, monkeypatch, capsys):
    monkeypatch.setenv(blender_env.VARIABLE, "/nowhere/python")
    assert "/nowhere/python" in refusal(capsys, source, "--out", tmp_path / "x.rays")


@pytest.mark.parametrize(("name", "actual"), [("gone.blend", "no such file"), ("a.stl", "'.stl'")])
def test_a_bad_source(tmp_path, name, actual, capsys):
    if name == "a.stl":
        (tmp_path / name).write_bytes(b"")
    error = refusal(capsys, tmp_path / name, "--out", tmp_path / "x.rays")
    assert name in error and actual in error


@pytest.mark.parametrize(
    "option",
    [
        "--samples 0",
        "--rays 0",
        "--lights -1",
        "--validation-samples 1",
        "--validation-views 0",
        "--minutes 0",
        "--workers 0",
    ],
)
def test_a_number_that_makes_no_sense(option, source, tmp_path, some_python, capsys):
    with pytest.raises(SystemExit) as exit_:
        main([str(source), "--out", str(tmp_path / "x.rays"), *option.split()])
    assert exit_.value.code == 2
    assert option.split()[0] in capsys.readouterr().err
    assert not (tmp_path / "x.rays").exists()


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["a.blend"],
        ["--out", "x"],
        ["a.blend", "--out", "x", "--lights", "9", "--minutes", "1"],
        ["a.blend", "--out", "x", "--samples", "many"],
        ["a.blend", "--out", "x", "--domain", "disk"],
        ["a.blend", "--out", "x", "--domain", "sphere", "--for", "scene.yaml"],
        ["a.blend", "--out", "x", "--domain", "hemisphere", "--poses", "1,2"],
        ["a.blend", "--out", "x", "--poses", "1-12"],
        ["a.blend", "--out", "x", "--poses", "2,2"],
        ["--estimate"],
        ["a.blend", "--out", "x", "--estimate"],
    ],
)
def test_wrong_usage_exits_with_2(arguments, capsys):
    with pytest.raises(SystemExit) as exit_:
        main(arguments)
    assert exit_.value.code == 2


@pytest.mark.parametrize(
    ("option", "value"),
    [
        ("--samples", 4),
        ("--rays", 100),
        ("--domain", "hemisphere"),
        ("--seed", 9),
        ("--front", "-Z"),
        ("--rest-frame", 7),
        ("--poses", "7"),
    ],
)
def test_other_settings_are_refused_on_resume(option, value, source, begun, some_python, capsys):
    error = refusal(capsys, source, "--out", begun, option, value)
    assert option.strip("-").replace("-", "_") in error and str(value) in error


SCENE = """\
assets: [{path: asset.rna}]
camera: {position: [0, 0, 10], look_at: [0, 0, 0]}
lights: [{type: directional, direction: [1, 0, 0], irradiance: [1, 1, 1]}]
"""


def test_another_scene_is_refused_on_resume(source, begun, some_python, capsys):
    scene = source.parent / "scene.yaml"
    scene.write_text(SCENE)
    error = refusal(capsys, source, "--out", begun, "--for", scene)
    assert f"started for other view or light directions than {scene}" in error


def test_a_scene_that_is_not_one_is_refused(source, tmp_path, some_python, capsys):
    scene = tmp_path / "scene.yaml"
    scene.write_text("assets: 7")
    assert "scene.yaml:1: assets" in refusal(
        capsys, source, "--out", tmp_path / "x.rays", "--for", scene
    )
    assert not (tmp_path / "x.rays").exists()


def test_another_source_is_refused_on_resume(source, begun, some_python, capsys):
    source.write_text("pass  # changed")
    assert "another asset.py" in refusal(capsys, source, "--out", begun)


def test_other_arguments_are_refused_on_resume(source, begun, some_python, capsys):
    assert "other arguments" in refusal(capsys, source, "--out", begun, "--", "blue")


def test_an_environment_that_was_not_finished_is_not_taken(tmp_path, monkeypatch):
    monkeypatch.delenv(blender_env.VARIABLE, raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    python = blender_env.default_folder() / "bin" / "python"
    python.parent.mkdir(parents=True)
    python.symlink_to(sys.executable)  # pip was stopped before bpy was there
    with pytest.raises(CaptureError, match="--setup-blender"):
        blender_env.find_python()


def test_help_of_a_groom_needs_no_file_no_folder_and_no_blender(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv(blender_env.VARIABLE, "/nowhere/python")
    assert main([str(tmp_path / "groom.tfx"), "--", "--help"]) == 0
    text = capsys.readouterr().out
    assert "rna-capture groom.tfx --out groom.rays --" in text and "--melanin" in text


@pytest.mark.blender
@pytest.mark.parametrize(
    ("body", "status", "text"),
    [
        ("import argparse, rna_hair; argparse.ArgumentParser().parse_args()", 0, "usage: asset.py"),
        ("pass", 1, "the script has no --help of its own"),
    ],
)
def test_help_of_a_script_is_its_own(body, status, text, source, capfd):
    source.write_text(body)
    assert main([str(source), "--", "--help"]) == status
    said = capfd.readouterr()
    assert text in said.out + said.err


def test_what_takes_no_arguments_says_so(tmp_path, capsys):
    assert "nothing can follow --" in refusal(capsys, tmp_path / "a.gltf", "--", "-h")
