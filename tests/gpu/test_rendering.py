"""The GPU renders what the CPU renders; and what it does about losses and limits."""

from __future__ import annotations

import re
from collections.abc import Callable
from importlib.metadata import EntryPoint
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from rna_gpu import Device, GpuError, open_device, rendering
from rna_gpu.rendering import GpuRenderer
from rna_render import cli, devices
from rna_render.film import Film
from rna_render.images import write_exr
from rna_render.render import load_world, make_integrator, render
from rna_render.scene_file import SceneFile, read_scene
from rna_render.world import World
from tests.conformance.conftest import KIT
from tests.conftest import REPOSITORY

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
BALL = REPOSITORY / "examples" / "fibers" / "curly_ball.rna"

EVERYTHING = f"""
assets:
  - path: {TOY}
    transform: {{translation: [-0.6, 0, 0.2], rotation_deg: [0, 20, 0]}}
  - path: {BALL}
    transform: {{translation: [0.7, 0.35, -0.2], scale: 0.9}}
  - path: {TOY}
    transform: {{translation: [-0.3, 0, -0.9], scale: 1.3}}
ground:
  material: {{type: coated, color: [0.5, 0.3, 0.2], roughness: 0.25}}
camera: {{position: [0.2, 1.1, 2.6], look_at: [0.1, 0.25, -0.1], vertical_fov_deg: 36}}
lights:
  - {{type: directional, direction: [0.5, 0.9, 0.3], irradiance: [1.5, 1.4, 1.2],
      angular_diameter_deg: 5, group: sun}}
  - {{type: rectangle, position: [-1.2, 1, 0.9], look_at: [0, 0.2, 0], size: [0.6, 0.4],
      radiance: [6, 5, 4], group: lamps}}
  - {{type: disk, position: [1.4, 0.9, 0.3], look_at: [0.5, 0.3, 0], radius: 0.25,
      radiance: [3, 5, 9], group: lamps}}
  - {{type: sphere, position: [0.15, 0.35, 0.55], radius: 0.07, radiance: [10, 10, 4]}}
resolution: [40, 28]
samples: 2
max_depth: 3
"""

UNDER_A_SKY = f"""
assets:
  - path: {TOY}
ground:
  material: {{type: diffuse, color: [0.5, 0.6, 0.7]}}
camera: {{position: [1.4, 0.8, 0.8], look_at: [0.4, 0.15, -0.15], vertical_fov_deg: 30}}
lights:
  - {{type: environment, path: sky.exr, rotation_deg: 30}}
  - {{type: spot, position: [1, 1.5, 1], look_at: [0.4, 0, 0], intensity: [1, 0.8, 0.6]}}
  - {{type: directional, direction: [0.2, 1, 0.1], irradiance: [0.4, 0.4, 0.4]}}
resolution: [32, 24]
samples: 16
max_depth: 3
clamp_indirect: 2
"""


@pytest.fixture
def scene(tmp_path: Path) -> Callable[..., tuple[SceneFile, World]]:
    def read(text: str, **changes: object) -> tuple[SceneFile, World]:
        (tmp_path / "scene.yaml").write_text(text)
        scene_file = read_scene(tmp_path / "scene.yaml").with_changes(**changes)
        return scene_file, load_world(scene_file)

    return read


def on_gpu(
    scene_file: SceneFile,
    world: World,
    open_it: Callable[[], Device],
    stop: Callable[[], bool] = lambda: False,
) -> Film:
    renderer = GpuRenderer(scene_file, world, open_it=open_it)
    return render(scene_file.scene, renderer, stop)


def on_cpu(scene_file: SceneFile, world: World) -> Film:
    integrator = make_integrator(scene_file.scene, world, resolve=scene_file.resolve)
    return render(scene_file.scene, integrator)


RELIEF = f"""
assets:
  - path: {KIT / "packages" / "surface-relief.rna"}
ground:
  material: {{type: shadow_catcher}}
objects:
  - path: quad.obj
    transform: {{translation: [-1.5, 0.5, 0]}}
    material: {{type: diffuse, texture: squares.png}}
camera: {{position: [0.4, 1.6, 3], look_at: [-0.3, 0.2, 0], vertical_fov_deg: 40}}
lights:
  - {{type: environment, radiance: [0.5, 0.6, 0.7]}}
  - {{type: directional, direction: [0.2, 0.9, 0.3], irradiance: [1.3, 1.3, 1.3]}}
resolution: [32, 24]
samples: 2
max_depth: 2
"""


GLOW = f"""
assets:
  - path: {KIT / "packages" / "surface-glow.rna"}
    emission: 2
camera: {{position: [1.4, 1.6, 2.6], look_at: [0, 0.2, 0], vertical_fov_deg: 30}}
lights:
  - {{type: point, position: [1, 2, 1], intensity: [1, 1, 1]}}
resolution: [32, 24]
samples: 2
max_depth: 2
"""


