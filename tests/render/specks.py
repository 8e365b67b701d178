"""What a pixel is measured against to tell whether it is a speck."""

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view


def brightest_around(image: np.ndarray) -> np.ndarray:
    """The largest value in each pixel's 5 x 5 neighbourhood: (h, w, ...), of each channel."""
    edges = [(2, 2), (2, 2)] + [(0, 0)] * (image.ndim - 2)
    padded = np.pad(image, edges, "edge")
    return sliding_window_view(padded, (5, 5), axis=(0, 1)).max(axis=(-2, -1))
