"""Names of a package that are loaded when they are asked for, not with the package."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from importlib import import_module


def lazy_names(modules: Mapping[str, Sequence[str]]) -> Callable[[str], object]:
    """A package's `__getattr__` (PEP 562). modules: the names that each module defines."""
    home = {name: module for module, names in modules.items() for name in names}

    def get(name: str) -> object:
        if name not in home:
            raise AttributeError(f"no name {name!r} here; there are {sorted(home)}")
        return getattr(import_module(home[name]), name)

    return get
