"""Cost of frames in motion: renders of bent assets against still ones, and what comes before.

    rna-bench motion --out benchmarks/results/motion.json
    rna-bench motion fox.rna --mesh head.obj --out motion.json

Prints JSON, CPU seconds of one thread, medians. Each package stands in its default scene. A still
frame has it at rest; the moving one has the same positions as a motion, so both have the same rays
and the motion alone makes the difference; a bent one is there, too. Of `--mesh` files packages of
random weights are made. What comes before a frame:

    binding    the package's mesh, bound to the source's: once a sequence
    positions  of the source's at a frame, carried over to the package's
    shape      vertex normals and rotations of the parts
    tree       Embree's scene; also of the mesh with each triangle cut into 4 and 16

`ratio` is a moving frame, with positions, shape and all else but the tree, over a still one.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from rna_bench.bench_options import add_out, add_repeats
from rna_bench.checkout import CURLS, FOX, TOY
from rna_bench.results import publish
from rna_bench.speed.random_package import write_random_package
from rna_render import load_world, make_integrator, read_mesh_object, render
from rna_render.scene import AssetModel, SceneFile, read_scene
from rna_render.world.world_loading import Loaded, placed_world
from rna_sdk.kernel_threads import limit_kernel_threads
from rna_sdk.motion import bind, write_motion
from rna_sdk.package import Curves, Mesh
from rna_sdk.runtime import Asset, load
from rna_trace import PartsScene, part_geometry

ANGLE = np.radians(20)
"""Of the bent frame: the turn of the top against the bottom."""

STILL, SAME, BENT = "still", "moving", "bent"

Geometry = Mesh | Curves


def run(args: argparse.Namespace) -> None:
    limit_kernel_threads(1)
    with TemporaryDirectory() as folder:
        packages = [*args.packages]
        for mesh in args.mesh:
            packages.append(Path(folder) / f"{mesh.stem}.rna")
            write_random_package(packages[-1], "surface", 64, 256, 8, unit_mesh(mesh))
        cases = {path.stem: measure(path, Path(folder), args) for path in packages}
    report = {"samples": args.samples, "resolution": args.resolution, "repeats": args.repeats}
    publish({**report, "assets": cases}, args)


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("packages", nargs="*", type=Path, default=[TOY, FOX, CURLS], help="packages")
    add("--mesh", nargs="*", type=Path, default=[], help="glTF, OBJ or PLY files")
    add("--resolution", nargs=2, type=int, default=[320, 180], metavar="N", help="of the images")
    add("--samples", type=int, default=2, help="per pixel")
    add_repeats(parser, 3)
    add_out(parser)


def measure(package: Path, folder: Path, args: argparse.Namespace) -> dict[str, Any]:
    """The record of one package."""
    asset = load(package, threads=1)
    geometries = [part_geometry(part) for part in asset.parts]
    path = folder / f"{package.stem}.rnam"
    frames = [[bent(g, geometries, angle) for g in geometries] for angle in (0.0, ANGLE)]
    write_motion(path, geometries, frames, count=2, rate=24.0)
    still = read_scene(package).with_changes(
        resolution=tuple(args.resolution), samples=args.samples
    )
    files = {STILL: still, **{n: moved(still, path, k) for k, n in enumerate((SAME, BENT))}}
    seconds: dict[str, list[float]] = {}
    loaded = {name: Loaded() for name in files}
    for name, file in files.items():
        load_world(file, loaded=loaded[name])
    for turn in range(args.repeats + 1):
        if turn == 1:  # the first one compiles, and warms caches
            seconds.clear()
        for name, file in files.items():
            placing = partial(placed_world, file.with_changes(), loaded[name].tiers, loaded[name])
            world, taken = timed(placing)
            seconds.setdefault(f"{name}.world", []).append(taken)
            integrator = make_integrator(file.resolved, world)
            _, taken = timed(partial(render, file.scene, integrator))
            seconds.setdefault(name, []).append(taken)
        for name, taken in stages(asset, frames[1]).items():
            seconds.setdefault(name, []).append(taken)
    medians = {name: float(np.median(values)) for name, values in seconds.items()}
    return record(medians, geometries) | {"trees": trees(geometries, args.repeats)}


def record(medians: dict[str, float], geometries: Sequence[Geometry]) -> dict[str, Any]:
    """The figures of a package. medians: CPU seconds by stage."""
    tree = medians["tree"]
    before = {n: max(medians[f"{n}.world"] - tree, 0.0) for n in (SAME, BENT)}
    still = medians[STILL]
    return {
        "geometry": [size_of(g) for g in geometries],
        "ratio": round((medians[SAME] + before[SAME]) / still, 3),
        "ratio_bent": round((medians[BENT] + before[BENT]) / still, 3),
        "cpu_seconds": {name: round(value, 5) for name, value in medians.items()},
    }


def stages(asset: Asset, positions: Sequence[np.ndarray]) -> dict[str, float]:
    """CPU seconds of what comes before a frame."""
    shapes, taken = timed(
        lambda: [part.deformed(p) for part, p in zip(asset.parts, positions, strict=True)]
    )
    seconds = {"shape": taken}
    bent = [part_geometry(*pair) for pair in zip(asset.parts, shapes, strict=True)]
    _, seconds["tree"] = timed(lambda: PartsScene(bent))
    meshes = [part.mesh for part in asset.parts if part.kind == "surface"]
    if meshes:
        source, triangles = joined(meshes)
        bindings, seconds["binding"] = timed(lambda: bind(meshes, source, triangles))
        _, seconds["positions"] = timed(lambda: [b.positions(source) for b in bindings])
    return seconds


def trees(geometries: Sequence[Geometry], repeats: int) -> list[dict[str, Any]]:
    """CPU seconds of Embree's scene by size."""
    result = []
    for cuts in range(3):
        if cuts:
            geometries = [finer(g) for g in geometries]
        made = [timed(partial(PartsScene, geometries))[1] for _ in range(repeats)]
        sizes = [size_of(g) for g in geometries]
        result.append({"geometry": sizes, "cpu_seconds": round(float(np.median(made)), 5)})
    return result


