"""The vocabulary of decoder inputs: blocks of columns of `queries`.

`spec/RNA.md`, 6.3, declares them with their formulas.
"""

from collections.abc import Iterable

from rna_sdk.package.block_table import BLOCK_TABLE

INPUT_BLOCKS: dict[str, int | None] = {name: width for name, (width, _, _) in BLOCK_TABLE.items()}
"""Block name -> number of columns; None is the tier's number of feature channels."""

UNLIT_BLOCKS = frozenset(name for name, (_, _, light) in BLOCK_TABLE.items() if not light)
"""Blocks that know no light, and so are for forms of decoder without one, too."""


def blocks_for(kind: str) -> list[str]:
    """The blocks that an asset of this kind can fill, in the order of INPUT_BLOCKS."""
    return [name for name, (_, kinds, _) in BLOCK_TABLE.items() if kind in kinds]


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
