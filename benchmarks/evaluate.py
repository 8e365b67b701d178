"""Speed of an asset's `evaluate` against the machine's own float32 matrix product.

    python benchmarks/evaluate.py --widths 64 --out evaluate.json
    python benchmarks/evaluate.py --kind fiber --resolution 256 --widths 64

Prints JSON, one record a decoder width. Matrix products and evaluations alternate in one run,
both on all cores the process may use, and medians are compared; so `share_of_gemm` can be read
on any machine that does nothing else meanwhile. The packages hold random weights.
"""

from __future__ import annotations

import argparse
import platform
import tempfile
import time
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray
from onnx import TensorProto, helper, numpy_helper
from report import publish, report_parser

from rna_bench.step_times import step_times
from rna_sdk.package import (
    Bounds,
    Curves,
    Domain,
    Manifest,
    Mesh,
    Package,
    Provenance,
    Tier,
    TierData,
    write_package,
)
from rna_sdk.runtime import Asset, load

INPUTS = {
    "surface": ("features", "normal", "wo", "wi", "half_vector"),
    "fiber": ("features", "tangent", "h", "wo", "wi", "fiber_angles", "fiber_lobes"),
}
HIDDEN_LAYERS = 4
GEMM_SIZE = 2048
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
    parser.add_argument("--resolution", type=int, default=512, help="texels along a plane's side")
    parser.add_argument("--channels", type=int, default=8, help="features a texel")
    parser.add_argument("--seconds", type=float, default=0.3, help="about, for one evaluation")
    return parser.parse_args()


