"""Loads a groom, `.hair` or `.tfx`: strand geometry with few material properties."""

import argparse
import warnings
from pathlib import Path

import bpy
import numpy as np
import rna_hair
from rna_hair.objects import add_curves, chiang_material
from rna_sources.source_formats import SOURCE_FORMATS, TAPER, parser


def load(source: str, arguments: list[str]) -> list[str]:
    """Add the groom to the scene as one curves object; returns notes for the user."""
    path = Path(source)
    args = options(path, arguments)
    is_tfx = path.suffix.lower() == ".tfx"
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        strands = rna_hair.read_tfx(path, 1.0) if is_tfx else rna_hair.read_hair(path)
    strands = strands.moved(args.unit, np.zeros(3))
    if not is_tfx and args.radius is None and not strands.radii.max() > 0.0:
        raise ValueError(f"{path.name}: thickness 0: give --radius")
    usual = half_diagonal(strands.points) / 2000.0 if is_tfx else None
    add_curves(shaped(strands, args, args.strands, usual), path.stem, hair_material(args))
    return [str(warning.message) for warning in said]


def options(path: Path, arguments: list[str]) -> argparse.Namespace:
    """The arguments after `--`, checked."""
    suffix = path.suffix.lower()
    kind = SOURCE_FORMATS[suffix].options
    args: argparse.Namespace = parser(suffix, kind).parse_args(arguments)
    ranges = {"unit": 1e-9, "radius": 1e-12, "points": 2, "strands": 1, "ior": 1.0}
    for name, least in ranges.items():
        value = getattr(args, name)
        if value is not None and value < least:
            raise ValueError(f"--{name}: found {value:g}, expected at least {least:g}")
    for name in ("tip", "melanin", "redness", "roughness", "radial_roughness", "coat"):
        value = getattr(args, name)
        if value is not None and not 0.0 <= value <= 1.0:
            option = name.replace("_", "-")
            raise ValueError(f"--{option}: found {value:g}, expected 0 to 1")
    return args


def hair_material(args: argparse.Namespace) -> bpy.types.Material:
    """Principled Hair as the options have it."""
    return chiang_material(
        melanin=None if args.colour else args.melanin,
        redness=args.redness,
        colour=args.colour,
        roughness=args.roughness,
        radial_roughness=args.radial_roughness,
        coat=args.coat,
        ior=args.ior,
        offset_deg=args.offset,
    )


def half_diagonal(points: np.ndarray) -> float:
    """Half the diagonal of the bounding box of points (p, 3)."""
    return 0.5 * float(np.linalg.norm(np.ptp(points, axis=0)))


def shaped(
    strands: rna_hair.Strands,
    args: argparse.Namespace,
    count: int | None,
    usual_radius: float | None,
) -> rna_hair.Strands:
    """The strands as --points, --radius and --tip have them, `count` of them unless it is None.

    usual_radius: for strands whose file has no radii; None keeps those of the file.
    """
    if count is not None:
        most = int(strands.counts.max())
        strands = rna_hair.interpolate(strands, count, points=most, seed=args.seed)
    if args.points is not None:
        strands = rna_hair.resample(strands, args.points)
    if usual_radius is None and args.radius is None and args.tip is None:
        return strands
    greatest = usual_radius or float(strands.radii.max())
    radius = greatest if args.radius is None else args.radius
    return rna_hair.taper(strands, radius, tip=TAPER if args.tip is None else args.tip)
