"""Speed of `PartsScene.intersect` against a bare loop over rtcIntersect1, and memory of hair.

    python benchmarks/curves.py --out curves.json
    python benchmarks/curves.py --memory --out curves-memory.json

Prints JSON. The first is on a ball of curls of 19 segments each, all rays once coherent and once
not; the bare loop fills in rays, calls Embree and keeps distance and segment, no more. Runs
alternate and medians are compared. The second writes a package of a million such segments with
random features, renders it with `rna-run` in a process of its own, and tells that process's peak
resident memory.
"""

from __future__ import annotations

import argparse
import os
import platform
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
from evaluate import random_data, random_model, random_tier, unit_part
from numba import prange
from numpy.typing import NDArray
from rays import Rays, camera_rays, random_rays
from report import publish, report_parser

from rna_export.export.precision import Precision
from rna_render.embree import kernels
from rna_render.embree.library import function_address
from rna_render.parts_scene import PartsScene
from rna_sdk.compiled import compiled
from rna_sdk.package import (
    Curves,
    Domain,
    Manifest,
    Provenance,
    write_package,
)

SEGMENTS = 19  # of a strand

SCENE = """
assets: [{path: curls.rna}]
camera: {position: [0, 0, 4], look_at: [0, 0, 0], vertical_fov_deg: 36}
lights:
  - {type: directional, direction: [1, 2, 1], irradiance: [3, 3, 3]}
  - {type: environment, radiance: [1, 1, 1]}
"""


def main() -> None:
    args = arguments()
    machine = {
        "machine": platform.processor() or platform.machine(),
        "cores": len(os.sched_getaffinity(0)),
    }
    measured = memory(args) if args.memory else speed(args)
    publish(machine | measured, args.out)


def arguments() -> argparse.Namespace:
    parser = report_parser(
        description="Measure ray tracing of curves; prints JSON.",
        epilog="example: python benchmarks/curves.py --out curves.json",
    )
    parser.add_argument("--strands", type=int, default=40_000, help="of 19 segments, for the speed")
    parser.add_argument("--rays", type=int, default=2**18, help="rays a run")
    parser.add_argument("--memory", action="store_true", help="measure memory instead of speed")
    parser.add_argument("--segments", type=int, default=1_000_000, help="for the memory, about")
    parser.add_argument("--resolution", default="1280x720", help="of the image for the memory")
    parser.add_argument("--samples", type=int, default=4, help="a pixel, for the memory")
    return parser.parse_args()


def speed(args: argparse.Namespace) -> dict[str, Any]:
    """Rates of both loops on both kinds of rays."""
    curves = curls(args.strands)
    start = time.perf_counter()
    scene = PartsScene([curves])
    return {
        "segments": len(curves.segments()),
        "build_s": round(time.perf_counter() - start, 3),
        "rays": args.rays,
        "repeats": args.repeats,
        "coherent": compare(scene, camera_rays(args.rays), args.repeats),
        "incoherent": compare(scene, random_rays(args.rays), args.repeats),
    }


def compare(scene: PartsScene, rays: Rays, repeats: int) -> dict[str, Any]:
    """Rates in M rays/s, their ratio, and the share of rays that both say hit the same segment."""
    t, segment = np.empty(len(rays[0]), np.float32), np.empty(len(rays[0]), np.int32)
    target = function_address("rtcIntersect1"), scene.handle.handle
    bare(*target, *rays, t, segment)
    hits = scene.intersect(*rays)
    seconds: dict[str, list[float]] = {"intersect": [], "bare_loop": []}
    for _ in range(repeats):
        start = time.perf_counter()
        scene.intersect(*rays)
        middle = time.perf_counter()
        bare(*target, *rays, t, segment)
        end = time.perf_counter()
        seconds["intersect"].append(middle - start)
        seconds["bare_loop"].append(end - middle)
    rates = {name: len(t) / 1e6 / float(np.median(s)) for name, s in seconds.items()}
    return {
        "hit_share": round(float(np.mean(hits.primitive >= 0)), 4),
        "same_segment_share": round(float(np.mean(hits.primitive == segment)), 6),
        "mrays_s": {name: round(rate, 3) for name, rate in rates.items()},
        "ratio": round(rates["intersect"] / rates["bare_loop"], 3),
    }


