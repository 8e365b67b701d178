"""Python modules that the bpy wheel ships in a folder outside sys.path."""

import sys
from pathlib import Path

import bpy


def add_to_path() -> None:
    """Make `oslquery` and `pxr` importable; last on the path: an old numpy lies beside them."""
    root = Path(bpy.utils.resource_path("LOCAL"))
    folder = str(root / "python" / "lib" / "python3.11" / "site-packages")
    if folder not in sys.path:
        sys.path.append(folder)
