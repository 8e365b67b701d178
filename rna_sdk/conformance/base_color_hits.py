"""Hits of base colour in the kit: records of a file (spec/conformance/README.md)."""

from __future__ import annotations

import numpy as np

HIT = np.dtype(
    {
        "names": ["primitive", "u", "v", "level", "part"],
        "formats": ["<u4", "<f4", "<f4", "<f4", "<u4"],
        "offsets": [0, 4, 8, 12, 28],
        "itemsize": 32,
    }
)
