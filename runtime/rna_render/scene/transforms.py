"""The matrix that a scene file's transform means, and back."""

from typing import TypeVar

import numpy as np
from pydantic import BaseModel

from rna_render.scene.limits import MAX_NUMBER, MAX_SIZE, MIN_SIZE
from rna_render.scene.model_base import Quaternion, TransformModel, Vector

_Model = TypeVar("_Model", bound=BaseModel)
_PLACES = ("position", "look_at")
_TOLERANCE = 1e-5  # of a rotation's entries, as rna_sdk.runtime.Transform has it


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


def as_transform(matrix: np.ndarray) -> TransformModel:
    """The transform of a (4, 4) matrix; its scale is negative where the matrix mirrors.

    Raises ValueError where it is not a similarity, or is beyond the limits of scenes.
    """
    linear = matrix[:3, :3]
    scale = float(np.cbrt(np.linalg.det(linear)))
    rotation = linear / scale if scale else linear
    if np.abs(rotation.T @ rotation - np.eye(3)).max() > _TOLERANCE:
        lengths = ", ".join(f"{length:.4g}" for length in np.linalg.norm(linear, axis=0))
        raise ValueError(f"found axes of {lengths}; expected one scale, without shear")
    if not MIN_SIZE <= abs(scale) <= MAX_SIZE or np.abs(matrix).max() > MAX_NUMBER:
        far = np.abs(matrix[:3, 3]).max()
        raise ValueError(
            f"found a scale of {abs(scale):.3g} and a place at {far:.3g} m; "
            f"expected {MIN_SIZE:g} to {MAX_SIZE:g}, and at most {MAX_NUMBER:g} m"
        )
    return TransformModel(
        translation=tuple(matrix[:3, 3].tolist()),
        quaternion=_quaternion(rotation),
        scale=scale,
    )


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


def _quaternion(rotation: np.ndarray) -> Quaternion:
    """(x, y, z, w) of a rotation (3, 3), as Bar-Itzhack, New Method for Extracting the Quaternion
    from a Rotation Matrix (2000)."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rotation.tolist()
    lower = [
        [xx - yy - zz, 0.0, 0.0, 0.0],
        [yx + xy, yy - xx - zz, 0.0, 0.0],
        [zx + xz, zy + yz, zz - xx - yy, 0.0],
        [zy - yz, xz - zx, yx - xy, xx + yy + zz],
    ]
    x, y, z, w = np.linalg.eigh(lower)[1][:, -1].tolist()
    return x, y, z, w
