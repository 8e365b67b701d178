"""The plane that objects stand on."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from rna_render.materials.material import make_material
from rna_render.materials.mesh_object import MeshObject
from rna_render.scene.material_models import ShadowCatcherModel

if TYPE_CHECKING:
    from rna_render.scene.scene_model import GroundModel  # which itself needs this package


_LEAST_SIZE, _REACHES = 100.0, 400.0  # metres; side over the distance of what stands on it


def ground(
    model: GroundModel,
    boxes: Iterable[tuple[np.ndarray, np.ndarray]] = (),
    origin: np.ndarray | None = None,
) -> MeshObject:
    """A square of two triangles about (0, height, 0) that faces +Y.

    Its texture coordinates are metres, u along +X and v along +Z, with (0, 0) in the middle: an
    image covers a square metre, upright for who looks down with -Z up. boxes: lower and upper
    corner, each (3,), in the world, of what stands on it; a ground without a size follows the
    largest x or z of them. origin: of the world, (3,) float64, in the scene file's space; None for
    that of the file. Raises the errors of `make_material`.
    """
    away = np.zeros(3) if origin is None else origin
    size = model.size
    if size is None:
        far = (float(np.abs(box + away)[:, [0, 2]].max()) for box in boxes)
        reach = max(far, default=0.0)
        size = max(_LEAST_SIZE, _REACHES * reach)
    half = size / 2
    x, z = np.array([[-1, 1, 1, -1], [1, 1, -1, -1]]) * half
    return MeshObject(
        positions=(np.column_stack([x, np.full(4, model.height), z]) - away).astype(np.float32),
        normals=np.tile(np.array([0, 1, 0], np.float32), (4, 1)),
        uvs=np.column_stack([x, z]).astype(np.float32),
        triangles=np.array([[0, 1, 2], [0, 2, 3]], np.uint32),
        material_numbers=np.zeros(2, np.int32),
        materials=(make_material(model.material),),
        catches_shadows=isinstance(model.material, ShadowCatcherModel),
    )
