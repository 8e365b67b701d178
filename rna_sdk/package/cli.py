"""`rna-validate`: check packages and print what is wrong with them."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from dataclasses import asdict

from rna_sdk.console import command_parser
from rna_sdk.package.issues import Issue, is_valid
from rna_sdk.package.validator import validate

VALID, INVALID = 0, 1
"""Exit statuses; argparse exits with 2 for wrong usage."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command. Returns 0 when every file is valid, 1 when one is not."""
    options = _parser().parse_args(arguments)
    status, records = VALID, []
    for path in options.files:
        try:
            issues = validate(path)
        except Exception as error:  # a defect of the validator: say so, in one line, and go on
            if options.debug:
                raise
            print(f"{path}: internal error, {error!r}; try --debug", file=sys.stderr)
            status = INVALID
            continue
        if not is_valid(issues):
            status = INVALID
        if options.json:
            records.append(_as_json(path, issues))
        else:
            _print_report(path, issues)
    if options.json:
        print(json.dumps(records, indent=2))
    return status


def _parser() -> argparse.ArgumentParser:
    parser = command_parser(
        "rna-validate",
        "Check .rna packages against the format.",
        "rna-validate asset.rna",
        usage=argparse.SUPPRESS,
        epilog="Prints one line for each issue, then `FILE: valid` or `FILE: invalid`; a package "
        "with\nwarnings alone is valid. Exit status: 0 all valid, 1 one invalid or unreadable, 2 "
        "wrong usage.\nCodes of issues: spec/ISSUES.md.",
    )
    parser.add_argument(
        "files", nargs="+", metavar="FILE", help="package to check (path), one or more"
    )
    parser.add_argument("--json", action="store_true", help="print JSON (default: text)")
    parser.add_argument("--debug", action="store_true", help="show tracebacks (default: off)")
    return parser


def _as_json(path: str, issues: list[Issue]) -> dict[str, object]:
    return {"file": path, "valid": is_valid(issues), "issues": [asdict(i) for i in issues]}


def _print_report(path: str, issues: list[Issue]) -> None:
    for issue in issues:
        print(f"{path}: {issue}")
    print(f"{path}: {'valid' if is_valid(issues) else 'invalid'}")


if __name__ == "__main__":
    sys.exit(main())
