"""Write `spec/conformance/`, or compare it with what this script would write."""

import sys

from rna_sdk.commands.console import command_parser
from tests.conformance.kit.files import differences, kit_files, write_files
from tests.conftest import REPOSITORY

KIT = REPOSITORY / "spec" / "conformance"


def main() -> int:
    parser = command_parser(
        "python -m tests.conformance.kit",
        "Write the conformance kit of the format.",
        "python -m tests.conformance.kit",
    )
    parser.add_argument(
        "--check", action="store_true", help="write nothing; exit 1 if a file is stale"
    )
    options = parser.parse_args()
    files = kit_files()
    if options.check:
        stale = differences(KIT, files)
        print("\n".join(stale) or "the kit is current")
        return 1 if stale else 0
    write_files(KIT, files)
    print(f"wrote {len(files)} files, {sum(map(len, files.values())) / 2**20:.1f} MiB, to {KIT}")
    print("next: rna-conform -- python -m rna_render.conformance_reader")
    return 0


if __name__ == "__main__":
    sys.exit(main())
