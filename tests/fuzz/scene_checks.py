"""What `scenes.py` asks of a file: it is read and usable, or refused in one line."""

import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from rna_render import MeshObject, World, load_world, read_environment, read_mesh_object
from rna_render.lights import EquirectangularImage
from rna_render.materials import SRGB, Texture, read_alpha, read_texels
from rna_render.scene import DiffuseModel, read_scene
from rna_render.world.placements import Placement, mesh_light
from rna_sdk.errors import RnaError
from tests.fuzz.motion_files import GLTF_MOTIONS, MOTION_FILES, check_motion
from tests.fuzz.scene_seeds import ENVIRONMENTS, MESHES, SCENES, TEXTURES
from tests.fuzz.training_files import (
    CHECKPOINTS,
    MANIFESTS,
    check_checkpoint,
    check_manifest,
)

MOST_QUERIES = 48
LONGEST_MESSAGE = 1000


class Broken(Exception):
    """A file was accepted, and what it became is not usable; or its message is none."""


def check(kind: str, path: Path) -> bool:
    """Whether the file is accepted. Raises whatever a reader should not raise, or Broken."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            _CHECKS[kind](path)
        except RnaError as error:
            _check_message(str(error))
            return False
        return True


def _check_message(message: str) -> None:
    for sign in ("MemoryError", "Traceback", "bad_alloc"):
        if sign in message:
            raise Broken(f"message: {message[:200]}")
    if "\n" in message or len(message) > LONGEST_MESSAGE:
        raise Broken(f"message of {len(message)} characters: {message[:200]!r}")


def _finite(name: str, values: np.ndarray, low: float = -np.inf, high: float = np.inf) -> None:
    if not (np.isfinite(values) & (values >= low) & (values <= high)).all():
        raise Broken(f"{name} of {np.nanmin(values)} to {np.nanmax(values)}")


def _check_environment(path: Path) -> None:
    texels = read_environment(path)
    _finite("texels", texels, 0)
    image = EquirectangularImage(texels)
    rng = np.random.default_rng(0)
    directions = rng.normal(size=(40, 3)).astype(np.float32)
    directions[:6] = np.vstack([np.eye(3), -np.eye(3)])
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    _finite("radiance", image.lookup(directions)[0], 0)
    _finite("sampled directions", image.sample(rng.random((40, 2)))[0], -1.001, 1.001)
    unusable = np.array([[np.nan] * 3, [np.inf] * 3, [1e30] * 3, [0] * 3], np.float32)
    image.lookup(unusable)  # within the image, whatever it finds


def _check_texture(path: Path) -> None:
    texture = Texture(read_texels(path, path), SRGB)
    read_alpha(path, path)
    uv = np.random.default_rng(0).normal(0, 5, (40, 2)).astype(np.float32)
    _finite("colours", texture.lookup(uv), 0, 1)
    texture.lookup(np.array([[np.nan, np.inf], [1e30, -np.inf], [3e38, -3e38]], np.float32))


def _check_mesh(path: Path) -> None:
    mesh = read_mesh_object(path)
    read_mesh_object(path, DiffuseModel(type="diffuse"))
    _finite("positions", mesh.positions)
    _finite("normals", mesh.normals, -1.001, 1.001)
    _check_surface(mesh)
    World([Placement(mesh, np.eye(4), mesh_light(mesh, np.eye(4)))])


def _check_surface(mesh: MeshObject) -> None:
    count = min(len(mesh.triangles), MOST_QUERIES)
    triangle = np.tile(np.arange(count, dtype=np.int32), 4)
    u = np.repeat(np.array([0, 1, 0, 1 / 3], np.float32), count)
    v = np.repeat(np.array([0, 0, 1, 1 / 3], np.float32), count)
    ng = np.tile(np.array([0, 0.6, 0.8], np.float32), (len(u), 1))
    wo = np.tile(np.array([0.6, 0, 0.8], np.float32), (len(u), 1))
    scattering = mesh.scattering(triangle, u, v)
    _finite("base colour", scattering.base_color, 0, 1)
    for name, values in (("alpha", scattering.alpha), ("metallic", scattering.metallic)):
        _finite(name, values, 0, 1)
    _finite("coat", scattering.coat_f0, 0, 1)
    _finite("emission", scattering.emission, 0)
    n = mesh.shading_normals(triangle, u, v, ng, wo)
    _finite("shading normals", n, -1.001, 1.001)
    rng = np.random.default_rng(0)
    wi, _ = scattering.sample_and_pdf(n, ng, wo, rng.random((len(u), 3)))
    _finite("sampled directions", wi, -1.01, 1.01)
    _finite("scattered light", scattering.evaluate(n, ng, wo, wi), 0)
    _finite("emitted luminance", mesh.emitted_luminance, 0)
    if mesh.transmittance is not None:
        facing = np.ones(len(u), bool)
        _finite("transmittance", mesh.transmittance.at(triangle, u, v, -wo, facing), 0, 1)


def _check_scene(path: Path) -> None:
    scene_file = read_scene(path)
    if not scene_file.scene.assets:
        load_world(scene_file)


def _checked(arrays: Callable[[Path], list[tuple[str, np.ndarray]]]) -> Callable[[Path], None]:
    def check_arrays(path: Path) -> None:
        for name, values in arrays(path):
            _finite(name, values)

    return check_arrays


_CHECKS: dict[str, Any] = {
    MESHES: _check_mesh,
    ENVIRONMENTS: _check_environment,
    TEXTURES: _check_texture,
    SCENES: _check_scene,
    GLTF_MOTIONS: _checked(check_motion),
    MOTION_FILES: _checked(check_motion),
    CHECKPOINTS: _checked(check_checkpoint),
    MANIFESTS: _checked(check_manifest),
}
