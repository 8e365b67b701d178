"""Results of commands: JSON with the stamp first, written atomically."""

import argparse
import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

from rna_sdk.errors import SceneError
from rna_sdk.files.atomic_file import write_atomically

T = TypeVar("T")

_LINE = 120  # characters
_DATA = 100  # values of a list, from which on nobody reads them


def write_results(path: Path, stamp: dict[str, Any] | None, report: dict[str, Any]) -> None:
    """Write the report, stamped (None: it is older than stamps); folders are made."""
    path.parent.mkdir(parents=True, exist_ok=True)
    write_atomically(path, f"{_lines({'stamp': stamp, **report})}\n".encode())


def read_scenes(path: Path, taken: Callable[[dict[str, Any]], T]) -> T:
    """A result of `rna-bench scenes`, as `taken` reads it. Raises SceneError for other files."""
    try:
        return taken(json.loads(path.read_text()))
    except (OSError, ValueError, KeyError, TypeError) as error:
        found = "found no result of `rna-bench scenes`, expected one"
        raise SceneError(found, file=path) from error


def _lines(value: Any, indent: str = "") -> str:
    """JSON with a line for each value that is short, has no objects inside or is a long list."""
    text = json.dumps(value)
    is_long = isinstance(value, list) and len(value) >= _DATA
    if len(text) <= _LINE or "{" not in text[1:] or is_long:
        return text
    inner = indent + " "
    if isinstance(value, dict):
        ends, rows = "{}", [f"{json.dumps(k)}: {_lines(v, inner)}" for k, v in value.items()]
    else:
        ends, rows = "[]", [_lines(one, inner) for one in value]
    return ends[0] + ",".join(f"\n{inner}{row}" for row in rows) + f"\n{indent}{ends[1]}"


def publish(report: dict[str, Any], args: argparse.Namespace) -> None:
    """Print a command's report; write it to `args.out`, too, if that is given."""
    print(json.dumps({"stamp": args.stamp, **report}, indent=1))
    if args.out is not None:
        write_results(args.out, args.stamp, report)
        print(f"wrote {args.out}", file=sys.stderr)
