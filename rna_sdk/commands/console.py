"""Shared by the command-line tools: help layout, error output, exit status."""

import argparse
import re
import shlex
import signal
import sys
import threading
import traceback
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from rna_sdk.commands.command_parser import CommandParser
from rna_sdk.commands.lasting_streams import lasting_streams
from rna_sdk.errors import RnaError

_REFUSED_BY_TORCH = re.compile(r"you tried to allocate \d+ bytes")
"""In PyTorch's error for memory that the system refuses (c10/core/impl/alloc_cpu.cpp)."""

INTERRUPTED = 130
"""Exit status after Ctrl-C: the shell's for a program that SIGINT ended."""


def command_parser(
    prog: str, sentence: str, example: str, **options: Any
) -> argparse.ArgumentParser:
    """A parser whose help starts with one sentence and an example command.

    options: further arguments of ArgumentParser, such as usage or epilog.
    """
    return CommandParser(
        prog=prog,
        example=example,
        description=f"{sentence}\n\n  {example}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
        **options,
    )


def command_line(*words: object) -> str:
    """A command as a shell reads it: names with spaces or quotes are quoted."""
    return shlex.join(map(str, words))


def install_hint(extra: str) -> str:
    """How to install an extra: the project is on no package index."""
    return f"pip install -e '.[{extra}]' in the clone of rna-sdk"


def split_script_arguments(arguments: Sequence[str] | None) -> tuple[list[str], tuple[str, ...]]:
    """Splits a command's own arguments from those after `--`, which go to a source script.

    arguments: None for those of this process.
    """
    given = list(sys.argv[1:] if arguments is None else arguments)
    end = given.index("--") if "--" in given else len(given)
    return given[:end], tuple(given[end + 1 :])


def memory_text(error: Exception) -> str | None:
    """One line for memory that Python or PyTorch was refused; None for other errors."""
    if isinstance(error, MemoryError):
        return f"not enough memory: {error}".removesuffix(": ")
    refused = _REFUSED_BY_TORCH.search(str(error)) if isinstance(error, RuntimeError) else None
    return f"not enough memory: {refused[0]}" if refused else None


def run_command(
    command: Callable[[], int | None], debug: bool, when_stopped: str, extra: str | None = None
) -> int:
    """Runs `command`; returns its exit status, 0 for None.

    1 after an RnaError, which is printed as one line, or with its traceback if `debug`, and so
    after an OSError, such as a full disk, a MemoryError and what PyTorch raises for one;
    INTERRUPTED after Ctrl-C or SIGTERM, where `when_stopped` is printed. A warning is one line,
    too. A reader of the output that ends early, such as `head`, does not end the command: the rest
    of the output is dropped.

    extra: the distribution extra that `command` needs; the error for a missing module names it.
    """
    with lasting_streams():
        try:
            with warnings.catch_warnings(), _terminated_as_interrupted():
                warnings.showwarning = _print_warning
                status = command() or 0
            sys.stdout.flush()
            return status
        except RnaError as error:
            return _fail(str(error), debug)
        except ModuleNotFoundError as error:
            if extra is None or error.name is None or error.name.startswith("rna_"):
                raise
            return _fail(f"no module {error.name!r}: {install_hint(extra)}", debug)
        except OSError as error:
            return _fail(_error_text(error), debug)
        except (MemoryError, RuntimeError) as error:
            if (text := memory_text(error)) is None:
                raise
            return _fail(text, debug)
        except KeyboardInterrupt:
            print(f"stopped; {when_stopped}", file=sys.stderr)
            return INTERRUPTED


@contextmanager
def _terminated_as_interrupted() -> Iterator[None]:
    """SIGTERM acts like Ctrl-C, so that workers are ended and temporary files removed.

    One whose exception Python ignores, as in a destructor, comes again soon after.
    """

    timers: list[threading.Timer] = []

    def interrupt(_: int, frame: Any) -> None:
        handler = signal.getsignal(signal.SIGINT)
        if not callable(handler):  # ignored, as in the background of a shell script
            raise KeyboardInterrupt
        handler(signal.SIGINT, frame)

    def interrupt_again(ignored: Any) -> None:
        if ignored.exc_type is KeyboardInterrupt and sys.platform != "win32":
            main = threading.main_thread().ident
            timers.append(threading.Timer(0.05, signal.pthread_kill, (main, signal.SIGTERM)))
            timers[-1].start()
        else:
            hook(ignored)

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before, hook = signal.signal(signal.SIGTERM, interrupt), sys.unraisablehook
    sys.unraisablehook = interrupt_again
    try:
        yield
    finally:
        for timer in timers:  # SIGTERM ends what comes after this block
            timer.cancel()
        sys.unraisablehook = hook
        signal.signal(signal.SIGTERM, before)


def _error_text(error: OSError) -> str:
    reason = error.strerror or str(error) or type(error).__name__
    return reason if error.filename is None else f"{error.filename}: {reason}"


def _fail(message: str, debug: bool) -> int:
    if debug:
        traceback.print_exc()
    else:
        print("error: " + "; ".join(message.splitlines()), file=sys.stderr)
    return 1


def _print_warning(message: Warning | str, *_place: object, **_more: object) -> None:
    print("warning: " + "; ".join(str(message).splitlines()), file=sys.stderr)
