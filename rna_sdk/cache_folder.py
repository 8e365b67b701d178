"""Where the user's caches are."""

from __future__ import annotations

import os
from pathlib import Path


def cache_folder() -> Path:
    """The SDK's folder for what can be made again; it need not exist.

    That of the XDG Base Directory Specification: `$XDG_CACHE_HOME` where it is an absolute path,
    else `~/.cache`. Raises RuntimeError where neither is there, since the user has no home.
    """
    named = Path(os.environ.get("XDG_CACHE_HOME", ""))
    return (named if named.is_absolute() else Path.home() / ".cache") / "rna-sdk"
