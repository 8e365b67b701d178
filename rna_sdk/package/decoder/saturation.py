"""Whether weights in int8 can saturate an engine that sums products two by two in 16 bits.

x86 CPUs without VNNI multiply uint8 by int8 so (vpmaddubsw): the products of rows 2k and 2k + 1 of
a weight matrix are added in 16 bits, and a sum beyond them is clamped.
"""

import numpy as np
from numpy.typing import NDArray

PAIR_LIMIT = 128
"""Two weights of one sign may add up to this: 255 * 128 = 32,640 is within 16 bits, 255 * 129 is
not."""


def pair_sums(weight: NDArray[np.int8]) -> NDArray[np.int64]:
    """(ceil(inputs / 2), outputs) int64: the largest sum of each pair of rows, by magnitude.

    weight: (inputs, outputs) int8. Weights of unlike sign never sum to more than one of them alone.
    """
    wide = weight.astype(np.int64)
    pairs = np.pad(wide, ((0, len(wide) % 2), (0, 0))).reshape(-1, 2, weight.shape[1])
    positive, negative = np.maximum(pairs, 0).sum(axis=1), np.minimum(pairs, 0).sum(axis=1)
    largest: NDArray[np.int64] = np.maximum(positive, -negative)
    return largest


def can_saturate(weight: NDArray[np.int8]) -> bool:
    """Whether some uint8 inputs take a pair of (inputs, outputs) weights beyond 16 bits."""
    return bool((pair_sums(weight) > PAIR_LIMIT).any())
