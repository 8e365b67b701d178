"""Files in `spec/` that are generated from the code: write one, or check that it is current."""

from __future__ import annotations

import argparse
from pathlib import Path


def generate(relative: str, text: str, module: str) -> int:
    """Command line of a generating module: write `text`, or compare it with `--check`.

    Args:
        relative: the file's path below `spec/`.
        text: what it must hold.
        module: the module's name, for the help and the advice.

    Returns:
        The exit status: 0, or 1 where `--check` finds the file missing or stale.
    """
    command = f"python -m {module}"
    parser = argparse.ArgumentParser(
        prog=command, description=f"Write spec/{relative} from the code. Try: {command} --check"
    )
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 if stale")
    parser.add_argument(
        "--spec", type=Path, default=Path("spec"), help="folder of the spec (default: spec)"
    )
    options = parser.parse_args()
    path: Path = options.spec / relative
    if options.check:
        if path.is_file() and path.read_text(encoding="utf-8") == text:
            return 0
        print(f"{path} is stale: run {command}")
        return 1
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    print(path)
    return 0
