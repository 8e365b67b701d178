"""Error of a package's lobes (RNA_environment) under whole environments.

    rna-bench lobes toy-lobes.rna --environments forest.hdr studio.hdr --out lobes-toy.json

`rna-export --environment` makes such a package. Its lobes are compared with the sum of transport
and environment over 8,192 directions: under two generated environments, and under each file at
three turns about the vertical. Training sees none of them. Strands are measured in pixels of 4 x 4
points, as of a picture of 256 squared, and at single points, too.
"""

import argparse
from collections.abc import Container
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
from tqdm import tqdm

from rna_bench.bench_options import add_out
from rna_bench.results import publish
from rna_export.lobes.environment_training import BAR, filling, parts_with_lobes
from rna_export.lobes.lobe_error import generated_environments, grid_of, lobe_pictures
from rna_render import read_environment
from rna_sdk.errors import RnaError
from rna_sdk.package import EnvironmentValidation, Package, decoder_from_bytes
from rna_sdk.package.manifest.extensions import Environment
from rna_sdk.runtime import load

_TURNS = 3


def run(args: argparse.Namespace) -> None:
    """Measure."""
    report: dict[str, Any] = {"parts": _parts(args.package)}
    pairs = parts_with_lobes(load(args.package))
    environments = _environments(args.environments)
    begun = process_time()
    with tqdm(total=1.0, desc="lobes", bar_format=BAR) as bar:
        points = lobe_pictures(pairs, environments, grid_of(pairs), filling(bar))
    report["cpu_seconds"] = round(process_time() - begun, 1)
    report["environments"] = _rounded(points.of_pixels().errors())
    if grid_of(pairs).rays > 1:
        report["points"] = _rounded(points.errors(), without={"flip"})
    publish(report, args)


def _rounded(
    errors: list[EnvironmentValidation], without: Container[str] = ()
) -> list[dict[str, Any]]:
    return [
        {
            k: v if isinstance(v, str) else np.round(v, 3).tolist()
            for k, v in one
            if k not in without
        }
        for one in errors
    ]


def _parts(path: Path) -> list[dict[str, Any]]:
    """Lobes of each part that has them, and their cost."""
    result = []
    with Package.open(path) as package:
        for k, part in enumerate(package.manifest.parts):
            lobes = package.environment(k)
            if lobes is None:
                continue
            layers = decoder_from_bytes(lobes.decoder, lobes.record.decoder).layers
            entries = lobes.record.decoder, lobes.record.visibility
            sizes = [package.manifest.entries[name].size for name in entries if name is not None]
            result.append(
                {
                    "part": part.name,
                    "kind": part.kind,
                    "lobes": lobes.record.lobes,
                    "multiply_adds": sum(layer.weight.size for layer in layers),
                    "bytes": sum(sizes),
                }
            )
    if not result:
        raise RnaError(f"{path}: found no {Environment.NAME}; rna-export --environment adds it")
    return result


def _environments(files: list[Path]) -> dict[str, np.ndarray]:
    """Texels by name: the generated ones, and the files, each at several turns."""
    result = generated_environments()
    for path in files:
        texels = read_environment(path)
        for turn in range(_TURNS):
            columns = turn * texels.shape[1] // _TURNS
            result[f"{path.stem}-{360 * turn // _TURNS}"] = np.roll(texels, columns, axis=1)
    return result


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options of this command."""
    parser.add_argument("package", type=Path, help="an asset with lobes (path)")
    parser.add_argument(
        "--environments", type=Path, nargs="+", default=[], help=".hdr or .exr files (paths)"
    )
    add_out(parser)
