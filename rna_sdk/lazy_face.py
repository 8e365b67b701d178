"""The public names of a package, each loaded when it is asked for, not with the package.

A package declares them once, for type checkers and at run time alike (PEP 562):

    if TYPE_CHECKING:
        from rna_sdk.package.package import Package

    __all__ = ["Package"]
    __getattr__, __dir__ = lazy_face(__name__)

No public name may be that of a module in the package, which takes its place once it is loaded.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Callable
from functools import cache
from importlib import import_module
from importlib.util import find_spec


def lazy_face(package: str) -> tuple[Callable[[str], object], Callable[[], list[str]]]:
    """`__getattr__` and `__dir__` of a package, for the names in its `__all__`."""
    module = sys.modules[package]

    def get(name: str) -> object:
        if name not in module.__all__:
            raise AttributeError(
                f"module {package!r} has no attribute {name!r}; its names: "
                + ", ".join(sorted(module.__all__))
            )
        value = getattr(import_module(homes(package)[name]), name)
        setattr(module, name, value)
        return value

    def names() -> list[str]:
        return sorted({*vars(module), *module.__all__})

    return get, names


@cache
def homes(package: str) -> dict[str, str]:
    """Public name of a package -> the module that defines it, as its imports for type checkers say.

    Raises:
        ImportError: the package's source is not installed.
    """
    spec = find_spec(package)
    source = spec.loader.get_source(package) if spec and spec.loader else None  # type: ignore[attr-defined]
    if source is None:
        raise ImportError(f"{package} is installed without its source", name=package)
    return {
        alias.name: node.module
        for block in ast.parse(source).body
        if isinstance(block, ast.If) and ast.unparse(block.test) == "TYPE_CHECKING"
        for node in block.body
        if isinstance(node, ast.ImportFrom) and node.module
        for alias in node.names
    }
