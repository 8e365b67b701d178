"""Help on the arguments after `--`: the source's own `--help`."""

import subprocess
from pathlib import Path

from rna_export.blender.rna_sources.source_formats import SOURCE_FORMATS, parser
from rna_export.capture.blender_process.blender_env import find_python
from rna_sdk.errors import CaptureError

_WITH_OPTIONS = {suffix: f.options for suffix, f in SOURCE_FORMATS.items() if f.options}
_SCRIPT_HELP = Path(__file__).parents[2] / "blender" / "script_help.py"


def is_requested(arguments: tuple[str, ...]) -> bool:
    """Whether the arguments after `--` ask for help."""
    return bool({"-h", "--help"} & set(arguments))


def show(source: Path) -> None:
    """Print the source's options; a script, which must exist, runs in Blender to tell its own."""
    suffix = source.suffix.lower()
    if suffix in _WITH_OPTIONS:
        parser(suffix, _WITH_OPTIONS[suffix]).print_help()
    elif suffix == ".py":
        if not source.is_file():
            raise CaptureError(f"{source}: no such file")
        command = [str(find_python()), str(_SCRIPT_HELP), str(source.resolve()), "--help"]
        if subprocess.run(command).returncode != 0:
            raise CaptureError(f"{source}: the script has no --help of its own")
    else:
        raise CaptureError(
            f"{source}: nothing can follow --, only for .py, {', '.join(_WITH_OPTIONS)}"
        )
