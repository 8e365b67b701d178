"""`rna-make` with real Cycles: from a script to a package, stopped at every stage on the way.

What is not stopped runs in this process: a new one imports for longer than it works.
"""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable

import pytest

import rna_sdk.runtime
from rna_export.capture.rna_capture import main as capture
from rna_export.export.rna_export import main as export
from rna_export.make.rna_make import main as make
from rna_export.training.rna_train import main as train
from rna_sdk.package import Package
from tests.exporters.conftest import quick_exports
from tests.exporters.scenes import write_scene

__all__ = ["quick_exports"]

pytestmark = pytest.mark.blender

SCENE = """
import sys
rough = float(sys.argv[1])
add(*BALL, principled(Base_Color=(0.7, 0.2, 0.1, 1), Roughness=rough), smooth=True)
"""
LAMP = """
add(*BALL, principled(Emission_Color=(1, 0.5, 0.2, 1), Emission_Strength=3.0), smooth=True)
pane = principled(Roughness=0.4, Alpha=0.5, Base_Color=(0.2, 0.5, 0.8, 1))
add(*square(1.4, z=1.3), pane)
"""
SMALL = (
    "--workers 1 --rays 256 --samples 2 --validation-views 2 --validation-resolution 32 "
    "--validation-samples 16 --steps 160 --presets tiny small"
).split()


def command(arguments: list[object]) -> list[str]:
    return [sys.executable, "-m", "rna_export.make.rna_make", *map(str, arguments)]


def run(main: Callable[[list[str]], int], *arguments: object) -> None:
    assert main([*map(str, arguments)]) == 0


STAGES = (  # a file of the work folder that appears in each
    "rays/manifest.json",
    "rays/train/00000.safetensors",
    "runs/small/round-01/last.ckpt",
    "runs/tiny/last/best.ckpt",
)


def test_a_make_killed_in_each_of_its_stages_ends_with_a_package(tmp_path, capsys):
    """Its goal ends the rounds; where none does, see tests/exporters/test_make.py."""
    source = write_scene(tmp_path, "ball", SCENE)
    out, work = tmp_path / "ball.rna", tmp_path / "ball.make"
    options = [source, "--out", out, *SMALL, "--min-psnr", 20, "--", 0.4]
    for number, stage in enumerate(STAGES):
        with (tmp_path / f"{number}.log").open("w") as log:
            process = subprocess.Popen(
                command(options), stdout=log, stderr=log, start_new_session=True
            )
        while not list(work.glob(stage)) and process.poll() is None:
            time.sleep(0.02)
        assert process.poll() is None, f"{stage}: {(tmp_path / f'{number}.log').read_text()}"
        os.killpg(process.pid, signal.SIGKILL if number % 2 else signal.SIGINT)
        assert process.wait(timeout=60) in (-signal.SIGKILL, 130)
    run(make, *options)
    said = capsys.readouterr().out
    assert "resuming" in said and f"wrote {out}" in said and "next: rna-view" in said
    assert "goal met: PSNR of at least 20 dB" in said
    with Package.open(out) as package:
        assert [tier.name for tier in package.manifest.tiers] == ["tiny", "small"]
        psnr = [tier.validation.psnr for tier in package.manifest.tiers]
        assert min(psnr) > 20.0, psnr
    rna_sdk.runtime.load(out)


def test_a_goal_of_a_lamp_behind_glass_is_met(tmp_path, capsys):
    """Two parts, emission, and rays that pass: all go through it. With --discard no rays stay."""
    source = write_scene(tmp_path, "lamp", LAMP)
    out = tmp_path / "lamp.rna"
    options = [*SMALL[: SMALL.index("--presets")], "--presets", "tiny", "--min-psnr", 10]
    run(make, source, "--out", out, *options, "--discard", "--parts", "objects")
    assert "goal met: PSNR of at least 10 dB" in capsys.readouterr().out
    assert not (tmp_path / "lamp.make").exists()
    with Package.open(out) as package:
        (tier,) = package.manifest.tiers
        assert len(tier.parts) == 2 and tier.parts[0].emission is not None


def test_lights_and_steps_make_the_package_of_the_three_commands(tmp_path, capsys):
    """Equal bytes in every entry; measured costs differ."""
    source = write_scene(tmp_path, "ball", SCENE)
    capturing = [*SMALL[: SMALL.index("--steps")], "--lights", 16]
    steps = SMALL[SMALL.index("--steps") : SMALL.index("--presets")]
    exporting = "--precision float32 small=int8 --source ball --license CC0-1.0".split()
    made, rays, apart = (tmp_path / name for name in ("made.rna", "ball.rays", "apart.rna"))
    presets = ["--presets", "tiny", "small"]
    run(make, source, "--out", made, *capturing, *steps, *presets, *exporting, "--", 0.4)
    assert "lights used up" in capsys.readouterr().out
    runs = [tmp_path / "runs" / preset for preset in ("tiny", "small")]
    run(capture, source, "--out", rays, *capturing, "--", 0.4)
    for folder in runs:
        run(train, rays, "--preset", folder.name, *steps, "--out", folder)
    run(export, *runs, "--out", apart, *exporting)
    with Package.open(made) as one, Package.open(apart) as other:
        assert [tier.name for tier in one.manifest.tiers] == ["tiny", "small-int8"]
        assert one.manifest.entries == other.manifest.entries
        assert one.manifest.provenance == other.manifest.provenance


def test_half_a_minute_is_kept(tmp_path):
    """Steps beside rays and training may take 33 s, 3 of which are kept for the export.

    It takes 9 s on an idle machine, and longer on a slow one beside another test.
    """
    source = write_scene(tmp_path, "ball", SCENE)
    options = [source, "--out", tmp_path / "b.rna", "--minutes", 0.5, "--presets", "tiny"]
    begun = time.monotonic()
    done = subprocess.run(command([*options, "--", 0.4]), capture_output=True, text=True)
    assert done.returncode == 0 and "time is up" in done.stdout, done.stderr
    assert 0.8 * 30.0 < time.monotonic() - begun < 30.0 + 30.0
