"""Renders the views of a plan with Cycles; a stopped run goes on with the first missing image."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.peers.views import PeerCamera
from rna_bench.peers.views_plan import DEPTH, FOV_X, INTENSITY, SPLITS, ViewsPlan
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_render import write_exr
from rna_sdk.errors import CaptureError
from rna_sdk.files.atomic_file import write_atomically

_FRESH = 100  # images of one process

Sphere = tuple[np.ndarray, float]
"""Centre and radius."""


def render_views(
    plan: ViewsPlan, worker: BlenderWorker, out: Path, step: Callable[[], object] = lambda: None
) -> None:
    """Render the missing images of all splits into `out`; step: called after each image.

    Raises CaptureError where the folder holds views of another plan.
    """
    sphere = bounding_sphere(worker)
    described = {
        split: _described(plan, split, sphere, worker.source.path.name) for split in SPLITS
    }
    wanted = {split: meta for split, meta in described.items() if meta["frames"]}
    for split, meta in wanted.items():
        _write_meta(out / f"transforms_{split}.json", meta)
    rendered = 0
    for split, meta in wanted.items():
        (out / split).mkdir(exist_ok=True)
        for k, frame in enumerate(meta["frames"]):
            path = out / (frame["file_path"] + frame["file_ext"])
            if not path.is_file():
                rendered += 1
                if rendered % _FRESH == 0:
                    worker.restart()  # its memory grows
                _render(plan, split, k, frame, sphere, worker, path)
            step()


def bounding_sphere(worker: BlenderWorker) -> Sphere:
    """Bounding sphere of the opened source, about the middle of its box."""
    points, thickest = [], 0.0
    for part in worker.parts:
        if part.kind == "fiber":
            curves = worker.export_curves(part.owner)
            points.append(curves.points)
            thickest = max(thickest, float(curves.radii.max()))
        else:
            points.append(worker.export_corners(part.owner)["positions"].reshape(-1, 3))
    positions = np.concatenate(points).astype(np.float64)
    centre = (positions.min(axis=0) + positions.max(axis=0)) / 2.0
    return centre, float(np.linalg.norm(positions - centre, axis=1).max()) + thickest


def _described(plan: ViewsPlan, split: str, sphere: Sphere, source: str) -> dict[str, Any]:
    """The JSON of a split; what NRHints' reader does not know of, it leaves."""
    centre, radius = sphere
    return {
        "camera_angle_x": FOV_X,
        "light_intensity": INTENSITY,
        "sphere_centre": np.round(centre, 6).tolist(),
        "sphere_radius": round(radius, 6),
        "source": source,
        "samples": plan.samples_of(split),
        "resolution": plan.resolution,
        "frames": plan.frames(split),
    }


def _write_meta(path: Path, meta: dict[str, Any]) -> None:
    """Raises CaptureError where there is another, of which images may be there."""
    if path.is_file():
        there = json.loads(path.read_text())
        differ = [key for key in meta if key != "frames" and there.get(key) != meta[key]]
        if differ:
            differences = ", ".join(f"{key} {there.get(key)}, now {meta[key]}" for key in differ)
            raise CaptureError(
                f"{path}: made with other settings ({differences}): choose another --out"
            )
    path.parent.mkdir(parents=True, exist_ok=True)
    write_atomically(path, (json.dumps(meta, indent=1) + "\n").encode())


def _render(
    plan: ViewsPlan,
    split: str,
    number: int,
    frame: dict[str, Any],
    sphere: Sphere,
    worker: BlenderWorker,
    path: Path,
) -> None:
    """One image and its depth: the asset stays as large as it is, and the rest is scaled."""
    centre, radius = sphere
    to_world = np.array(frame["transform_matrix"])
    to_world[:3, 3] = centre + radius * to_world[:3, 3]
    light = {
        "type": "point",
        "position": (centre + radius * np.array(frame["pl_pos"])).tolist(),
        "intensity": [INTENSITY * radius**2] * 3,
    }
    still = [np.eye(4).tolist()]
    scene = {"assets": still, "meshes": [], "lights": [light], "bounces": None}
    camera = PeerCamera(to_world, FOV_X, (plan.resolution, plan.resolution))
    samples, seed = plan.samples_of(split), 1000 * SPLITS.index(split) + number
    rgba, points = worker.render_scene(scene, camera, samples, seed)
    depth = np.linalg.norm(points - to_world[:3, 3], axis=-1) / radius
    depth[~points.any(axis=-1)] = 0.0
    write_exr(path.with_name(path.stem + DEPTH + path.suffix), {"Z": depth.astype(np.float32)}, {})
    write_exr(path, {c: np.ascontiguousarray(rgba[..., k]) for k, c in enumerate("RGBA")}, {})
