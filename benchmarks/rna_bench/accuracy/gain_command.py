"""Measure a source as rna-capture --estimate does, and keep it beside its speed in scenes.

    rna-bench gain toy examples/quickstart/toy.py --scenes benchmarks/results/scenes-toy.json

Writes the asset's row of the table from which estimates are fitted. Without a source the pilot that
the row has stays, for new results of `rna-bench scenes`; without --scenes nothing is written.
Prints the estimate, and its error for each asset of the table, left out of the fit. Arguments after
-- are passed to a source that is a Python script.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rna_sdk.errors import RnaError

if TYPE_CHECKING:
    from rna_export.capture.estimate.pilot import Pilot

SCENES = ("forest", "studio", "lamp")

_LIGHTS = 16  # twice those of the usual pilot


def add_options(p: argparse.ArgumentParser) -> None:
    """The options of the command."""
    p.add_argument("name", help="name of the asset in the table")
    p.add_argument("source", nargs="?", type=Path, help="model that rna-capture reads (path)")
    p.add_argument(
        "--scenes",
        type=Path,
        metavar="JSON",
        help=f"result of `rna-bench scenes`, with the scenes {', '.join(SCENES)} (path, default: "
        "none, write nothing)",
    )
    p.add_argument(
        "--table",
        type=Path,
        metavar="JSON",
        help="table to write into (path, default: the table of the package)",
    )


def run(args: argparse.Namespace) -> None:
    """Measure the source; write its row if its speed is known."""
    from rna_export.capture.estimate.gain import TABLE, gain_text, left_out, table_of

    table = args.table or TABLE
    if args.source is not None:
        pilot, stamp = _pilot(args.source, args.script_arguments), args.stamp
    else:
        pilot, stamp = _known(table, args.name)
    if args.scenes is not None:
        add_row(table, args.name, {"stamp": stamp, "pilot": pilot, "scenes": speeds(args.scenes)})
        print(f"wrote {table}")
    assets = table_of(table) if table.is_file() else {}
    if len(assets) < 2:
        print(f"found {len(assets)} asset in {table}; an estimate needs two")
        return
    print(gain_text(pilot, assets))
    for name, ratio in left_out(assets).items():
        asset = assets[name]
        text = (
            f"{asset.times:.2f} times as fast as Cycles; predicted without it, {ratio:.2f} of that"
        )
        print(f"{name}: noise ratio {asset.pilot.noise_ratio:.2f}, {text}")


def _pilot(path: Path, arguments: Sequence[str]) -> Pilot:
    from rna_export.capture.blender_process import blender_env
    from rna_export.capture.blender_process.blender_process import Source
    from rna_export.capture.capture_run import CaptureWorkers, measured_pilot
    from rna_export.capture.capture_settings import CaptureSettings
    from rna_sdk.errors import CaptureError

    source = Source.captured(path, tuple(arguments), CaptureSettings())
    with tempfile.TemporaryDirectory(prefix="rna-bench-") as scratch:
        workers = CaptureWorkers(blender_env.find_python(), Path(scratch), 1)
        pilot = measured_pilot(source, {}, workers, print, lights=_LIGHTS)
    if pilot is None:
        raise CaptureError(f"{source.path}: no gain is measured where something is not learnt")
    return pilot


def _known(table: Path, name: str) -> tuple[Pilot, dict[str, Any]]:
    """The pilot of an asset in the table, and the stamp of its measurement."""
    from rna_export.capture.estimate.gain import table_of

    assets = table_of(table) if table.is_file() else {}
    if name not in assets:
        raise RnaError(f"{table}: found no asset {name}; give its source")
    return assets[name].pilot, json.loads(table.read_text())["assets"][name]["stamp"]


def speeds(path: Path) -> dict[str, float]:
    """Times as fast as Cycles at the estimate's samples, by scene, of a result."""
    from rna_bench.results import read_scenes
    from rna_export.capture.estimate.gain import SAMPLES

    results = read_scenes(path, lambda result: result["scenes"])
    if missing := [name for name in SCENES if name not in results]:
        raise RnaError(f"{path}: found no scene {', '.join(missing)}; expected {SCENES}")
    times = {
        name: round(row["equal_error"]["times_as_fast"], 3)
        for name in SCENES
        for row in results[name]["ours"]
        if row["samples"] == SAMPLES
    }
    if missing := [name for name in SCENES if name not in times]:
        raise RnaError(f"{path}: found no picture of {SAMPLES} samples in {', '.join(missing)}")
    return times


def add_row(table: Path, name: str, row: dict[str, Any]) -> None:
    """Write a row into the table, in the place of one of its name.

    row: `stamp` of the command that measured the `pilot`, and times as fast by `scenes`.
    """
    from rna_bench.results import write_results

    pilot = {key: float(f"{value:.5g}") for key, value in row["pilot"].model_dump().items()}
    rows = json.loads(table.read_text())["assets"] if table.is_file() else {}
    write_results(table, row["stamp"], {"assets": {**rows, name: {**row, "pilot": pilot}}})