def objects(folder: Path) -> None:
    """quad.obj and squares.png."""
    corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 2 0\nvt 2 2\nvt 0 2\n"
    (folder / "quad.obj").write_text(corners + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n")
    squares = np.kron([[0, 1], [1, 0]], np.ones((4, 4)))[..., None] * [200, 90, 30] + 20
    Image.fromarray(squares.astype(np.uint8)).save(folder / "squares.png")


@pytest.mark.parametrize("text", [EVERYTHING, RELIEF, GLOW], ids=["everything", "relief", "glow"])
def test_the_image_of_the_cpu_with_the_same_numbers(
    text: str, scene: Callable[..., tuple[SceneFile, World]], device: Device, tmp_path: Path
) -> None:
    objects(tmp_path)
    scene_file, world = scene(text)
    found = on_gpu(scene_file, world, lambda: device).channels()
    expected = on_cpu(scene_file, world).channels()
    assert found.keys() == expected.keys() and found["R"].max() > 0.1
    for name, values in expected.items():
        close = np.isclose(found[name], values, rtol=1e-2, atol=1e-3)
        assert close.mean() > 0.985, name


def sky(path: Path) -> None:
    y, x = np.mgrid[0:16, 0:32] / np.array([16, 32])[:, None, None]
    texels = np.stack([0.2 + x, 0.3 + y, 1.2 - y], axis=-1).astype(np.float32)
    texels[3, 20] = 60.0
    write_exr(path, {c: np.ascontiguousarray(texels[..., k]) for k, c in enumerate("RGB")}, {})


def test_the_image_of_the_cpu_with_other_numbers(
    scene: Callable[..., tuple[SceneFile, World]], device: Device, tmp_path: Path
) -> None:
    sky(tmp_path / "sky.exr")
    found = on_gpu(*scene(UNDER_A_SKY), lambda: device).channels()
    expected = on_cpu(*scene(UNDER_A_SKY, seed=7)).channels()
    tiles = welch(found, expected, 8)
    assert np.abs(tiles).max() < 4.5 and np.mean(tiles**2) < 2.0
    assert np.allclose(found["A"].mean(), expected["A"].mean(), atol=0.01)
    darker = {name: values * 0.7 for name, values in found.items()}
    assert np.mean(welch(darker, expected, 8) ** 2) > 4.0  # less light is seen


def welch(a: dict[str, np.ndarray], b: dict[str, np.ndarray], side: int) -> np.ndarray:
    """Differences of the tiles' means over their standard error."""
    result = []
    for colour in "RGB":

        def tiled(values: np.ndarray) -> np.ndarray:
            shape = values.shape[0] // side, side, values.shape[1] // side, side
            return values.astype(np.float64).reshape(shape).sum(axis=(1, 3))

        variance = tiled(a[f"variance.{colour}"]) + tiled(b[f"variance.{colour}"])
        result.append((tiled(a[colour]) - tiled(b[colour])) / np.sqrt(variance + 1e-12))
    return np.stack(result)


def test_a_lost_device_is_replaced(
    scene: Callable[..., tuple[SceneFile, World]], capsys: pytest.CaptureFixture[str]
) -> None:
    scene_file, world = scene(EVERYTHING, resolution=(16, 12), samples=3)
    opened: list[Device] = []
    asked = 0

    def open_it() -> Device:
        opened.append(open_device())
        return opened[-1]

    def stop() -> bool:
        nonlocal asked
        asked += 1
        if asked == 3:  # a sample is done, and the next one begins
            opened[0].wgpu.destroy()
        return False

    found = on_gpu(scene_file, world, open_it, stop)
    assert len(opened) == 2 and found.samples == 3
    assert "going on with sample 2" in capsys.readouterr().err
    whole = on_gpu(scene_file, world, open_device)
    assert np.array_equal(found.channels()["R"], whole.channels()["R"])


def test_a_device_that_stays_lost(
    scene: Callable[..., tuple[SceneFile, World]], device: Device, monkeypatch: pytest.MonkeyPatch
) -> None:
    def lost(*arguments: object) -> None:
        raise rendering.DeviceLostError("llvmpipe: Parent device is lost")

    monkeypatch.setattr(rendering, "_sample", lost)
    monkeypatch.setattr(rendering, "_on_gpu", lambda *arguments: SimpleNamespace(groups=()))
    scene_file, world = scene(EVERYTHING, resolution=(4, 4))
    with pytest.raises(rendering.DeviceLostError, match="llvmpipe: Parent device is lost"):
        on_gpu(scene_file, world, lambda: device)


REFUSED = {
    "quality: {seconds: 3}": "quality.seconds is not supported with --device gpu",
    "ground: {material: {type: diffuse, emission: [1, 1, 1]}}": "a material that emits light is",
}


@pytest.mark.parametrize("key", REFUSED)
def test_what_it_does_not_know_is_refused(
    key: str, scene: Callable[..., tuple[SceneFile, World]], device: Device
) -> None:
    text = f"assets: [{{path: {TOY}}}]\ncamera: {{position: [2, 1, 2], look_at: [0, 0, 0]}}\n{key}"
    with pytest.raises(GpuError, match=re.escape(REFUSED[key])):
        on_gpu(*scene(text, resolution=(4, 4), samples=1), lambda: device)


def test_the_command(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    offered = EntryPoint("gpu", "rna_gpu.rendering:GpuRenderer", devices.GROUP)
    broken = EntryPoint("tpu", "rna_tpu.rendering:GpuRenderer", devices.GROUP)
    monkeypatch.setattr(devices, "entry_points", lambda group: [offered, broken])
    (tmp_path / "scene.yaml").write_text(EVERYTHING)
    out = tmp_path / "out.exr"
    usual = [str(tmp_path / "scene.yaml"), "--out", str(out), "--resolution", "8x6"]
    assert cli.main([*usual, "--samples", "1", "--device", "gpu"]) == 0 and out.is_file()
    assert "wrote" in capsys.readouterr().out
    assert cli.main([*usual, "--device", "moon"]) == 1
    assert "--device moon: no such device; there are: cpu, gpu, tpu" in capsys.readouterr().err
    assert cli.main([*usual, "--device", "tpu"]) == 1
    assert "rna_tpu is not installed; try: pip install 'rna-sdk[tpu]'" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        cli.main([*usual[:1], "--preview", "--device", "gpu"])
    assert "--preview is not for --device gpu" in capsys.readouterr().err
