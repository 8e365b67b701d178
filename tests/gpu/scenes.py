"""Scenes for the tests of the GPU renderer, rendered on both devices."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from rna_gpu import Device
from rna_gpu.scene.rendering import GpuRenderer
from rna_render.image.film import Film
from rna_render.lights import PlacedLight, make_light
from rna_render.materials import Material, MeshObject, Texture
from rna_render.materials.textures import LINEAR, SRGB
from rna_render.paths.bands import render
from rna_render.paths.integrator_factory import make_integrator
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import Scene
from rna_render.scene.transforms import world_from_object
from rna_render.world.placements import mesh_light
from rna_render.world.world import Placement, World

Channels = dict[str, np.ndarray]


def on_gpu(
    scene_file: SceneFile,
    world: World,
    open_it: Callable[[], Device],
    stop: Callable[[], bool] = lambda: False,
) -> Film:
    renderer = GpuRenderer(scene_file.resolved, world, scene_file.camera_after, open_it)
    return render(scene_file.scene, renderer, stop)


def on_cpu(scene_file: SceneFile, world: World) -> Film:
    return render(scene_file.scene, make_integrator(scene_file.resolved, world))


def welch(a: Channels, b: Channels, side: int) -> np.ndarray:
    """Differences of the tiles' means over their standard error."""
    result = []
    for colour in "RGB":

        def tiled(values: np.ndarray) -> np.ndarray:
            shape = values.shape[0] // side, side, values.shape[1] // side, side
            return values.astype(np.float64).reshape(shape).sum(axis=(1, 3))

        variance = tiled(a[f"variance.{colour}"]) + tiled(b[f"variance.{colour}"])
        result.append((tiled(a[colour]) - tiled(b[colour])) / np.sqrt(variance + 1e-12))
    return np.stack(result)


def assert_same_numbers(actual: Channels, expected: Channels) -> None:
    """Equal images up to rounding, which sends some paths elsewhere."""
    assert actual.keys() == expected.keys() and actual["R"].max() > 0.1
    for name, values in expected.items():
        assert _close(actual[name], values) > 0.985, name
    for name in "RGB":  # 3% more light is told apart
        assert _close(1.03 * actual[name], expected[name]) < 0.985, name


def _close(actual: np.ndarray, expected: np.ndarray) -> float:
    return float(np.isclose(actual, expected, rtol=1e-2, atol=1e-3).mean())


def assert_same_law(actual: Channels, expected: Channels) -> None:
    """Equal images up to noise; a darker one is told apart."""
    tiles = welch(actual, expected, 8)
    assert np.abs(tiles).max() < 4.5 and np.mean(tiles**2) < 2.0
    assert np.allclose(actual["A"].mean(), expected["A"].mean(), atol=0.01)
    darker = {name: values * 0.7 for name, values in actual.items()}
    assert np.mean(welch(darker, expected, 8) ** 2) > 3.0


def of_objects(
    scene_objects: Sequence[tuple[MeshObject, dict[str, Any]]],
    lights: Sequence[dict[str, Any]],
    **more: Any,
) -> tuple[SceneFile, World]:
    """A scene of objects that are made in place."""
    objects = [{"path": "-", "transform": transform} for _, transform in scene_objects]
    scene = Scene.model_validate({"objects": objects, "lights": lights} | more)
    matrices = [world_from_object(model.transform) for model in scene.objects]
    placements = [
        Placement(mesh, matrix, mesh_light(mesh, matrix))
        for (mesh, _), matrix in zip(scene_objects, matrices, strict=True)
    ]
    made = [make_light(model) for model in scene.lights]
    shapes = [light for light in made if isinstance(light, PlacedLight)]
    placements += [Placement(x, x.world_from_object, x, boundless=True) for x in shapes]
    return SceneFile(Path("scene.yaml"), scene, {}), World(placements)


def texels(seed: int, low: int = 0, high: int = 256) -> np.ndarray:
    """Noise, (5, 7, 3) uint8."""
    return np.random.default_rng(seed).integers(low, high, (5, 7, 3)).astype(np.uint8)


def texture(
    seed: int, low: int = 0, high: int = 256, is_srgb: bool = False, **more: Any
) -> Texture:
    return Texture(texels(seed, low, high), SRGB if is_srgb else LINEAR, **more)


def curved(cells: int = 6, **more: Any) -> dict[str, np.ndarray]:
    """A bent square about the origin that faces +Z: arrays of a MeshObject."""
    u, v = (a.ravel() for a in np.meshgrid(*[np.linspace(0, 1, cells + 1)] * 2))
    z = 0.25 * np.cos(3 * (u - 0.5)) * np.cos(2 * (v - 0.5))
    slope = (
        0.75 * np.sin(3 * (u - 0.5)) * np.cos(2 * (v - 0.5)),
        0.5 * np.cos(3 * (u - 0.5)) * np.sin(2 * (v - 0.5)),
    )
    normals = np.column_stack([*slope, np.ones_like(u)])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    first = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    quads = np.column_stack([first, first + 1, first + cells + 2, first + cells + 1])
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]).astype(np.uint32)
    tangents = np.column_stack([np.ones_like(u), 0 * u, -slope[0], np.ones_like(u)])
    tangents[:, :3] /= np.linalg.norm(tangents[:, :3], axis=1, keepdims=True)
    return {
        "positions": np.column_stack([u - 0.5, v - 0.5, z]).astype(np.float32),
        "normals": normals.astype(np.float32),
        "uvs": np.column_stack([1.7 * u - 0.4, 1.3 * (1 - v)]).astype(np.float32),
        "second_uvs": np.column_stack([v, 2 * u]).astype(np.float32),
        "tangents": tangents.astype(np.float32),
        "triangles": triangles,
    }


def made(*materials: Material, has_tangents: bool = False, **more: Any) -> MeshObject:
    """The bent square, of several materials by turns."""
    arrays = curved()
    if not has_tangents:
        del arrays["tangents"]
    numbers = np.arange(len(arrays["triangles"]), dtype=np.int32) % len(materials)
    return MeshObject(**arrays, material_numbers=numbers, materials=materials, **more)
