"""Shared options, and a help formatter that shows type and default."""

import argparse
from pathlib import Path

_TYPES: dict[object, str] = {None: "text", Path: "path"}


class OptionHelp(argparse.RawDescriptionHelpFormatter):
    """Adds type and default to the help of options that do not state them."""

    def _get_help_string(self, action: argparse.Action) -> str:
        text = action.help or ""
        if "default" in text or not action.option_strings or action.required or action.nargs == 0:
            return text
        default = "none" if action.default is None else action.default
        if isinstance(default, list | tuple):
            default = " ".join(map(str, default)) or "none"
        kind = _TYPES.get(action.type) or getattr(action.type, "__name__", "text")
        return f"{text} ({kind}, default: {default})".lstrip()


def add_out(parser: argparse.ArgumentParser) -> None:
    """`--out` of a command whose result is one JSON file."""
    parser.add_argument("--out", type=Path, help="JSON to write (path, default: print only)")
