"""A capture can be stopped in any way; finished shards are kept, and the result is the same."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.blender_process.blender_env import VARIABLE
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.rna_capture import main
from tests.exporters.scenes import write_scene

pytestmark = pytest.mark.blender

SETTINGS = (
    "--lights 256 --rays 64 --samples 1 --validation-views 2 --validation-resolution 24 "
    "--validation-samples 4 --seed 3"
).split()
SHARDS = 8


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    folder = tmp_path_factory.mktemp("source")
    return write_scene(
        folder, "ball", "add(*BALL, principled(Roughness=0.3, Subsurface_Weight=0.5))"
    )


@pytest.fixture(scope="module")
def uninterrupted(source, tmp_path_factory):
    out = tmp_path_factory.mktemp("whole") / "ball.rays"
    capture(source, out, workers=2)
    return out


def arguments(source: Path, out: Path, workers: int) -> list[str]:
    return [str(source), "--out", str(out), "--workers", str(workers), *SETTINGS]


def capture(source: Path, out: Path, workers: int) -> None:
    """`rna-capture` to its end, in this process."""
    assert main(arguments(source, out, workers)) == 0


def started(
    source: Path, out: Path, workers: int, python: Path | None = None
) -> subprocess.Popen[str]:
    """`rna-capture` in a session of its own, as from a terminal; output goes to a file.

    python: Blender's interpreter; None takes the usual one.
    """
    environment = {**os.environ, **({VARIABLE: str(python)} if python else {})}
    command = [sys.executable, "-m", "rna_export.capture.rna_capture"]
    with out.with_suffix(".log").open("w") as log:
        return subprocess.Popen(
            [*command, *arguments(source, out, workers)],
            stdout=log,
            stderr=log,
            text=True,
            start_new_session=True,
            env=environment,
        )


def wait_for_shards(process: subprocess.Popen[str], out: Path, count: int) -> None:
    deadline = time.monotonic() + 60.0
    while len(list(out.glob("train/*.safetensors"))) < count:
        assert process.poll() is None, "the capture ended before it could be stopped"
        assert time.monotonic() < deadline
        time.sleep(0.02)


def state(out: Path) -> dict[str, tuple[int, bytes]]:
    """Modification time and content of every finished file."""
    return {
        str(path.relative_to(out)): (path.stat().st_mtime_ns, path.read_bytes())
        for path in sorted(out.rglob("*"))
        if path.is_file() and path.suffix != ".part" and "/.rna-" not in str(path)
    }


def children(pid: int) -> list[int]:
    return [
        int(child)
        for task in Path(f"/proc/{pid}/task").iterdir()
        for child in (task / "children").read_text().split()
    ]


def running(pid: int) -> bool:
    try:
        stat = Path(f"/proc/{pid}/stat").read_text()
    except (FileNotFoundError, ProcessLookupError):
        return False
    return stat.rsplit(")", 1)[1].split()[0] != "Z"


def test_kill_minus_9_keeps_finished_shards(source, uninterrupted, tmp_path):
    out = tmp_path / "ball.rays"
    process = started(source, out, workers=2)
    wait_for_shards(process, out, 3)
    workers = children(process.pid)
    os.kill(workers[0], signal.SIGSTOP)  # one that hangs, and reads no end of its input
    process.kill()
    process.wait()
    killed = state(out)
    finished = sum(name.startswith("train/") for name in killed)
    assert 3 <= finished < SHARDS
    deadline = time.monotonic() + 30.0
    while any(map(running, workers)):
        assert time.monotonic() < deadline, "Blender goes on after its parent is gone"
        time.sleep(0.05)

    half_written = out / "train" / f"{SHARDS - 1:05d}.safetensors.1.part"
    half_written.write_bytes(b"as kill -9 may leave it")
    capture(source, out, workers=1)
    resumed = state(out)
    assert {name: resumed[name] for name in killed} == killed
    whole = {name: data for name, (_, data) in state(uninterrupted).items()}
    assert {name: data for name, (_, data) in resumed.items()} == whole
    assert not list(out.rglob("*.part")) and not list(out.glob(".rna-scratch-*"))


def counted(python: Path, folder: Path) -> tuple[Path, Path]:
    """An interpreter that is `python`, and the file to which it adds a line at each start."""
    starts, script = folder / "starts", folder / "python"
    script.write_text(f'#!/bin/sh\necho started >> "{starts}"\nexec "{python}" "$@"\n')
    script.chmod(0o755)
    return script, starts


def test_ctrl_c_stops_soon_and_can_be_continued(source, uninterrupted, blender_python, tmp_path):
    out = tmp_path / "ball.rays"
    python, starts = counted(blender_python, tmp_path)
    process = started(source, out, workers=2, python=python)
    wait_for_shards(process, out, 2)
    before = starts.read_text()
    os.killpg(process.pid, signal.SIGINT)  # a terminal sends it to the whole group
    assert process.wait(timeout=30) == 130
    log = out.with_suffix(".log").read_text()
    assert "run the same command again" in log and "Traceback" not in log
    assert starts.read_text() == before, "Blender was started anew"
    stopped = state(out)
    assert sum(name.startswith("train/") for name in stopped) < SHARDS

    capture(source, out, workers=2)
    resumed = state(out)
    assert {name: resumed[name] for name in stopped} == stopped
    assert resumed.keys() == state(uninterrupted).keys()


def test_a_finished_capture_says_what_is_next(source, uninterrupted, capsys):
    before = state(uninterrupted)
    capture(source, uninterrupted, workers=1)
    assert state(uninterrupted) == before
    said = capsys.readouterr().out
    assert f"wrote {uninterrupted}" in said and "next: rna-train" in said


def test_what_a_capture_holds(uninterrupted):
    samples = Dataset(uninterrupted).only.training_samples()
    n = len(samples["visible"])
    assert 0.98 * 256 * 64 < n <= 256 * 64
    for name in ("normal", "wo", "wi"):
        assert np.allclose(np.linalg.norm(samples[name], axis=1), 1.0, atol=1e-5), name
    assert np.sum(samples["normal"] * samples["wo"], axis=1).min() > -0.01
    assert len(np.unique(samples["wi"], axis=0)) == 256
    assert np.isfinite(samples["radiance"]).all() and samples["radiance"].min() >= 0.0
    assert 0.2 < samples["visible"].mean() < 0.9
    dark = samples["visible"] == 0
    assert samples["radiance"][~dark].mean() > 3 * samples["radiance"][dark].mean()


def test_validation_views_are_two_independent_halves(uninterrupted):
    dataset = Dataset(uninterrupted).only
    views = dataset.validation_views()
    assert len(views) == 2
    for view in views:
        assert len(view.pixel) > 50
        assert len(np.unique(view.samples["wi"], axis=0)) == 1
        if view.samples["radiance"].any():  # from behind, an opaque ball is black
            assert not np.array_equal(view.halves[0], view.halves[1])
        assert np.allclose(view.halves.mean(axis=0), view.samples["radiance"])
    assert any(view.samples["radiance"].any() for view in views)
    lights = {tuple(view.samples["wi"][0]) for view in views}
    trained = {tuple(wi) for wi in dataset.training_samples()["wi"]}
    assert len(lights) == 2 and not lights & trained
