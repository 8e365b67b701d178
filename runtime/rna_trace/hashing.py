"""A hash of 32 bits, of random numbers that depend on places alone."""

import numpy as np

from rna_sdk.machine.compiled import compiled

Bits = int | np.uint32


@compiled(fastmath=())
def hash_bits(x: Bits) -> np.uint32:
    """A 32-bit mix: "lowbias32" of C. Wellons, Prospecting for Hash Functions (2018)."""
    x = np.uint32(x)
    x = np.uint32((x ^ (x >> np.uint32(16))) * np.uint32(0x7FEB352D))
    x = np.uint32((x ^ (x >> np.uint32(15))) * np.uint32(0x846CA68B))
    return np.uint32(x ^ (x >> np.uint32(16)))
