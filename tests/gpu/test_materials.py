"""The GPU knows every material of objects as the CPU does."""

from dataclasses import replace

import numpy as np
import pytest

from rna_render.materials import Material, MeshObject
from rna_render.scene.scene_file import SceneFile
from rna_render.world.world import World
from rna_trace.bilinear import CLAMP, MIRROR
from tests.gpu.scenes import (
    assert_same_law,
    assert_same_numbers,
    made,
    of_objects,
    on_cpu,
    on_gpu,
    texture,
)
from tests.render.assets import square
from tests.render.studio import made_of

SUN = {
    "type": "directional",
    "direction": (0.4, 0.8, 1.0),
    "irradiance": (2, 2, 2),
    "angular_diameter_deg": 10,
}
SKY = {"type": "environment", "radiance": (0.5, 0.7, 1.0)}
CAMERA = {"position": (0.2, 0.4, 4.2), "look_at": (0, 0, 0), "vertical_fov_deg": 36}
MOVED = np.array([[0.8, -0.5, 0.2], [0.6, 1.1, -0.3]])


COLORS = np.random.default_rng(9).uniform(0.2, 1.0, (49, 3)).astype(np.float32)
"""Colours of the bent square's vertices."""


def in_a_row(
    meshes: list, lights: tuple = (SUN, SKY), behind: bool = False, **more: object
) -> tuple[SceneFile, World]:
    """Meshes side by side; behind: with a wall behind them."""
    middle = (len(meshes) - 1) / 2
    objects = [
        (mesh, {"translation": (1.15 * (k - middle), 0, 0), "rotation_deg": (10, 15 * (k - 1), 0)})
        for k, mesh in enumerate(meshes)
    ]
    if behind:
        wall = made(Material(base_color=(0.9, 0.3, 0.1)), Material(base_color=(0.1, 0.4, 0.8)))
        objects.append((wall, {"translation": (0, 0, -1.2), "scale": 5}))
    usual = {"camera": CAMERA, "resolution": (48, 24), "samples": 2, "max_depth": 3}
    return of_objects(objects, lights, **usual | more)


def test_coats_and_relief(device):
    coat = {"coat_f0": 0.04, "roughness": 0.5}
    scene = in_a_row(
        [
            made(
                Material(
                    **coat,
                    base_color=(0.8, 0.2, 0.2),
                    clear_coat=0.9,
                    clear_coat_roughness=0.5,
                    clear_coat_texture=texture(1, 100),
                    clear_coat_roughness_texture=texture(2, 100),
                    normal_texture=texture(3, 70, 186),
                    normal_scale=0.8,
                )
            ),
            made(
                Material(
                    **coat,
                    metallic=0.7,
                    coat_weight=0.8,
                    coat_weight_texture=texture(4),
                    metallic_roughness_texture=texture(5, 80),
                    normal_texture=texture(6, 90, 166, uv_set=1),
                ),
                has_tangents=True,
            ),
        ]
    )
    actual = on_gpu(*scene, lambda: device).channels()
    assert_same_numbers(actual, on_cpu(*scene).channels())


def test_textures_that_are_moved_and_wrapped(device):
    def material(**more: object) -> Material:
        return Material(base_color_texture=texture(7, is_srgb=True, **more))

    scene = in_a_row(
        [
            made(material(wrap=(CLAMP, MIRROR), transform=MOVED), material(transform=MOVED)),
            made(material(uv_set=1, wrap=(MIRROR, CLAMP)), material(uv_set=1), colors=COLORS),
        ]
    )
    actual = on_gpu(*scene, lambda: device).channels()
    assert_same_numbers(actual, on_cpu(*scene).channels())


def test_objects_that_emit_light(device):
    """They are sampled, as their small textured spots need, and met by rays."""
    glow = {"base_color": (0.2, 0.2, 0.2), "emission_texture": texture(8, uv_set=1)}
    shining = made(Material(**glow, emission=(4, 3, 2)), Material(), Material())
    floor = made(Material(coat_f0=0.04, roughness=0.3))
    scene = in_a_row([shining, floor], lights=(), behind=True)
    actual = on_gpu(*scene, lambda: device).channels()
    assert_same_numbers(actual, on_cpu(*scene).channels())


def through(kind: str) -> list:
    if kind == "coverage":
        half = Material(opacity=0.6, opacity_texture=texture(9, 60), emission=(0.3, 0.2, 0.1))
        mask = texture(10, transform=MOVED)
        cut = Material(base_color=(0.9, 0.9, 0.2), opacity_texture=mask, cutoff=0.5)
        return [made(half), made(cut)]
    glass = Material(
        base_color=(0.3, 0.9, 0.5),
        coat_f0=0.04,
        roughness=0.05,
        transmission=0.9,
        transmission_texture=texture(11, 120, uv_set=1),
    )
    return [made(glass), made(Material(coat_f0=0.1, roughness=0.05, transmission=1.0))]


@pytest.mark.parametrize("kind", ["coverage", "glass"])
def test_what_lets_light_through(kind, device):
    """Rays pass at random, by numbers of their own; shadows are weakened."""
    scene, world = in_a_row(through(kind), behind=True, samples=16)
    actual = on_gpu(scene, world, lambda: device).channels()
    assert_same_law(actual, on_cpu(scene.with_changes(seed=7), world).channels())


def on_a_floor(pane: MeshObject, lights: tuple = (SUN,), **more: object) -> tuple:
    """A pane above a floor; the camera, below it, sees the floor alone."""
    flat = {"rotation_deg": (-90, 0, 0)}
    objects = [
        (pane, flat | {"translation": (0, 0.9, 0), "scale": 1.5}),
        (made_of(square(3.0)), {}),
    ]
    camera = {"position": (0.0, 0.7, 1.3), "look_at": (0, 0, 0), "vertical_fov_deg": 45}
    usual = {"camera": camera, "resolution": (32, 24), "samples": 2, "max_depth": 1}
    return of_objects(objects, lights, **usual | more)


@pytest.mark.parametrize("kind", ["coverage", "glass"])
def test_shadows_of_what_lets_light_through(kind, device):
    """Nothing is at random here."""
    above = SUN | {"direction": (0.1, 1.0, 0.3)}
    for pane in through(kind):
        dull = made(*(replace(m, emission=(0.0, 0.0, 0.0)) for m in pane.materials))
        scene = on_a_floor(dull, (above,))
        actual, expected = on_gpu(*scene, lambda: device).channels(), on_cpu(*scene).channels()
        assert_same_numbers(actual, expected)
        assert np.unique(expected["R"].round(1)).size > 3


def test_what_shines_in_part_lights_in_part(device):
    half = made(Material(opacity=0.5, emission=(3, 2, 1), base_color=(0, 0, 0)))
    scene, world = on_a_floor(half, (), samples=32)
    actual = on_gpu(scene, world, lambda: device).channels()
    assert_same_law(actual, on_cpu(scene.with_changes(seed=7), world).channels())
