"""The sRGB transfer function (IEC 61966-2-1, section 5.2)."""

import numpy as np


def encode_srgb(linear: np.ndarray) -> np.ndarray:
    """Linear light as sRGB values, both in [0, 1], any shape. Clamps other values."""
    linear = np.clip(linear, 0.0, 1.0)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def decode_srgb(encoded: np.ndarray) -> np.ndarray:
    """sRGB values as linear light; both in [0, 1], any shape."""
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
