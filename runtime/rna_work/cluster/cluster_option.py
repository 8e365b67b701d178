"""The option `--cluster` of commands. It imports nothing: `--help` stays fast."""

import argparse


def add_cluster_option(parser: argparse.ArgumentParser) -> None:
    """The option `--cluster`, for `rna_work.executors.open_executor`."""
    parser.add_argument(
        "--cluster",
        metavar="ADDRESS",
        help="run on a Ray cluster: auto (the cluster this machine has joined), ray://HOST:PORT, "
        "or local (start one here) (address, default: this machine, without Ray)",
    )
