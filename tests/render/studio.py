"""Scenes of things of every kind, built in place, and their images with a known error."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Literal

import numba
import numpy as np

from rna_render.lights import AssetLight, PlacedLight, make_light
from rna_render.materials import MeshObject
from rna_render.materials.material import Material
from rna_render.paths.bands import render
from rna_render.paths.integrator import Integrator
from rna_render.scene.scene_model import Scene
from rna_render.scene.transforms import world_from_object
from rna_render.world.camera import Camera
from rna_render.world.placements import Placement, SceneObject, emission_of, mesh_light
from rna_render.world.world import World
from rna_sdk.package import Mesh
from tests.render.stage import rgb

Channels = dict[str, np.ndarray]


@dataclass(frozen=True)
class Estimate:
    """The mean of an image whose pixels are independent, and its standard error; (3,) each."""

    mean: np.ndarray
    error: np.ndarray


def shoot(
    scene_objects: Sequence[tuple[SceneObject, dict[str, Any]]],
    lights: Sequence[dict[str, Any]] = (),
    strategy: Literal["both", "lights", "rays"] = "both",
    **changes: Any,
) -> Channels:
    """Channels of the image of `things`, with their transforms, and of lights of a scene file.

    changes: keys of the scene file. strategy: of the integrator.
    """
    defaults = {
        "resolution": (48, 48),
        "samples": 16,
        "objects": [{"path": "-"}] * len(scene_objects),
    }
    objects = [{"path": "-", "transform": transform} for _, transform in scene_objects]
    changes = defaults | {"objects": objects, "lights": lights} | changes
    scene = Scene.model_validate(changes)
    placements = [
        _placed(scene_object, world_from_object(model.transform))
        for (scene_object, _), model in zip(scene_objects, scene.objects, strict=True)
    ]
    made = [make_light(model) for model in scene.lights]
    shapes = [light for light in made if isinstance(light, PlacedLight)]
    placements += [Placement(x, x.world_from_object, x, boundless=True) for x in shapes]
    world = World(placements)
    others = [light for light in made if light not in shapes]
    camera = Camera(scene.camera, scene.resolution)
    lights = [*world.lights, *others]
    integrator = Integrator(world, camera, lights, max_depth=scene.max_depth, strategy=strategy)
    with one_thread():
        return render(scene, integrator).channels()


@contextmanager
def one_thread() -> Iterator[None]:
    """For small images: threads would wait for one another, minutes long on a busy machine."""
    threads = numba.get_num_threads()
    numba.set_num_threads(1)
    try:
        yield
    finally:
        numba.set_num_threads(threads)


def _placed(scene_object: SceneObject, matrix: np.ndarray) -> Placement:
    if isinstance(scene_object, MeshObject):
        return Placement(scene_object, matrix, mesh_light(scene_object, matrix))
    emission = emission_of(scene_object)
    return Placement(scene_object, matrix, AssetLight(emission, matrix) if emission else None)


def seen(channels: Channels) -> Estimate:
    """What a camera that looks at one point sees: every pixel is a number of the same law."""
    pixels = rgb(channels).reshape(-1, 3).astype(np.float64)
    return Estimate(pixels.mean(axis=0), pixels.std(axis=0, ddof=1) / np.sqrt(len(pixels)))


def at_point(x: Sequence[float], from_: Sequence[float] = (0.3, 1.5, 2.0)) -> dict[str, Any]:
    """A camera at `from_` that looks at next to nothing but x, in world space."""
    return {"position": tuple(from_), "look_at": tuple(x), "vertical_fov_deg": 0.005}


def made_of(mesh: Mesh, catches_shadows: bool = False, **material: Any) -> MeshObject:
    """The mesh as an object of one material; its keys are those of Material."""
    count = len(mesh.triangles)
    return MeshObject(
        positions=mesh.positions,
        normals=mesh.normals,
        uvs=mesh.uvs,
        triangles=mesh.triangles,
        material_numbers=np.zeros(count, np.int32),
        materials=(Material(**material),),
        catches_shadows=catches_shadows,
    )


def flat(mesh: Mesh) -> Mesh:
    """The mesh with every triangle on its own and with its geometric normal."""
    corners = mesh.positions[mesh.triangles].astype(np.float64)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return Mesh(
        positions=corners.reshape(-1, 3).astype(np.float32),
        normals=np.repeat(normals, 3, axis=0).astype(np.float32),
        uvs=None,
        triangles=np.arange(3 * len(corners), dtype=np.uint32).reshape(-1, 3),
    )


def assert_is(estimate: Estimate, expected: Any, relative: float = 0.005) -> None:
    """Assert that it is the value, within three standard errors and the relative tolerance.

    The error must be small enough for the tolerance to say something.
    """
    expected = np.broadcast_to(np.asarray(expected, np.float64), (3,))
    assert (estimate.error <= 0.5 * relative * np.abs(expected)).all(), (
        f"too noisy to tell: {estimate}, expected {expected}"
    )
    off = np.abs(estimate.mean - expected)
    # What the geometry's float32 and the camera's small solid angle may change.
    slack = 3e-4 * np.abs(expected)
    assert (off <= 3.0 * estimate.error + slack).all(), f"{estimate}, expected {expected}"
    assert (off <= relative * np.abs(expected)).all(), f"{estimate}, expected {expected}"
