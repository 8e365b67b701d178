"""A time limit, with a clock of the test's own."""

from pathlib import Path

import numpy as np
import pytest

from rna_render.command.rna_run import main
from rna_render.image.film import Layers
from rna_render.image.images import read_exr
from rna_render.paths import time_limit, world_in_time
from rna_render.paths.bands import in_time, render
from rna_render.paths.integrator_factory import make_integrator
from rna_render.paths.sampling import Sampler
from rna_render.paths.time_limit import seconds_a_sample
from rna_render.paths.world_in_time import load_world
from rna_render.scene.scene_file import read_scene
from tests.package.builders import make_measured_tier
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package


class Clock:
    """Time that passes only when it is told to."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.now = 100.0
        monkeypatch.setattr(time_limit.time, "perf_counter", lambda: self.now)


@pytest.mark.parametrize(
    ("seconds", "each", "count"), [(10.0, 2.0, 5), (9.9, 2.0, 4), (0.1, 2.0, 1), (1e6, 2.0, 64)]
)
def test_as_many_samples_as_fit(seconds, each, count, monkeypatch):
    clock = Clock(monkeypatch)
    done = []
    for sampler in in_time((Sampler(0, k) for k in range(64)), seconds, lambda: len(done)):
        done.append(sampler)
        clock.now += each
    assert len(done) == count
    assert clock.now - 100.0 <= max(seconds, each)


def test_a_measurement_counts_for_the_whole_image(monkeypatch):
    clock = Clock(monkeypatch)
    rendered = []

    class Slow:
        groups, at_once, band, samples = (), None, 1 << 16, 1

        def render(self, pixels: np.ndarray, sampler: Sampler) -> Layers:
            rendered.append(pixels)
            clock.now += len(pixels) * 1e-6
            return Layers.empty(len(pixels), 0, np.float32)

    count = 1_000_000
    assert seconds_a_sample(Slow(), count) == pytest.approx(1.0, rel=1e-3)
    pixels = np.concatenate(rendered)
    assert len(pixels) < 0.05 * count
    assert pixels.min() == 0 and pixels.max() == count - 1


SCENE = """\
assets: [{path: ball.rna}]
camera: {position: [0, 0, 5], look_at: [0, 0, 0]}
lights: [{type: directional, direction: [0, 0, 1], irradiance: [1, 1, 1]}]
resolution: [16, 8]
samples: 64
quality: {seconds: LIMIT}
"""


@pytest.fixture
def folder(tmp_path):
    tiers = (
        make_measured_tier("hq", 0.02, 9000),
        make_measured_tier("small", 0.04, 900),
        make_measured_tier("tiny", 0.08, 90),
    )
    write_lambert_package(tmp_path / "ball.rna", sphere(2), tiers)
    return tmp_path


def scene(folder: Path, limit: float) -> Path:
    path = folder / "scene.yaml"
    path.write_text(SCENE.replace("LIMIT", str(limit)))
    return path


@pytest.mark.parametrize(
    ("limit", "name"), [(1.7, "hq"), (1.0, "small"), (0.2, "tiny"), (0.01, "tiny")]
)
def test_cheaper_tiers_where_too_few_samples_would_fit(folder, limit, name, monkeypatch):
    """16 samples are enough; here one takes 0.1, 0.05 or 0.02 seconds."""
    seconds = {"hq": 0.1, "small": 0.05, "tiny": 0.02}
    monkeypatch.setattr(world_in_time, "make_integrator", lambda _, world, **__: world)
    monkeypatch.setattr(
        world_in_time, "seconds_a_sample", lambda world, _: seconds[world.objects[0].tier.name]
    )
    world = load_world(read_scene(scene(folder, limit)))
    assert [asset.tier.name for asset in world.objects] == [name]


def test_a_render_ends_in_time_with_whole_samples(folder, monkeypatch):
    file = read_scene(scene(folder, 10.0))
    integrator = make_integrator(file.scene, load_world(file))
    clock = Clock(monkeypatch)

    def advance(pixels: int) -> None:
        clock.now += 2.0

    assert render(file.scene, integrator, progress=advance).samples == 5


def test_the_command_says_how_many_samples_there_was_time_for(folder, capsys):
    out = folder / "out.exr"
    assert main([str(scene(folder, 1e-6)), "--out", str(out)]) == 0
    assert read_exr(out)[1]["rnaSamples"] == "1"
    output = capsys.readouterr().err
    assert "tiers of 1 assets: 1 tiny" in output
    assert "time for 1 of 64 samples" in output


def test_a_sequence_keeps_frames_that_a_limit_ended(folder, capsys):
    path = scene(folder, 1e-6)
    with path.open("a") as file:
        file.write("animation: {frames: 2, turntable: {}}\n")
    command = [str(path), "--out", str(folder / "f.%d.exr"), "--frames", "all"]
    assert main(command) == 0
    assert main(command) == 0
    assert "frame 1: is there already" in capsys.readouterr().out
