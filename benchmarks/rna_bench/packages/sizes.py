"""Package size by storage options: geometry, planes, compression.

    rna-bench package-bytes examples/quickstart/toy.rna examples/fibers/curly_ball.rna

Geometry as float32 or quantised, planes as float16 or int8, entries raw or coded (RNA_deflate).
Each is a package written and validated; sizes are of whole files.
"""

from __future__ import annotations

import argparse
import tempfile
from itertools import product
from pathlib import Path
from typing import Any

from rna_bench.bench_options import add_out
from rna_bench.results import publish
from rna_export.export.precision import stored_planes
from rna_sdk.package import Package, TierData, float_planes, quantise, write_package
from rna_sdk.package.packing import Unpacked


def run(args: argparse.Namespace) -> None:
    publish({"packages": [measured(path) for path in args.packages]}, args)


def measured(path: Path) -> dict[str, Any]:
    """Bytes of the package's first tier alone, in each form."""
    sizes = {}
    with tempfile.TemporaryDirectory() as folder:
        for geometry, planes in product(("float32", "quantised"), ("float16", "int8")):
            out = Path(folder) / "x.rna"
            _rewritten(path, out, geometry == "quantised", planes)
            name = f"{geometry} geometry, {planes} planes"
            sizes[name] = {"raw": out.stat().st_size}
            Unpacked.read(out).deflated().write(out)
            sizes[name]["coded"] = out.stat().st_size
    return {"package": path.name, "bytes": sizes}


def _rewritten(path: Path, out: Path, quantised: bool, precision: Any) -> None:
    with Package.open(path) as package:
        tier = package.manifest.tiers[0]
        part = tier.parts[0].model_copy(update={"plane_precision": precision})
        tier = tier.model_copy(update={"parts": (part,)})
        manifest = package.manifest.model_copy(update={"tiers": (tier,)})
        planes = stored_planes(float_planes(package.planes(tier.name)), precision)
        data = TierData(planes, bytes(package.decoder(tier.name)))
        geometry = package.geometry()
        kept = quantise(geometry) if quantised else geometry
        write_package(out, manifest, [kept], {tier.name: [data]})


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("packages", nargs="+", type=Path, help="of one part each")
    add_out(parser)
