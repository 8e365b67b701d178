"""The GPU renders what the CPU renders; and what it does about losses and limits."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rna_gpu import Device, open_device, rendering
from rna_render.film import Layers
from rna_render.images import write_exr
from rna_render.scene_file import SceneFile
from rna_render.world import World
from tests.conformance.conftest import KIT
from tests.conftest import REPOSITORY
from tests.gpu.scenes import assert_same_law, assert_same_numbers, on_cpu, on_gpu

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
    assert_same_numbers(found, on_cpu(scene_file, world).channels())


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
    assert_same_law(found, expected)


def test_a_lost_device_is_replaced(
    scene: Callable[..., tuple[SceneFile, World]],
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene_file, world = scene(GLOW, resolution=(16, 12), samples=3)
    opened: list[Device] = []
    samples: list[int] = []
    whole = rendering.Wavefront.render

    def open_it() -> Device:
        opened.append(open_device())
        return opened[-1]

    def render(self: rendering.Wavefront, pixels: np.ndarray, sample: int) -> Layers:
        samples.append(sample)
        if samples == [0, 1]:
            opened[0].wgpu.destroy()
        return whole(self, pixels, sample)

    monkeypatch.setattr(rendering.Wavefront, "render", render)
    found = on_gpu(scene_file, world, open_it)
    assert len(opened) == 2 and found.samples == 3 and samples == [0, 1, 1, 2]
    assert "going on with sample 2" in capsys.readouterr().err
    undisturbed = on_gpu(scene_file, world, lambda: opened[1])
    assert np.array_equal(found.channels()["R"], undisturbed.channels()["R"])


def test_a_device_that_stays_lost(
    scene: Callable[..., tuple[SceneFile, World]], device: Device, monkeypatch: pytest.MonkeyPatch
) -> None:
    def lost(*arguments: object) -> None:
        raise rendering.DeviceLostError("llvmpipe: Parent device is lost")

    monkeypatch.setattr(rendering.Wavefront, "render", lost)
    scene_file, world = scene(GLOW, resolution=(4, 4))
    with pytest.raises(rendering.DeviceLostError, match="llvmpipe: Parent device is lost"):
        on_gpu(scene_file, world, lambda: device)
