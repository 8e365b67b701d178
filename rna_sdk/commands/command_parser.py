"""The parser of every command: --version, --debug, and errors of usage in two lines."""

import argparse
import re
import sys
from difflib import get_close_matches
from typing import Any, NoReturn

from rna_sdk import __version__
from rna_sdk.commands.lasting_streams import lasting_streams


class CommandParser(argparse.ArgumentParser):
    """An ArgumentParser with --version and --debug; errors show an example, not all options.

    example: a command to copy; None for none.
    """

    def __init__(self, *, example: str | None = None, **options: Any) -> None:
        super().__init__(**options)
        self._example = example
        self.add_argument(
            "--version",
            action="version",
            version=f"{self.prog} {__version__}",
            help="show the version and exit (default: off)",
        )
        self.add_argument(
            "--debug", action="store_true", help="show the traceback of an error (default: off)"
        )

    def exit(self, status: int = 0, message: str | None = None) -> NoReturn:
        """Prints the message and exits; a reader of the help that ended early is no error."""
        with lasting_streams():
            super().exit(status, message)

    def error(self, message: str) -> NoReturn:
        """Prints the example, the message and known options like an unknown one; exits."""
        usage = f"usage: {self._example or f'{self.prog} ...'}"
        print(f"{usage}    ({self.prog} --help lists all options)", file=sys.stderr)
        line = "; ".join(message.splitlines())  # names of files may have several
        self.exit(2, f"{self.prog}: error: {line}{self._hint(message)}\n")

    def _hint(self, message: str) -> str:
        if not message.startswith("unrecognized arguments:"):
            return ""
        unknown = re.findall(r"(?<=\s)--[\w-]+", message)
        known = [name for name in self._option_string_actions if name.startswith("--")]
        close = [get_close_matches(name, known, n=1) for name in unknown]
        names = [match[0] for match in close if match]
        return f"; did you mean {' and '.join(names)}?" if names else ""
