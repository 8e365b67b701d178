"""Blender's axes (+Z up) and the package's (+Y up, as glTF), side by side."""

import numpy as np


def to_blender(vectors: np.ndarray) -> np.ndarray:
    """glTF (x, y, z) to Blender (x, -z, y); shape (..., 3), dtype kept."""
    return np.stack([vectors[..., 0], -vectors[..., 2], vectors[..., 1]], axis=-1)


def from_blender(vectors: np.ndarray) -> np.ndarray:
    """Blender (x, y, z) to glTF (x, z, -y); shape (..., 3), dtype kept."""
    return np.stack([vectors[..., 0], vectors[..., 2], -vectors[..., 1]], axis=-1)