def measure(width: int, args: argparse.Namespace) -> dict[str, Any]:
    """The record of one decoder width."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "random.rna"
        write_random_package(path, args.kind, width, args.resolution, args.channels)
        asset = load(path)
        n = batch_size(asset, args.seconds)
        batches = {
            "random": arguments_of(asset, random_points(n)),
            "coherent": arguments_of(asset, sphere_scan(n)),
        }
        gemm, rates = alternate(asset, batches, args.repeats)
        with Package.open(path) as package:
            split = {name: step_times(package, batch) for name, batch in batches.items()}
    columns = asset.tier.query_width
    flop = 2 * sum(a * b for a, b in pairwise([columns, *[width] * HIDDEN_LAYERS, 6]))
    return {
        "width": width,
        "threads": asset.threads,
        "queries": n,
        "gemm_gflops": round(gemm, 1),
        **{
            name: {
                "evaluate_mqueries_s": round(rate / 1e6, 3),
                "evaluate_gflops": round(rate * flop / 1e9, 1),
                "share_of_gemm": round(rate * flop / 1e9 / gemm, 3),
                "ns_per_query_one_thread": split[name],
            }
            for name, rate in rates.items()
        },
    }


def batch_size(asset: Asset, seconds: float) -> int:
    """A number of queries that takes about this long."""
    trial = arguments_of(asset, random_points(65_536))
    asset.evaluate(*trial)
    rate = len(trial[0]) / seconds_of(lambda: asset.evaluate(*trial))
    return int(np.clip(rate * seconds, 16_384, 2**22))


def alternate(
    asset: Asset, batches: dict[str, Arrays], repeats: int
) -> tuple[float, dict[str, float]]:
    """GFLOP/s of the matrix product and queries/s of each batch: medians of alternating runs."""
    a, b = np.random.default_rng(0).random((2, GEMM_SIZE, GEMM_SIZE), np.float32)
    size = len(next(iter(batches.values()))[0])
    results = np.zeros((size, 3), np.float32), np.zeros((size, 3), np.float32)
    gemm: list[float] = []
    rates: dict[str, list[float]] = {name: [] for name in batches}
    for _ in range(repeats + 1):  # the first run warms caches and threads
        gemm.append(2 * GEMM_SIZE**3 / 1e9 / seconds_of(lambda: a @ b))
        for name, batch in batches.items():
            taken = seconds_of(lambda batch=batch: asset.evaluate(*batch, out=results))
            rates[name].append(len(batch[0]) / taken)
    return float(np.median(gemm[1:])), {k: float(np.median(v[1:])) for k, v in rates.items()}


def seconds_of(action: Callable[[], object]) -> float:
    start = time.perf_counter()
    action()
    return time.perf_counter() - start


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
    """A package of one tier with random float16 planes and a random decoder."""
    tier = Tier(
        name="random",
        planes="features/random.safetensors",
        decoder="decoders/random.onnx",
        inputs=INPUTS[kind],
        resolution=resolution,
        channels=channels,
        plane_precision="float16",
        decoder_precision="float32",
    )
    manifest = Manifest(
        generator="benchmarks/evaluate.py",
        name="random",
        kind=kind,
        bounds=Bounds(min=(-1, -1, -1), max=(1, 1, 1)),
        domain=Domain(wo="sphere", wi="sphere"),
        tiers=(tier,),
        provenance=Provenance(source="random numbers", tool="benchmarks/evaluate.py"),
        license="Apache-2.0",
    )
    rng = np.random.default_rng(0)
    planes = rng.normal(0, 0.5, (3, resolution, resolution, channels)).astype(np.float16)
    data = TierData(planes=planes, decoder=random_decoder(tier.query_width, width))
    geometry = ball() if kind == "surface" else strand()
    write_package(path, manifest, geometry, {tier.name: data})


def ball() -> Mesh:
    shape = trimesh.creation.icosphere(subdivisions=2, radius=0.95)
    positions = np.asarray(shape.vertices, np.float32)
    faces = np.asarray(shape.faces, np.uint32)
    return Mesh(positions=positions, normals=unit(positions), uvs=None, triangles=faces)


def strand() -> Curves:
    points = np.float32([[0, -0.9, 0], [0, 0.9, 0]])
    return Curves(points, np.full(2, 0.01, np.float32), np.array([0, 2], np.uint32))


def random_decoder(columns: int, width: int) -> bytes:
    """The graph that assets have, random: clamp, Gemm and Relu a layer, exp(y) - 1, clamped."""
    rng = np.random.default_rng(2)
    constants = {"low": -65504.0, "high": 65504.0, "zero": 0.0, "largest": 11.0, "one": 1.0}
    tensors = [numpy_helper.from_array(np.float32(v), name) for name, v in constants.items()]
    nodes = [helper.make_node("Clip", ["queries", "low", "high"], ["x0"])]
    for k, shape in enumerate(pairwise([columns, *[width] * HIDDEN_LAYERS, 6])):
        weight = rng.normal(0, (2 / shape[0]) ** 0.5, shape).astype(np.float32)
        bias = rng.normal(0, 0.1, shape[1]).astype(np.float32)
        tensors += [
            numpy_helper.from_array(weight, f"w{k}"),
            numpy_helper.from_array(bias, f"b{k}"),
        ]
        nodes.append(helper.make_node("Gemm", [f"x{k}", f"w{k}", f"b{k}"], [f"y{k}"]))
        nodes.append(helper.make_node("Relu", [f"y{k}"], [f"x{k + 1}"]))
    nodes[-1] = helper.make_node("Clip", [f"y{HIDDEN_LAYERS}", "zero", "largest"], ["log"])
    nodes.append(helper.make_node("Exp", ["log"], ["exp"]))
    nodes.append(helper.make_node("Sub", ["exp", "one"], ["transport"]))
    sides = [("queries", columns), ("transport", 6)]
    values = [helper.make_tensor_value_info(s, TensorProto.FLOAT, ["N", k]) for s, k in sides]
    graph = helper.make_graph(nodes, "decoder", values[:1], values[1:], tensors)
    opsets = [helper.make_opsetid("", 17)]
    model: bytes = helper.make_model(graph, opset_imports=opsets, ir_version=8).SerializeToString()
    return model


if __name__ == "__main__":
    main()