def timed(work: Callable[[], Any]) -> tuple[Any, float]:
    """What some work gives, and its CPU seconds, of all threads."""
    start = time.process_time()
    result = work()
    return result, time.process_time() - start


def moved(still: SceneFile, motion: Path, frame: int) -> SceneFile:
    """The scene with its asset at a frame of a motion."""
    key = {"path": str(motion), "start": frame}
    path = still.resolve(still.scene.assets[0].path)
    return still.with_changes(assets=(AssetModel.model_validate({"path": path, "motion": key}),))


def bent(geometry: Geometry, all_of: Sequence[Geometry], angle: float) -> np.ndarray:
    """Positions, bent about a horizontal axis: (v, 3) float32. angle: at the top of all parts."""
    boxes = np.array([g.box() for g in all_of])
    low, high = boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)
    p = geometry.points if isinstance(geometry, Curves) else geometry.positions
    if not angle:
        return p.copy()
    at = p - (low + high) / 2
    turn = angle * (p[:, 1] - low[1]) / (high[1] - low[1])
    c, s = np.cos(turn), np.sin(turn)
    moved = np.column_stack([c * at[:, 0] - s * at[:, 1], s * at[:, 0] + c * at[:, 1], at[:, 2]])
    return np.asarray(moved + (low + high) / 2, np.float32)


def joined(meshes: Sequence[Mesh]) -> tuple[np.ndarray, np.ndarray]:
    """All meshes as one: positions (v, 3) and triangles (t, 3)."""
    starts = np.cumsum([0, *(len(mesh.positions) for mesh in meshes)])[:-1]
    shifted = [mesh.triangles.astype(np.int64) + s for mesh, s in zip(meshes, starts, strict=True)]
    return np.concatenate([mesh.positions for mesh in meshes]), np.concatenate(shifted)


def finer(geometry: Geometry) -> Geometry:
    """A mesh with each triangle cut into 4, or strands with each segment cut into 4."""
    if isinstance(geometry, Curves):
        return finer_curves(geometry)
    a, b, c = geometry.positions[geometry.triangles].transpose(1, 0, 2)
    ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
    corners = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    p = np.concatenate([np.stack(t, axis=1) for t in corners]).reshape(-1, 3).astype(np.float32)
    triangles = np.arange(len(p), dtype=np.uint32).reshape(-1, 3)
    return Mesh(p, np.zeros_like(p), None, triangles)


def finer_curves(curves: Curves) -> Curves:
    """Four times as many segments: points at the quarters of each."""
    first = curves.segments().astype(np.int64)
    share = np.arange(4) / 4
    rows = np.concatenate([curves.points, curves.radii[:, None]], axis=1)
    inside = rows[first, None] + share[:, None] * (rows[first + 1] - rows[first])[:, None]
    ends = curves.offsets[1:].astype(np.int64) - 1
    counts = 4 * (np.diff(curves.offsets.astype(np.int64)) - 1) + 1
    offsets = np.concatenate([[0], np.cumsum(counts)])
    result = np.empty((offsets[-1], 4), np.float32)
    last = np.zeros(offsets[-1], bool)
    last[offsets[1:] - 1] = True
    result[last], result[~last] = rows[ends], inside.reshape(-1, 4)
    return Curves(result[:, :3].copy(), result[:, 3].copy(), offsets.astype(np.uint32))


def size_of(geometry: Geometry) -> str:
    if isinstance(geometry, Curves):
        return f"{len(geometry.segments()):,} segments"
    return f"{len(geometry.triangles):,} triangles"


def unit_mesh(path: Path) -> Mesh:
    """A mesh file's shape, in the box from -1 to 1."""
    read = read_mesh_object(path, None)
    low, high = read.positions.min(axis=0), read.positions.max(axis=0)
    p = (read.positions - (low + high) / 2) / (0.51 * (high - low).max())
    return Mesh(np.asarray(p, np.float32), read.normals, None, read.triangles)
