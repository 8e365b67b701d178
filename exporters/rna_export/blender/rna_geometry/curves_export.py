"""Exports every strand of hair in the scene, as Cycles will render it."""

from collections.abc import Iterator
from typing import Any

import bpy
import numpy as np
from rna_geometry import shown_objects
from rna_geometry.attributes import read
from rna_geometry.shown_objects import HAIR, top_object

_THINNEST = 1e-3  # of the greatest radius: a package has no strand of radius 0
_NO_RADIUS = 0.005  # what Cycles takes where curves have no radius


def owners() -> list[str]:
    """Names of the top objects with strands, each once."""
    shown = [top_object(i) for i in shown_curves() if len(i.object.data.points)]
    return list(dict.fromkeys(shown))


def export_curves(path: str, owner: str | None = None) -> dict[str, Any]:
    """Write an .npz with `points` (p, 3), `radii` (p,) float32 and `offsets` (s + 1,) int64.

    World space, Blender's axes. Strand k is points[offsets[k]:offsets[k + 1]], root first. owner:
    the top object whose strands are meant; None: all.
    """
    shown = (i for i in shown_curves() if owner in (None, top_object(i)))
    parts = [part for instance in shown if (part := strands_of(instance)) is not None]
    if not parts:
        raise ValueError("the scene has no hair")
    points, radii, counts = (np.concatenate(arrays) for arrays in zip(*parts, strict=True))
    offsets = np.concatenate([[0], np.cumsum(counts, dtype=np.int64)])
    thinnest = np.float32(_THINNEST) * radii.max()
    if not thinnest > 0.0:
        raise ValueError("the hair has radius 0")
    np.savez(path, points=points, radii=np.maximum(radii, thinnest), offsets=offsets)
    return {"strands": len(counts)}


def shown_curves() -> Iterator[bpy.types.DepsgraphObjectInstance]:
    """Instances of hair curves that camera rays see."""
    for instance in shown_objects.seen():
        if instance.object.type == HAIR:
            yield instance


def strands_of(
    instance: bpy.types.DepsgraphObjectInstance,
) -> tuple[np.ndarray, np.ndarray, np.ndarray] | None:
    """World points, radii and points a strand; None without strands of two points or more."""
    curves = instance.object.data
    offsets = read(curves.curve_offset_data, "value", len(curves.curves) + 1, np.int32)
    points = read(curves.position_data, "vector", 3 * len(curves.points)).reshape(-1, 3)
    radii = np.full(len(points), _NO_RADIUS, np.float32)
    if "radius" in curves.attributes:
        radii = read(curves.attributes["radius"].data, "value", len(points))
    matrix = np.array(instance.matrix_world, np.float64)
    world = (points @ matrix[:3, :3].T + matrix[:3, 3]).astype(np.float32)
    radii = radii * np.float32(_scale_of_radii(instance.object.name, matrix[:3, :3]))
    strand = np.repeat(np.arange(len(offsets) - 1), np.diff(offsets))
    # A point where the one before it is makes no segment, and has no tangent.
    moved = np.concatenate([[True], np.any(world[1:] != world[:-1], axis=1)])
    moved[offsets[:-1][np.diff(offsets) > 0]] = True
    counts = np.bincount(strand[moved], minlength=len(offsets) - 1)
    valid = counts >= 2  # Cycles shows no others
    if not valid.any():
        return None
    here = moved & valid[strand]
    return world[here], radii[here], counts[valid]


def _scale_of_radii(name: str, matrix: np.ndarray) -> float:
    """Cycles scales radii with the object."""
    scales = np.linalg.svd(matrix, compute_uv=False)
    if scales[0] > 1.001 * scales[-1]:
        raise ValueError(
            f"hair {name!r} has non-uniform scale, {scales[-1]:.3g} to {scales[0]:.3g}, which "
            "flattens its strands: apply the scale (Ctrl-A) first"
        )
    return float(np.cbrt(np.prod(scales)))
