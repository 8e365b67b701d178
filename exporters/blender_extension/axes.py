"""Blender's axes (+Z up) and the axes of packages and scene files (+Y up), side by side."""

import mathutils
import numpy as np

_TO_SCENE = mathutils.Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1)))


def to_blender(vectors):
    """(x, y, z) to (x, -z, y); shape (..., 3), dtype kept."""
    return np.stack([vectors[..., 0], -vectors[..., 2], vectors[..., 1]], axis=-1)


def from_blender(vectors):
    """(x, y, z) to (x, z, -y); shape (..., 3), dtype kept."""
    return np.stack([vectors[..., 0], vectors[..., 2], -vectors[..., 1]], axis=-1)


def matrix_from_blender(matrix):
    """A 4 x 4 matrix between Blender spaces as one between spaces with +Y up."""
    return _TO_SCENE @ matrix @ _TO_SCENE.inverted()


def vector_from_blender(vector):
    """One vector in the scene's axes, as a list of three numbers."""
    return [vector[0], vector[2], -vector[1]]
