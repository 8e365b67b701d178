"""Blender's matrices as a scene file's transforms, which know one scale alone."""

import math

import mathutils

from ..axes import matrix_from_blender

_EVEN = 1e-4  # relative difference of lengths and angles that counts as none


def is_similarity(matrix):
    """Whether a matrix turns, moves and scales evenly; it may mirror."""
    columns = [matrix.to_3x3().col[k] for k in range(3)]
    scale = columns[0].length
    if scale <= 0.0:
        return False
    even = all(abs(column.length - scale) <= _EVEN * scale for column in columns)
    pairs = ((0, 1), (1, 2), (2, 0))
    return even and all(abs(columns[a].dot(columns[b])) <= _EVEN * scale**2 for a, b in pairs)


def transform(matrix):
    """A similarity as the scene file's `transform`; all scales are negative where it mirrors."""
    translation, turn, scale = matrix_from_blender(matrix).decompose()
    return {
        "translation": list(translation),
        "quaternion": [turn.x, turn.y, turn.z, turn.w],
        "scale": sum(scale) / 3.0,
    }


def nearest_similarity(matrix):
    """The transform with the geometric mean of its three scales, and without shear."""
    translation, turn, scale = matrix.decompose()
    product = scale.x * scale.y * scale.z
    mean = math.copysign(abs(product) ** (1.0 / 3.0), product)
    return mathutils.Matrix.LocRotScale(translation, turn, (mean,) * 3)