@compiled(parallel=True, fastmath=())
def bare(function, scene, origins, directions, t, segment):  # type: ignore[no-untyped-def]
    """Only what it takes to call Embree: one struct a chunk, filled and read ray by ray."""
    n = len(t)
    for chunk in prange((n + kernels.CHUNK - 1) // kernels.CHUNK):
        words = np.empty(kernels.RAY_HIT_WORDS + kernels.ALIGNMENT // 4, np.float32)
        ray = words[(-words.ctypes.data) % kernels.ALIGNMENT // 4 :]
        bits = ray.view(np.uint32)
        for i in range(chunk * kernels.CHUNK, min(n, (chunk + 1) * kernels.CHUNK)):
            ray[kernels.RAY_ORIGIN : kernels.RAY_ORIGIN + 3] = origins[i]
            ray[kernels.RAY_DIRECTION : kernels.RAY_DIRECTION + 3] = directions[i]
            ray[kernels.RAY_TNEAR] = ray[kernels.RAY_TIME] = 0.0
            ray[kernels.RAY_TFAR] = np.inf
            bits[kernels.RAY_MASK] = kernels.INVALID_ID
            bits[kernels.RAY_ID] = bits[kernels.RAY_FLAGS] = 0
            bits[kernels.HIT_PRIMITIVE] = bits[kernels.HIT_GEOMETRY] = kernels.INVALID_ID
            kernels.call_embree(function, scene, ray.ctypes.data, 0)
            t[i] = ray[kernels.RAY_TFAR]
            segment[i] = np.int32(bits[kernels.HIT_PRIMITIVE])


def memory(args: argparse.Namespace) -> dict[str, Any]:
    """Peak memory and time of `rna-run` on about `args.segments` segments.

    The peak would be this process's own, if that were the higher one.
    """
    strands = -(-args.segments // SEGMENTS)
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        write_curls(place / "curls.rna", curls(strands))
        (place / "scene.yaml").write_text(SCENE)
        package_bytes = (place / "curls.rna").stat().st_size
        command = [sys.executable, "-m", "rna_render.cli", str(place / "scene.yaml")]
        command += ["--out", str(place / "out.exr"), "--resolution", args.resolution]
        command += ["--samples", str(args.samples)]
        quiet = [(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)]
        start = time.perf_counter()
        process = os.posix_spawn(sys.executable, command, os.environ, file_actions=quiet)
        _, status, usage = os.wait4(process, 0)
        seconds = time.perf_counter() - start
    if status:
        raise SystemExit(f"rna-run failed with status {os.waitstatus_to_exitcode(status)}")
    return {
        "segments": strands * SEGMENTS,
        "package_mb": round(package_bytes / 1e6, 1),
        "resolution": args.resolution,
        "samples": args.samples,
        "seconds": round(seconds, 2),
        "peak_gb": round(usage.ru_maxrss * 1024 / 1e9, 3),
    }


def write_curls(path: Path, curves: Curves) -> None:
    """A package of these curves, random features and a random decoder of width 64."""
    model = random_model("fiber", width=64, resolution=256, channels=8)
    tier = random_tier("random", model, Precision())
    manifest = Manifest(
        generator="benchmarks/curves.py",
        name="curls",
        parts=(unit_part("fiber"),),
        domain=Domain(wo="sphere", wi="sphere"),
        tiers=(tier,),
        provenance=Provenance(source="random numbers", tool="benchmarks/curves.py"),
        license="Apache-2.0",
    )
    write_package(path, manifest, [curves], {tier.name: [random_data(model, tier.parts[0])]})


def curls(strands: int) -> Curves:
    """Helices of 2 to 4 turns that grow out of a ball of radius 0.5 to 0.9 from its centre."""
    rng = np.random.default_rng(0)
    axis = unit(rng.normal(size=(strands, 1, 3)))
    side = unit(np.cross(axis, rng.normal(size=(strands, 1, 3))))
    t = np.linspace(0, 1, SEGMENTS + 1)[None, :, None]
    turn = rng.uniform(2, 4, (strands, 1, 1)) * 2 * np.pi * t
    circle = np.cos(turn) * side + np.sin(turn) * np.cross(axis, side)
    points = (0.5 + 0.4 * t) * axis + 0.03 * circle
    radii = np.broadcast_to(0.002 - 0.001 * t[:, :, 0], points.shape[:2])
    return Curves(
        points=points.reshape(-1, 3).astype(np.float32),
        radii=radii.reshape(-1).astype(np.float32),
        offsets=np.arange(0, points.shape[0] * (SEGMENTS + 1) + 1, SEGMENTS + 1, dtype=np.uint32),
    )


def unit(vectors: NDArray[np.floating]) -> NDArray[np.floating]:
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


if __name__ == "__main__":
    main()
