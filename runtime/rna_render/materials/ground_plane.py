"""The plane that objects stand on."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from rna_render.materials.material import make_material
from rna_render.materials.mesh_object import MeshObject
from rna_render.scene.material_models import ShadowCatcherModel

if TYPE_CHECKING:
    # which themselves need this package
    from rna_render.scene.scene_model import CameraModel, GroundModel

# Squares about the camera, each so many times as wide as the one inside it: near the camera the
# triangles are small, and with them the rounding errors of what is interpolated on them.
_WIDER = 4.0
_SQUARES = 11
# One that shines is sampled by its area: the far part must not take all samples.
_SHINING_SQUARES = 4


def ground(model: GroundModel, camera: CameraModel) -> MeshObject:
    """A horizontal plane that faces +Y, in the scene file's space with the camera at the origin.

    With a size it is a square of two triangles about (0, height, 0). Without one it has no end: it
    is squares about the camera, in the scale of how far this is from `look_at` and from the ground,
    so that a scene has one picture at any scale and place. Its texture coordinates are metres, u
    along +X and v along +Z, with (0, 0) in the middle: an image covers a square metre, upright for
    who looks down with -Z up. Raises the errors of `make_material`.
    """
    origin = np.array(camera.position, np.float64)
    material = make_material(model.material)
    if model.size is None:
        near = np.linalg.norm(np.subtract(camera.look_at, camera.position))
        count = _SHINING_SQUARES if any(material.emission) else _SQUARES
        halves = max(near, abs(model.height - origin[1])) * _WIDER ** np.arange(count)
        corners, middle = _squares(halves), origin[[0, 2]]
    else:
        corners, middle = _squares(np.array([model.size / 2])), np.zeros(2)
    flat = corners + middle - origin[[0, 2]]
    height = np.full(len(flat), model.height - origin[1])
    triangles = _triangles(len(corners) // 4)
    return MeshObject(
        positions=np.column_stack([flat[:, 0], height, flat[:, 1]]).astype(np.float32),
        normals=np.tile(np.array([0, 1, 0], np.float32), (len(flat), 1)),
        # Images repeat each metre, and float32 has no digits for the place of a camera far away.
        uvs=(corners + np.mod(middle, 1.0)).astype(np.float32),
        triangles=triangles,
        material_numbers=np.zeros(len(triangles), np.int32),
        materials=(material,),
        catches_shadows=isinstance(model.material, ShadowCatcherModel),
    )


def _squares(halves: np.ndarray) -> np.ndarray:
    """x and z of the corners of squares about (0, 0), (4 k, 2), counter-clockwise from above."""
    corners = np.array([[-1.0, 1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]])
    return np.concatenate([half * corners for half in halves])


def _triangles(squares: int) -> np.ndarray:
    """The innermost square, and the four sides of each frame about one: (t, 3) uint32."""
    result = [[0, 1, 2], [0, 2, 3]]
    for first in range(4, 4 * squares, 4):
        for k in range(4):
            a, b, after = first + k, first + (k + 1) % 4, (k + 1) % 4
            result += [[a, b, first - 4 + after], [a, first - 4 + after, first - 4 + k]]
    return np.array(result, np.uint32)
