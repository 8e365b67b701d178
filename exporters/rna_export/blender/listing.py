"""Short lists of possibly many names."""

from collections.abc import Sequence

_NAMED = 3


def listed(texts: Sequence[str]) -> str:
    """The first three, and how many more there are: "'a', 'b', 'c' and 2 more"."""
    more = f" and {len(texts) - _NAMED} more" if len(texts) > _NAMED else ""
    return f"{', '.join(texts[:_NAMED])}{more}"
