"""Speed of an asset's `evaluate` against the machine's own float32 matrix product.

    python benchmarks/evaluate.py --widths 64 --out evaluate.json
    python benchmarks/evaluate.py --widths 64 128 256 512 --precisions float32 int8
    python benchmarks/evaluate.py --kind fiber --resolution 256 --widths 64

Prints JSON, one record a decoder width. Matrix products and evaluations alternate in one run,
both on all cores the process may use, and medians are compared; so `share_of_gemm` can be read
on any machine that does nothing else meanwhile. The packages hold random weights.
"""

from __future__ import annotations

import argparse
import platform
import tempfile
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import torch
import trimesh
from numpy.typing import NDArray
from report import publish, report_parser

from rna_bench.step_times import step_times
from rna_export.export.decoder import export_decoder, random_queries
from rna_export.export.int8_decoder import int8_decoder
from rna_export.export.precision import PRECISIONS, Precision, stored_planes
from rna_export.machine import GEMM_FLOP, matrix_product, seconds_of
from rna_export.training.model import NeuralAsset
from rna_export.training.presets import PRESETS, ModelConfig
from rna_sdk.package import (
    Bounds,
    Curves,
    Domain,
    Manifest,
    Mesh,
    Package,
    Part,
    Provenance,
    Tier,
    TierData,
    TierPart,
    write_package,
)
from rna_sdk.package.manifest_fields import GEOMETRY_ENTRIES
from rna_sdk.runtime import Asset, load

INPUTS = {kind: presets["small"].model.inputs for kind, presets in PRESETS.items()}
HIDDEN_LAYERS = 4
Arrays = tuple[NDArray[np.float32], ...]


def main() -> None:
    args = arguments()
    report: dict[str, Any] = {
        "machine": platform.processor() or platform.machine(),
        "planes": [3, args.resolution, args.resolution, args.channels],
        "inputs": INPUTS[args.kind],
        "hidden_layers": HIDDEN_LAYERS,
        "repeats": args.repeats,
        "widths": [measure(width, args) for width in args.widths],
    }
    publish(report, args.out)


def arguments() -> argparse.Namespace:
    parser = report_parser(
        description="Measure evaluation speed against numpy's matrix product; prints JSON.",
        epilog="example: python benchmarks/evaluate.py --widths 64 --out evaluate.json",
    )
    parser.add_argument("--kind", choices=list(INPUTS), default="surface", help="of the asset")
    parser.add_argument("--widths", type=int, nargs="+", default=[16, 32, 64, 128, 256, 512])
    parser.add_argument(
        "--precisions", nargs="+", choices=list(PRECISIONS), default=["float32"], help="of tiers"
    )
    parser.add_argument("--resolution", type=int, default=512, help="texels along a plane's side")
    parser.add_argument("--channels", type=int, default=8, help="features a texel")
    parser.add_argument("--seconds", type=float, default=0.3, help="about, for one evaluation")
    return parser.parse_args()


