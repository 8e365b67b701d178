"""The matrix that a scene file's transform means."""

from typing import TypeVar

import numpy as np
from pydantic import BaseModel

from rna_render.scene.model_base import Quaternion, TransformModel, Vector

_Model = TypeVar("_Model", bound=BaseModel)
_PLACES = ("position", "look_at")


def world_from_object(model: TransformModel, origin: np.ndarray | None = None) -> np.ndarray:
    """Scale, then rotation, then translation: (4, 4) float64.

    origin: of the world, (3,) float64, in the scene file's space; None for the file's.
    """
    matrix = np.eye(4)
    matrix[:3, :3] = model.scale * _rotation(model)
    matrix[:3, 3] = model.translation
    if origin is not None:
        matrix[:3, 3] -= origin
    return matrix


def from_origin(model: _Model, origin: np.ndarray) -> _Model:
    """A camera or a light, with its places from `origin`, (3,) float64, on."""
    places = {
        name: tuple(np.subtract(getattr(model, name), origin).tolist())
        for name in _PLACES
        if name in type(model).model_fields
    }
    return model.model_copy(update=places)


def _rotation(model: TransformModel) -> np.ndarray:
    if model.quaternion is not None:
        return quaternion_rotation(model.quaternion)
    return _from_euler(model.rotation_deg or (0.0, 0.0, 0.0))


def _from_euler(degrees: Vector) -> np.ndarray:
    """Rz Ry Rx: first about x, then y, then z, all fixed axes."""
    (cx, cy, cz), (sx, sy, sz) = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    about_x = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    about_y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    about_z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    return np.asarray(about_z @ about_y @ about_x)


def quaternion_rotation(quaternion: Quaternion) -> np.ndarray:
    """(3, 3) float64 of (x, y, z, w) of any length but 0, for which it raises ValueError.

    Shoemake, Animating Rotation with Quaternion Curves (1985).
    """
    length = np.linalg.norm(quaternion)
    if not length > 0.0:
        raise ValueError(f"a rotation is {list(quaternion)}; expected a quaternion of some length")
    x, y, z, w = np.asarray(quaternion, np.float64) / length
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
