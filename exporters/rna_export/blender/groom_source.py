"""Loads a groom, `.hair` or `.tfx`, which says where strands are and little of how they look."""

import argparse
from pathlib import Path

import numpy as np
import rna_hair
from rna_hair.objects import add_curves, chiang_material

_TAPER = 0.3  # tip over root, where the groom has no thickness


class _Parser(argparse.ArgumentParser):
    """Bad arguments, and --help, become the error that `rna-capture` prints."""

    def error(self, message):
        raise ValueError(f"{message} (after --; all options: -- --help)")

    def print_help(self, file=None):
        raise ValueError(self.format_help())


def parser():
    """What can follow `--` for a groom."""
    p = _Parser(
        prog="rna-capture GROOM --out RAYS --",
        description="How the strands of a .hair or .tfx file look. Lengths are in metres.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    p.add_argument("--unit", type=float, default=0.01, help="metres to a unit of the file")
    p.add_argument(
        "--radius",
        type=float,
        help="of the strands, instead of the file's; a .tfx file has none and gets 1/2000 of the "
        "groom's half diagonal",
    )
    p.add_argument("--tip", type=float, help=f"tip's over root's radius (.tfx: {_TAPER})")
    p.add_argument("--points", type=int, help="resample each strand to so many points")
    p.add_argument("--strands", type=int, help="grow so many strands between the file's")
    p.add_argument("--seed", type=int, default=0, help="of --strands")
    p.add_argument("--melanin", type=float, default=0.3, help="0 white, 1 black")
    p.add_argument("--redness", type=float, default=0.5, help="of the melanin")
    p.add_argument("--colour", type=float, nargs=3, help="linear R G B, instead of melanin")
    p.add_argument("--roughness", type=float, default=0.25, help="along the strand")
    p.add_argument("--radial-roughness", type=float, default=0.4, help="around it")
    p.add_argument("--coat", type=float, default=0.0, help="0 to 1, sharpens the highlight")
    p.add_argument("--ior", type=float, default=1.55, help="index of refraction")
    p.add_argument("--offset", type=float, default=2.0, help="tilt of the scales in degrees")
    return p


def load(source, arguments):
    """Add the groom to the scene as one curves object."""
    args = parser().parse_args(arguments)
    _check(args)
    material = chiang_material(
        melanin=None if args.colour else args.melanin,
        redness=args.redness,
        colour=args.colour,
        roughness=args.roughness,
        radial_roughness=args.radial_roughness,
        coat=args.coat,
        ior=args.ior,
        offset_deg=args.offset,
    )
    add_curves(_strands(Path(source), args), Path(source).stem, material)


def _check(args):
    ranges = {"unit": 1e-9, "radius": 1e-12, "points": 2, "strands": 1, "ior": 1.0}
    for name, least in ranges.items():
        value = getattr(args, name)
        if value is not None and value < least:
            raise ValueError(f"--{name}: found {value:g}, expected {least:g} and more")
    for name in ("tip", "melanin", "redness", "roughness", "radial_roughness", "coat"):
        value = getattr(args, name)
        if value is not None and not 0.0 <= value <= 1.0:
            option = name.replace("_", "-")
            raise ValueError(f"--{option}: found {value:g}, expected 0 to 1")


def _strands(path, args):
    is_tfx = path.suffix.lower() == ".tfx"
    strands = rna_hair.read_tfx(path, 1.0) if is_tfx else rna_hair.read_hair(path)
    strands = strands.moved(args.unit, np.zeros(3))
    if args.strands is not None:
        most = int(strands.counts.max())
        strands = rna_hair.interpolate(strands, args.strands, points=most, seed=args.seed)
    if args.points is not None:
        strands = rna_hair.resample(strands, args.points)
    if not is_tfx and args.radius is None and args.tip is None:
        if not strands.radii.max() > 0.0:
            raise ValueError(f"{path.name}: thickness 0: give --radius")
        return strands
    radius = args.radius
    if radius is None and is_tfx:
        half = 0.5 * np.linalg.norm(np.ptp(strands.points, axis=0))
        radius = half / 2000.0
    elif radius is None:
        radius = float(strands.radii.max())
    return rna_hair.taper(strands, radius, tip=_TAPER if args.tip is None else args.tip)