def measure(width: int, args: argparse.Namespace) -> dict[str, Any]:
    """The record of one decoder width."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "random.rna"
        write_random_package(path, args.kind, width, args.resolution, args.channels)
        assets = {name: load(path, tier=name) for name in args.precisions}
        asset = next(iter(assets.values()))
        n = batch_size(asset, args.seconds)
        batches = {
            "random": arguments_of(asset, random_points(n)),
            "coherent": arguments_of(asset, sphere_scan(n)),
        }
        gemm, rates = alternate(assets, batches, args.repeats)
        columns = asset.tier_part.query_width
        flop = 2 * sum(a * b for a, b in pairwise([columns, *[width] * HIDDEN_LAYERS, 6]))
        with Package.open(path) as package:
            records: dict[str, Any] = {precision: {} for precision in assets}
            for (precision, name), rate in rates.items():
                records[precision][name] = {
                    "evaluate_mqueries_s": round(rate / 1e6, 3),
                    "evaluate_gflops": round(rate * flop / 1e9, 1),
                    "share_of_gemm": round(rate * flop / 1e9 / gemm, 3),
                    "times_first": round(rate / rates[args.precisions[0], name], 2),
                    "ns_per_query_one_thread": step_times(package, precision, batches[name]),
                }
    return {
        "width": width,
        "threads": asset.threads,
        "queries": n,
        "gemm_gflops": round(gemm, 1),
        **records,
    }


def batch_size(asset: Asset, seconds: float) -> int:
    """A number of queries that takes about this long."""
    trial = arguments_of(asset, random_points(65_536))
    asset.evaluate(*trial)
    rate = len(trial[0]) / seconds_of(lambda: asset.evaluate(*trial))
    return int(np.clip(rate * seconds, 16_384, 2**22))


def alternate(
    assets: dict[str, Asset], batches: dict[str, Arrays], repeats: int
) -> tuple[float, dict[tuple[str, str], float]]:
    """GFLOP/s of the matrix product, and queries/s of each asset and batch, by their names.

    Medians of alternating runs.
    """
    product = matrix_product()
    size = len(next(iter(batches.values()))[0])
    results = np.zeros((size, 3), np.float32), np.zeros((size, 3), np.float32)
    gemm: list[float] = []
    rates: dict[tuple[str, str], list[float]] = {(p, b): [] for p in assets for b in batches}
    for _ in range(repeats + 1):  # the first run warms caches and threads
        gemm.append(GEMM_FLOP / 1e9 / seconds_of(product))
        for precision, name in rates:
            asset, batch = assets[precision], batches[name]
            taken = seconds_of(lambda a=asset, batch=batch: a.evaluate(*batch, out=results))
            rates[precision, name].append(len(batch[0]) / taken)
    return float(np.median(gemm[1:])), {k: float(np.median(v[1:])) for k, v in rates.items()}


def arguments_of(asset: Asset, points: Arrays) -> Arrays:
    """What `evaluate` takes, from surface points; fibers get the normals for tangents, random h."""
    if asset.kind == "surface":
        return points
    positions, normals, wo, wi = points
    h = np.random.default_rng(3).uniform(-1, 1, len(positions)).astype(np.float32)
    return positions, normals, h, wo, wi


def random_points(n: int) -> Arrays:
    """Points all over the box and all directions: nothing is near what came before it."""
    rng = np.random.default_rng(1)
    positions = rng.uniform(-1, 1, (n, 3)).astype(np.float32)
    return positions, *(unit(rng.normal(size=(n, 3))) for _ in range(3))


def sphere_scan(n: int) -> Arrays:
    """Camera hits on a ball, row of pixels by row, under one distant light."""
    side = int(np.ceil(np.sqrt(n)))
    x, y = np.meshgrid(np.linspace(-0.7, 0.7, side), np.linspace(0.7, -0.7, side))
    normals = unit(np.stack([x, y, np.sqrt(1 - x**2 - y**2)], axis=2).reshape(-1, 3)[:n])
    positions = np.float32(0.95) * normals
    wo = unit(np.array([0, 0, 5]) - positions)
    wi = np.broadcast_to(unit(np.array([[1, 2, 3]])), (n, 3)).copy()
    return positions, normals, wo, wi


def unit(vectors: NDArray[np.floating]) -> NDArray[np.float32]:
    return (vectors / np.linalg.norm(vectors, axis=1, keepdims=True)).astype(np.float32)


def write_random_package(path: Path, kind: str, width: int, resolution: int, channels: int) -> None:
    """A package with random planes and a random decoder, a tier for each of PRECISIONS."""
    model = random_model(kind, width, resolution, channels)
    tiers = [random_tier(name, model, precision) for name, precision in PRECISIONS.items()]
    manifest = Manifest(
        generator="benchmarks/evaluate.py",
        name="random",
        parts=(unit_part(kind),),
        domain=Domain(wo="sphere", wi="sphere"),
        tiers=tuple(tiers),
        provenance=Provenance(source="random numbers", tool="benchmarks/evaluate.py"),
        license="Apache-2.0",
    )
    geometry = ball() if kind == "surface" else strand()
    data = {tier.name: [random_data(model, tier.parts[0])] for tier in tiers}
    write_package(path, manifest, [geometry], data)


def unit_part(kind: str) -> Part:
    """The part of a package, in the box from -1 to 1."""
    bounds = Bounds(min=(-1, -1, -1), max=(1, 1, 1))
    return Part(name="asset", kind=kind, bounds=bounds, geometry=GEOMETRY_ENTRIES[kind])


def random_model(kind: str, width: int, resolution: int, channels: int) -> NeuralAsset:
    """An untrained model over the box from -1 to 1, planes of deviation 0.5."""
    config = ModelConfig(
        inputs=INPUTS[kind],
        width=width,
        hidden_layers=HIDDEN_LAYERS,
        resolution=resolution,
        channels=channels,
    )
    torch.manual_seed(0)
    model = NeuralAsset(config, torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])).eval()
    model.triplane.planes.data.normal_(std=0.5)
    return model


def random_tier(name: str, model: NeuralAsset, precision: Precision) -> Tier:
    part = TierPart(
        planes=f"features/{name}.safetensors",
        decoder=f"decoders/{name}.onnx",
        inputs=model.config.inputs,
        resolution=model.config.resolution,
        channels=model.config.channels,
        plane_precision=precision.planes,
        decoder_precision=precision.decoder,
    )
    return Tier(name=name, parts=(part,))


@torch.no_grad()
def random_data(model: NeuralAsset, part: TierPart) -> TierData:
    planes = stored_planes(model.triplane.planes.detach().numpy(), part.plane_precision)
    layers = None
    if part.decoder_precision == "int8":
        layers = int8_decoder(model, random_queries(model, 20_000, seed=0))
    return TierData(planes=planes, decoder=export_decoder(model, layers))


def ball() -> Mesh:
    shape = trimesh.creation.icosphere(subdivisions=2, radius=0.95)
    positions = np.asarray(shape.vertices, np.float32)
    faces = np.asarray(shape.faces, np.uint32)
    return Mesh(positions=positions, normals=unit(positions), uvs=None, triangles=faces)


def strand() -> Curves:
    points = np.float32([[0, -0.9, 0], [0, 0.9, 0]])
    return Curves(points, np.full(2, 0.01, np.float32), np.array([0, 2], np.uint32))


if __name__ == "__main__":
    main()
