"""`rna-validate`: check packages and print their faults."""

import argparse
import json
import sys
from collections.abc import Sequence
from dataclasses import asdict

from rna_sdk.commands.console import command_parser, memory_text, run_command
from rna_sdk.package.command.package_info import contents
from rna_sdk.package.issues import is_valid
from rna_sdk.package.validator import Inspection, inspect

VALID, INVALID = 0, 1
"""Exit statuses; argparse exits with 2 for wrong usage."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command. Returns 0 when every file is valid, 1 when one is not."""
    options = _parser().parse_args(arguments)
    return run_command(lambda: _run(options), options.debug, "no verdict on the other files")


def _run(options: argparse.Namespace) -> int:
    status, records = VALID, []
    for path in options.files:
        try:
            inspection = inspect(path)
        except Exception as error:  # say so, in one line, and go on
            if options.debug:
                raise
            defect = f"internal error, {error!r}; try --debug"  # of the validator
            print(f"{path}: {memory_text(error) or defect}", file=sys.stderr)
            status = INVALID
            continue
        if not is_valid(inspection.issues):
            status = INVALID
        if options.json:
            records.append(_as_json(path, inspection))
        else:
            _print_report(path, inspection)
    if options.json:
        print(json.dumps(records, indent=2))
    return status


def _parser() -> argparse.ArgumentParser:
    parser = command_parser(
        "rna-validate",
        "Validate .rna packages against the specification.",
        "rna-validate asset.rna",
        usage=argparse.SUPPRESS,
        epilog="Prints one line per issue, one line per part (if there are several, or it "
        "has more\n"
        "than transport), then `FILE: valid` or `FILE: invalid`. Warnings do not make a package\n"
        "invalid. Exit status: 0 all valid, 1 any invalid or unreadable, 2 bad usage.\n"
        "Issue codes: spec/ISSUES.md.",
    )
    parser.add_argument("files", nargs="+", metavar="FILE", help="packages to validate (paths)")
    parser.add_argument("--json", action="store_true", help="print JSON (default: text)")
    return parser


def _as_json(path: str, inspection: Inspection) -> dict[str, object]:
    """Parts are null where the manifest cannot be read."""
    return {
        "file": path,
        "valid": is_valid(inspection.issues),
        "parts": inspection.manifest
        and [
            {"name": part.name, "kind": part.kind, **dict.fromkeys(has, True)}
            for part, has in contents(inspection.manifest)
        ],
        "issues": [asdict(issue) for issue in inspection.issues],
    }


def _print_report(path: str, inspection: Inspection) -> None:
    for issue in inspection.issues:
        print(f"{path}: {issue}")
    parts = contents(inspection.manifest) if inspection.manifest else []
    if len(parts) > 1 or any(has for _, has in parts):
        for part, has in parts:
            print(f"{path}: part {part.name}: {', '.join((part.kind, *has))}")
    print(f"{path}: {'valid' if is_valid(inspection.issues) else 'invalid'}")


if __name__ == "__main__":
    sys.exit(main())
