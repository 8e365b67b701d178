"""Error of what viewers show that do not know RNA: a .glb's fallback beside the references."""

import warnings
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.validation_view import WholeView
from rna_export.metrics import plain
from rna_export.training.asset_error import asset_error
from rna_render import DirectLight, read_mesh_object
from rna_render.scene import open_gltf
from rna_sdk.commands.console import command_line
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.files.file_kinds import is_gltf
from rna_sdk.package.gltf.carrier_writer import with_fallback_flip


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
        own = source.with_suffix(".glb")
        put = command_line("rna-info", package, "--glb", "OUT.glb", "--fallback", own)
        lines.append(f"note: the fallback does not move; {put} makes your model the fallback")
    return lines


def fallback_flip(glb: Path, views: Sequence[WholeView]) -> float:
    """Mean FLIP of the fallback of a .glb against validation images, as `rna_export.asset_flip`.

    The meshes of the file's scene are lit as viewers light them: directly, with their own shadows.
    Only pixels of the reference count, so ribbons beside strands do not.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # that a package is not shown
        light = DirectLight(read_mesh_object(glb))
    rows = [[part.samples for part in view.parts] for view in views]
    radiance = [
        np.concatenate([light.radiance(s["position"], wo=s["wo"], wi=s["wi"]) for s in parts])
        for parts in rows
    ]
    return asset_error(radiance, views).mean


def _moves(source: Path) -> bool:
    """Whether a source is glTF with animations."""
    try:
        return is_gltf(source) and bool(open_gltf(source).json.get("animations"))
    except (OSError, ValueError, LookupError, TypeError):
        return False
