"""Blender's axes (+Z up) and the package's (+Y up, as glTF), side by side; cameras and scenes."""

from typing import Any, Protocol

import numpy as np


def to_blender(vectors: np.ndarray) -> np.ndarray:
    """glTF (x, y, z) to Blender (x, -z, y); shape (..., 3), dtype kept."""
    return np.stack([vectors[..., 0], -vectors[..., 2], vectors[..., 1]], axis=-1)


def from_blender(vectors: np.ndarray) -> np.ndarray:
    """Blender (x, y, z) to glTF (x, z, -y); shape (..., 3), dtype kept."""
    return np.stack([vectors[..., 0], vectors[..., 2], -vectors[..., 1]], axis=-1)


class Pinhole(Protocol):
    """A camera: to_world, (4, 4), from its space, which looks along -z; fov_y in radians."""

    @property
    def to_world(self) -> np.ndarray: ...

    @property
    def fov_y(self) -> float: ...

    @property
    def width(self) -> int: ...

    @property
    def height(self) -> int: ...


def pinhole(camera: Pinhole) -> dict[str, Any]:
    """A camera, which looks along its -z in Blender too, as a request has it."""
    matrix = np.eye(4)
    matrix[:3] = to_blender(np.asarray(camera.to_world, np.float64)[:3].T).T
    size = {"width": camera.width, "height": camera.height}
    return {"matrix": matrix.tolist(), "fovY": camera.fov_y, **size}


def scene_to_blender(scene: dict[str, Any]) -> dict[str, Any]:
    """A scene in Blender's axes."""

    def turned(vectors: Any) -> Any:
        return to_blender(np.asarray(vectors, np.float64)).tolist()

    lights = [
        {k: turned(v) if k in ("position", "look_at", "up", "direction") else v for k, v in x}
        for x in (light.items() for light in scene["lights"])
    ]
    meshes = [{**mesh, "positions": turned(mesh["positions"])} for mesh in scene["meshes"]]
    assets = [_matrix_to_blender(matrix) for matrix in scene["assets"]]
    return {**scene, "lights": lights, "meshes": meshes, "assets": assets}


def _matrix_to_blender(matrix: list[list[float]]) -> list[list[float]]:
    """Both spaces turn: the rows, where the 4 x 4 matrix leads to, and the columns, where from."""
    turned = np.asarray(matrix, np.float64)
    turned[:3, :3] = to_blender(to_blender(turned[:3, :3].T).T)
    turned[:3, 3] = to_blender(turned[:3, 3])
    rows: list[list[float]] = turned.tolist()
    return rows
