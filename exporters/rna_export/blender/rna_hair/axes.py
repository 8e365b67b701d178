"""+Z up, as in Blender and `.hair` files, and +Y up, as strands are here, side by side."""

import numpy as np


def z_up_to_y_up(xyz: np.ndarray) -> np.ndarray:
    """(x, y, z) to (x, z, -y): (n, 3) float32."""
    return np.stack([xyz[:, 0], xyz[:, 2], -xyz[:, 1]], axis=-1).astype(np.float32)


def y_up_to_z_up(xyz: np.ndarray) -> np.ndarray:
    """(x, y, z) to (x, -z, y): (n, 3) float32."""
    return np.stack([xyz[:, 0], -xyz[:, 2], xyz[:, 1]], axis=-1).astype(np.float32)
