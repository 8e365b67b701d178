"""What the command-line tools share: one clear line for an error, and the exit status."""

from __future__ import annotations

import sys
import traceback
from collections.abc import Callable

from rna_sdk.errors import RnaError


def run_command(command: Callable[[], None], debug: bool) -> int:
    """0 when `command` returns, 1 after an `RnaError` (printed as one line), 130 after Ctrl-C."""
    try:
        command()
    except RnaError as error:
        if debug:
            traceback.print_exc()
        else:
            print(f"error: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("stopped; run the same command again to continue", file=sys.stderr)
        return 130
    return 0
