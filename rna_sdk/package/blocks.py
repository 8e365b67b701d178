"""The vocabulary of decoder inputs: blocks of columns of `queries`.

The one table of blocks; `spec/RNA-1.0.md`, "Input blocks", gives each one's formula.
"""

from __future__ import annotations

from collections.abc import Iterable

INPUT_BLOCKS: dict[str, int | None] = {
    "features": None,
    "position": 3,
    "normal": 3,
    "wo": 3,
    "wi": 3,
    "half_vector": 5,
}
"""Block name -> number of columns; None is the tier's number of feature channels."""


def query_width(inputs: Iterable[str], channels: int) -> int:
    """K, the number of columns of `queries`, for these blocks and feature channels.

    Raises:
        KeyError: a name that is not in INPUT_BLOCKS.
    """
    widths = (INPUT_BLOCKS[name] for name in inputs)
    return sum(channels if width is None else width for width in widths)
