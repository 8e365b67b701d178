"""The vocabulary of decoder inputs: blocks of columns of `queries`.

The one table of blocks; `spec/RNA.md`, "Input blocks", gives each one's formula.
"""

from __future__ import annotations

from collections.abc import Iterable

INPUT_BLOCKS: dict[str, int | None] = {
    "features": None,
    "position": 3,
    "normal": 3,
    "tangent": 3,
    "h": 1,
    "wo": 3,
    "wi": 3,
    "half_vector": 5,
    "highlight": 1,
    "learned_normal": 2,
    "fiber_angles": 6,
    "fiber_lobes": 3,
}
"""Block name -> number of columns; None is the tier's number of feature channels."""

BLOCKS_OF_KIND: dict[str, frozenset[str]] = {
    "surface": frozenset({"normal", "half_vector", "highlight", "learned_normal"}),
    "fiber": frozenset({"tangent", "h", "fiber_angles", "fiber_lobes"}),
}
"""Blocks that only one kind of asset can fill; the others are for both."""


BLOCKS_OF_EMISSION = frozenset({"features", "position", "normal", "tangent", "h", "wo"})
"""Blocks that know no light, and so are for emission too."""


def blocks_for(kind: str) -> list[str]:
    """The blocks that an asset of this kind can fill, in the order of INPUT_BLOCKS."""
    other = {name for k, names in BLOCKS_OF_KIND.items() if k != kind for name in names}
    return [name for name in INPUT_BLOCKS if name not in other]


def query_width(inputs: Iterable[str], channels: int) -> int:
    """K, the number of columns of `queries`, for these blocks and feature channels.

    Raises:
        KeyError: a name that is not in INPUT_BLOCKS.

    Examples:
        >>> query_width(["features", "wo", "wi"], channels=8)
        14
    """
    widths = (INPUT_BLOCKS[name] for name in inputs)
    return sum(channels if width is None else width for width in widths)
