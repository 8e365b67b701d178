"""Loads Alembic and USD files, and adds missing properties of their strands."""

import argparse
import tempfile
from itertools import pairwise
from pathlib import Path

import bpy
import numpy as np
import rna_hair
from rna_geometry import curves_export
from rna_hair.axes import z_up_to_y_up
from rna_hair.objects import add_curves, show_strands
from rna_sources import groom_source, imported_colours, shown_frame, usd_curves, usd_facets

_STEPS = 4  # straight segments between two points of a spline


def load(source: str, arguments: list[str], frame: int | None) -> list[str]:
    """Add the contents of the file to the scene; returns notes for the user.

    arguments: see `source_formats`. frame: of strands that have to be copied; None for the first.
    """
    path = Path(source)
    notes: list[str] = []
    args = groom_source.options(path, arguments)
    if path.suffix.lower() == ".abc":
        if bpy.ops.wm.alembic_import(filepath=source, scale=args.unit) != {"FINISHED"}:
            raise ValueError(f"{path.name}: not an Alembic archive (Ogawa), or a damaged one")
    else:
        _import_usd(path, args, frame)
        notes = [] if args.subdivide else usd_facets.restore(path)
    scene = bpy.context.scene
    scene.frame_set(scene.frame_start if frame is None else frame)
    return [*notes, *_finish_strands(args)]


def _import_usd(path: Path, args: argparse.Namespace, frame: int | None) -> None:
    with tempfile.TemporaryDirectory(prefix="rna-usd-") as folder:
        prepared = usd_curves.prepared(path, Path(folder), frame)
        if prepared != path:
            shown_frame.keep()
        bpy.ops.wm.usd_import(
            filepath=str(prepared), scale=args.unit, import_subdivision=args.subdivide
        )
    rate, render = usd_curves.frame_rate(path), bpy.context.scene.render
    if rate > 0:  # Blender's importer leaves its own
        render.fps = min(max(round(rate), 1), 32767)
        render.fps_base = render.fps / rate


def _finish_strands(args: argparse.Namespace) -> list[str]:
    """Splines become polylines; strands get radii and a material where they have none.

    Returns notes for the user.
    """
    items = [item for item in bpy.data.objects if item.type == "CURVES"]
    if not items:
        return []
    show_strands()
    for item in items:
        _evaluate_splines(item)
    material = groom_source.hair_material(args)
    changed = any(getattr(args, n) is not None for n in ("radius", "tip", "points", "strands"))
    if changed or not all("radius" in item.data.attributes for item in items):
        coloured = [item.name for item in items if imported_colours.has_colours(item)]
        _rebuild(items, args, material)
        why = "--radius, --tip, --points or --strands" if changed else "radii that the file lacks"
        return [f"strands {name!r} lose their displayColor by {why}" for name in coloured]
    for item in items:
        if not any(item.data.materials):
            item.data.materials.clear()
            item.data.materials.append(imported_colours.strand_material(item, args, material))
    return []


def _evaluate_splines(item: bpy.types.Object) -> None:
    """Straight segments along the spline of each strand, by geometry nodes: they keep attributes.

    Cycles connects the points of a spline as they are.
    """
    tree = bpy.data.node_groups.get("rna polylines") or _polylines()
    item.modifiers.new("rna polylines", "NODES").node_group = tree


def _polylines() -> bpy.types.NodeTree:
    tree = bpy.data.node_groups.new("rna polylines", "GeometryNodeTree")
    tree.interface.new_socket("Geometry", in_out="INPUT", socket_type="NodeSocketGeometry")
    tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    steps = tree.nodes.new("GeometryNodeSetSplineResolution")
    steps.inputs["Resolution"].default_value = _STEPS
    resample = tree.nodes.new("GeometryNodeResampleCurve")
    resample.inputs["Mode"].default_value = "Evaluated"
    chain = [tree.nodes.new("NodeGroupInput"), steps, resample, tree.nodes.new("NodeGroupOutput")]
    for before, after in pairwise(chain):
        tree.links.new(before.outputs[0], after.inputs[0])
    return tree


def _rebuild(
    items: list[bpy.types.Object], args: argparse.Namespace, material: bpy.types.Material
) -> None:
    """Put shaped strands, in world space, in the place of all curves objects."""
    shown_frame.keep()
    shown = []
    for instance in curves_export.shown_curves():
        rebuilt = curves_export.strands_of(instance)
        if rebuilt is not None:
            points, radii, counts = rebuilt
            offsets = np.concatenate([[0], np.cumsum(counts, dtype=np.int64)])
            strands = rna_hair.Strands(z_up_to_y_up(points), radii, offsets)
            data = instance.object.data
            assigned = next((m.original for m in data.materials if m is not None), material)
            shown.append((instance.object.name, strands, "radius" in data.attributes, assigned))
    for item in items:
        bpy.data.objects.remove(item, do_unlink=True)
    if not shown:
        return
    usual = groom_source.half_diagonal(np.concatenate([s.points for _, s, _, _ in shown])) / 2000.0
    total = sum(len(strands) for _, strands, _, _ in shown)
    for name, strands, has_radii, assigned in shown:
        share = args.strands and max(1, round(args.strands * len(strands) / total))
        shaped = groom_source.shaped(strands, args, share, None if has_radii else usual)
        add_curves(shaped, name, assigned)
