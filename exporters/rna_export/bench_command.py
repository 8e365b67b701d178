"""`rna-bench`: starts the benchmarks, which are in the repository and not in the wheel."""

import sys

_WHERE = (
    "error: the benchmarks are not installed: they run from a clone of the repository, after "
    "pip install -e '.[bench]'"
)


def main() -> int:
    """Entry point; returns the exit status."""
    try:
        from rna_bench.cli import main as measure
    except ModuleNotFoundError as error:
        if error.name != "rna_bench":
            raise
        print(_WHERE, file=sys.stderr)
        return 1
    status: int = measure()
    return status


if __name__ == "__main__":
    sys.exit(main())
