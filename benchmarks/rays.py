"""Speed of `TriangleScene.intersect` against embreex's own `run`, on the same rays.

    python benchmarks/rays.py --out rays.json

Prints JSON. Both use the same Embree library on the same mesh, an icosphere of 82k triangles;
runs alternate and medians are compared. `run` is asked both for hit triangles alone and for all
that it can tell; the ratio is against the faster of the two, though `intersect` always gives
distance, triangle and barycentrics.
"""

from __future__ import annotations

import argparse
import os
import platform
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import trimesh
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene
from numpy.typing import NDArray
from report import publish, report_parser

from rna_render.embree import TriangleScene

SUBDIVISIONS = 6  # of an icosahedron: 81,920 triangles
Rays = tuple[NDArray[np.float32], NDArray[np.float32]]


def main() -> None:
    args = arguments()
    ball = trimesh.creation.icosphere(subdivisions=SUBDIVISIONS)
    positions = np.asarray(ball.vertices, np.float32)
    triangles = np.asarray(ball.faces, np.uint32)
    ours = TriangleScene([(positions, triangles)])
    theirs = EmbreeScene()
    TriangleMesh(theirs, positions, triangles.astype(np.int32))
    report = {
        "machine": platform.processor() or platform.machine(),
        "cores": len(os.sched_getaffinity(0)),
        "triangles": len(triangles),
        "rays": args.rays,
        "repeats": args.repeats,
        **{
            name: compare(ours, theirs, rays, args.repeats)
            for name, rays in (
                ("coherent", camera_rays(args.rays)),
                ("incoherent", random_rays(args.rays)),
            )
        },
    }
    publish(report, args.out)


def arguments() -> argparse.Namespace:
    parser = report_parser(
        description="Measure ray tracing speed against embreex; prints JSON.",
        epilog="example: python benchmarks/rays.py --out rays.json",
    )
    parser.add_argument("--rays", type=int, default=2**18, help="rays a run")
    return parser.parse_args()


def compare(ours: TriangleScene, theirs: EmbreeScene, rays: Rays, repeats: int) -> dict[str, Any]:
    """Rates in M rays/s, their ratio, and the share of rays that both say hit the same triangle."""
    hits, triangles = ours.intersect(*rays), theirs.run(*rays)
    runs: dict[str, Callable[[], object]] = {
        "intersect": lambda: ours.intersect(*rays),
        "embreex_triangles_alone": lambda: theirs.run(*rays),
        "embreex_everything": lambda: theirs.run(*rays, output=True),
    }
    seconds: dict[str, list[float]] = {name: [] for name in runs}
    for _ in range(repeats):
        for name, action in runs.items():
            start = time.perf_counter()
            action()
            seconds[name].append(time.perf_counter() - start)
    rates = {name: len(rays[0]) / 1e6 / float(np.median(s)) for name, s in seconds.items()}
    peer = max(rates["embreex_triangles_alone"], rates["embreex_everything"])
    return {
        "hit_share": round(float(np.mean(hits.triangle >= 0)), 4),
        "same_triangle_share": round(float(np.mean(hits.triangle == triangles)), 6),
        "mrays_s": {name: round(rate, 2) for name, rate in rates.items()},
        "ratio": round(rates["intersect"] / peer, 2),
    }


def camera_rays(n: int) -> Rays:
    """Rays of a pinhole camera that looks at the ball, row of pixels by row."""
    side = int(np.ceil(np.sqrt(n)))
    x, y = np.meshgrid(np.linspace(-0.35, 0.35, side), np.linspace(0.35, -0.35, side))
    directions = np.stack([x, y, -np.ones_like(x)], axis=2).reshape(-1, 3)[:n]
    origins = np.zeros((n, 3), np.float32) + np.float32([0, 0, 4])
    return origins, unit(directions)


def random_rays(n: int) -> Rays:
    """Rays from all around the ball towards random points in it: neighbours share nothing."""
    rng = np.random.default_rng(0)
    origins = 3 * unit(rng.normal(size=(n, 3)))
    targets = rng.uniform(-0.8, 0.8, (n, 3))
    return origins, unit(targets - origins)


def unit(vectors: NDArray[np.floating]) -> NDArray[np.float32]:
    return (vectors / np.linalg.norm(vectors, axis=1, keepdims=True)).astype(np.float32)


if __name__ == "__main__":
    main()
