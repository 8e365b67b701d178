"""The GPU renders what the CPU renders; and what it does about losses and limits."""

import numpy as np
import pytest

from rna_gpu import Device, open_device
from rna_gpu.scene import rendering
from rna_render.image.film import Layers
from rna_render.paths.sampling import BRANCHES
from tests.gpu.scenes import assert_same_law, assert_same_numbers, on_cpu, on_gpu
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package
from tests.render.whole_scenes import EVERYTHING, GLOW, RELIEF, TOY, UNDER_A_SKY, write_files
from tests.web.glass_files import write_ball

GLASS = f"""
assets: [{{path: {TOY}}}]
objects:
  - {{path: ball.glb, transform: {{translation: [0.4, 0.2, -0.2]}}}}
  - {{path: ball.glb, transform: {{translation: [1.1, 0.3, 0.3], scale: 0.4}}}}
ground: {{height: -0.45}}
camera: {{position: [2, 0.9, 1.2], look_at: [0.5, 0.2, 0], vertical_fov_deg: 40}}
lights:
  - {{type: environment, path: sky.exr, visible_to_camera: false}}
  - {{type: sphere, position: [0.3, 2, 0.6], radius: 0.4, radiance: [9, 9, 7]}}
resolution: [32, 24]
samples: 4
max_depth: 3
"""

LENS = f"""
assets:
  - {{path: {TOY}}}
  - {{path: {TOY}, transform: {{translation: [-1.5, 0, -2.5]}}}}
ground: {{height: -0.45}}
camera: {{position: [0.3, 0.5, 2], look_at: [0, 0, 0], vertical_fov_deg: 60 LENS}}
lights:
  - {{type: sphere, position: [0.3, 2, 0.6], radius: 0.4, radiance: [9, 9, 7]}}
resolution: [32, 24]
samples: 4
max_depth: 2
"""

IN_A_BALL = """
assets: [{path: ball.rna}]
ground: {}
camera: {position: [0.1, 0.3, 0.1], look_at: [0.2, 0, 0.1], vertical_fov_deg: 20}
lights: [{type: directional, direction: [0, 1, 0], irradiance: [2, 2, 2]}]
resolution: [16, 12]
samples: 4
"""


@pytest.mark.parametrize("text", [EVERYTHING, RELIEF, GLOW], ids=["everything", "relief", "glow"])
def test_the_image_of_the_cpu_with_the_same_numbers(
    text,
    scene,
    device,
    tmp_path,
    monkeypatch,
):
    # The GPU has as many rays from strands as from surfaces.
    monkeypatch.setattr("rna_render.paths.integrator.STRAND_BRANCHES", BRANCHES)
    write_files(tmp_path)
    scene_file, world = scene(text)
    actual = on_gpu(scene_file, world, lambda: device).channels()
    assert_same_numbers(actual, on_cpu(scene_file, world).channels())


def test_the_inside_of_a_solid_is_black_to_scattered_rays(scene, device, tmp_path):
    write_lambert_package(tmp_path / "ball.rna", sphere(3))
    scene_file, world = scene(IN_A_BALL)
    for channels in (
        on_gpu(scene_file, world, lambda: device).channels(),
        on_cpu(scene_file, world).channels(),
    ):
        assert (channels["R"] == 0).all() and (channels["A"] == 1).all()


def test_solid_glass_before_and_about_an_asset(scene, device, tmp_path):
    write_files(tmp_path)
    write_ball(tmp_path / "ball.glb", radius=0.6)
    scene_file, world = scene(GLASS)
    actual = on_gpu(scene_file, world, lambda: device).channels()
    assert_same_numbers(actual, on_cpu(scene_file, world).channels())


def test_a_lens_blurs_as_on_the_cpu(scene, device, tmp_path):
    """The same numbers choose the place on the lens: an asset in focus, another that is not."""
    write_files(tmp_path)
    scene_file, world = scene(LENS.replace(" LENS", ", aperture: 0.3, focus: 1.7"))
    actual = on_gpu(scene_file, world, lambda: device).channels()
    assert_same_numbers(actual, on_cpu(scene_file, world).channels())
    pinhole = on_gpu(*scene(LENS.replace(" LENS", "")), lambda: device).channels()
    with pytest.raises(AssertionError):
        assert_same_numbers(actual, pinhole)


def test_without_an_aperture_no_bit_changes(scene, device):
    expected = on_gpu(*scene(LENS.replace(" LENS", "")), lambda: device).channels()
    closed = LENS.replace(" LENS", ", aperture: 0, focus: 1")
    actual = on_gpu(*scene(closed), lambda: device).channels()
    for name, plane in expected.items():
        np.testing.assert_array_equal(actual[name], plane, err_msg=name)


def test_the_image_of_the_cpu_with_other_numbers(scene, device, tmp_path):
    write_files(tmp_path)
    actual = on_gpu(*scene(UNDER_A_SKY), lambda: device).channels()
    expected = on_cpu(*scene(UNDER_A_SKY, seed=7)).channels()
    assert_same_law(actual, expected)


@pytest.mark.parametrize("text", [EVERYTHING, GLOW], ids=["everything", "glow"])
def test_samples_that_are_rendered_together(
    text,
    scene,
    device,
    tmp_path,
    monkeypatch,
):
    write_files(tmp_path)
    scene_file, world = scene(text, resolution=(24, 16), samples=7)
    alone = on_gpu(scene_file, world, lambda: device).channels()
    monkeypatch.setattr(rendering.GpuRenderer, "samples", 4)
    together = on_gpu(scene_file, world, lambda: device)
    assert together.samples == 7
    for name, plane in together.channels().items():
        np.testing.assert_allclose(plane, alone[name], rtol=2e-5, atol=2e-5, err_msg=name)


def test_a_lost_device_is_replaced(
    scene,
    capsys,
    monkeypatch,
):
    scene_file, world = scene(GLOW, resolution=(16, 12), samples=3)
    opened: list[Device] = []
    samples: list[range] = []
    whole = rendering.Wavefront.render

    def open_it() -> Device:
        opened.append(open_device())
        return opened[-1]

    def render(self: rendering.Wavefront, pixels: np.ndarray, some: range) -> Layers:
        samples.append(some)
        if len(samples) == 2:
            opened[0].wgpu.destroy()
        return whole(self, pixels, some)

    monkeypatch.setattr(rendering.Wavefront, "render", render)
    monkeypatch.setattr(rendering.GpuRenderer, "samples", 1)
    actual = on_gpu(scene_file, world, open_it)
    assert (
        len(opened) == 2
        and actual.samples == 3
        and [k for some in samples for k in some] == [0, 1, 1, 2]
    )
    assert "going on with sample 2" in capsys.readouterr().err
    undisturbed = on_gpu(scene_file, world, lambda: opened[1])
    assert np.array_equal(actual.channels()["R"], undisturbed.channels()["R"])


def test_a_device_that_stays_lost(scene, device, monkeypatch):
    def lost(*arguments: object) -> None:
        raise rendering.DeviceLostError("llvmpipe: Parent device is lost")

    monkeypatch.setattr(rendering.Wavefront, "render", lost)
    scene_file, world = scene(GLOW, resolution=(4, 4))
    with pytest.raises(rendering.DeviceLostError, match="llvmpipe: Parent device is lost"):
        on_gpu(scene_file, world, lambda: device)
