"""Position of a coordinate between the texels of an image, and its wrapping."""

import numpy as np

from rna_sdk.machine.compiled import compiled

REPEAT, CLAMP, MIRROR = 0, 1, 2


@compiled(fastmath=())
def _wrapped(x: float, wrap: int) -> float:
    """A coordinate within [0, 1]; 0 for one that is not finite."""
    if not -np.inf < x < np.inf:
        return 0.0
    if wrap == REPEAT:
        inside: float = x - np.floor(x)
        return inside
    if wrap == MIRROR:
        x -= 2.0 * np.floor(0.5 * x)
        return 2.0 - x if x > 1.0 else x
    return min(max(x, 0.0), 1.0)


@compiled(fastmath=())
def texels_around(x: float, size: int, wrap: int) -> tuple[int, int, float]:
    """The two texels whose centres x is between, both in [0, size), and its place between them."""
    place = _wrapped(x, wrap) * size - 0.5
    first = int(np.floor(place))
    rest = place - first
    second = first + 1
    if wrap == REPEAT:
        return first % size, second % size, rest
    return max(first, 0), min(second, size - 1), rest
