"""Error of what viewers show that do not know RNA: a .glb's fallback beside the references."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.validation_view import ValidationView, WholeView
from rna_export.metrics import plain
from rna_export.training.asset_error import asset_error
from rna_render import World, read_mesh_object
from rna_render.materials.files.gltf_container import open_gltf
from rna_render.motion.gltf_clip import clip_names
from rna_render.world.placements import Placement
from rna_sdk.commands.console import command_line
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.files.file_kinds import is_gltf
from rna_sdk.package.gltf.carrier_writer import with_fallback_flip
from rna_trace.embree.instances import CAMERA_RAY
from rna_trace.points import Role


def complete_fallback(package: Path, dataset: Dataset, source: Path | None = None) -> list[str]:
    """Write the error of its fallback into a package that is a .glb; lines about the fallback.

    Nothing for a .rna. No error where the dataset's validation images show nothing to compare.
    source: the model that was captured, if it is at hand.
    """
    if package.suffix.lower() != ".glb":
        return []
    lines, views = [], dataset.whole_views()
    if not plain([view.reference for view in views]):
        flip = round(fallback_flip(package, views), 4)
        write_atomically(package, with_fallback_flip(package, flip))
        lines = [f"fallback: FLIP {flip:.4f} in viewers that do not know RNA"]
    if source is not None and _moves(source):
        glb = f"{source.stem}.glb"
        put = command_line("rna-info", package, "--glb", "OUT.glb", "--fallback", glb)
        lines.append(f"note: the fallback does not move; {put} makes your model the fallback")
    return lines


def _moves(source: Path) -> bool:
    """Whether a source is glTF with animations."""
    try:
        return is_gltf(source) and bool(clip_names(open_gltf(source)))
    except (OSError, ValueError, LookupError):
        return False


def fallback_flip(glb: Path, views: Sequence[WholeView]) -> float:
    """Mean FLIP of the fallback of a .glb against validation images, as `rna_export.asset_flip`.

    The meshes of the file's scene are lit as viewers light them: directly, with their own shadows.
    Only pixels of the reference count, so ribbons beside strands do not.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # that a package is not shown
        mesh = read_mesh_object(glb)
    world = World([Placement(mesh, np.eye(4), None)])
    radiance = [np.concatenate([_lit(world, part) for part in view.parts]) for view in views]
    return asset_error(radiance, views).mean


def _lit(world: World, view: ValidationView) -> np.ndarray:
    """What a world sends along the rays of a view's rows, (n, 3) float32, lit directly."""
    x, wo, wi = (view.samples[name] for name in ("position", "wo", "wi"))
    result = np.zeros_like(x)
    if not len(x):
        return result
    origin = x + np.float32(2.0 * world.radius + np.abs(x).max()) * wo
    hits = world.scene.intersect(origin, -wo, rays=CAMERA_RAY)
    at = world.vertices(Role.SCATTER, hits, origin, -wo, seen=True)
    wi, every = wi.take(at.ray, axis=0), np.arange(len(at))
    endless = np.full(len(at), np.inf, np.float32)
    light = world.scene.transmittance(world.origins(at, every, wi), wi, endless)
    for rows, place, points in at.local_rows(every):
        sent, _ = points.transport(place, wi[rows], endless[rows], None)
        result[at.ray[rows]] = sent * light[rows]
    return result if hits.weight is None else result * hits.weight
