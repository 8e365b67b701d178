"""What can follow `--` for a groom, or for an Alembic or USD file; needs nothing of Blender."""

from __future__ import annotations

import argparse
from typing import NoReturn

GROOMS = (".hair", ".tfx")
USD = (".usd", ".usda", ".usdc", ".usdz")
ALEMBIC_AND_USD = (".abc", *USD)
TAPER = 0.3  # tip over root, where the file has no thickness


class _Parser(argparse.ArgumentParser):
    """Bad arguments become the error that `rna-capture` prints."""

    def error(self, message: str) -> NoReturn:
        raise ValueError(f"{message} (after --; all options: -- --help)")


def parser(suffix: str) -> argparse.ArgumentParser:
    """What can follow `--` for a file of this suffix, one of those above."""
    p = _Parser(
        prog=f"rna-capture groom{suffix} --out groom.rays --",
        description="How the strands of the file look. Lengths are in metres.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    if suffix in GROOMS:
        p.add_argument("--unit", type=float, default=0.01, help="metres to a unit of the file")
    else:
        _add_of_scenes(p)
    p.add_argument(
        "--radius",
        type=float,
        help="of the strands, instead of the file's; where a file has none (.tfx never has) it is "
        "1/2000 of the half diagonal of all strands",
    )
    p.add_argument("--tip", type=float, help=f"tip's over root's radius (without radii: {TAPER})")
    p.add_argument("--points", type=int, help="resample each strand to so many points")
    p.add_argument("--strands", type=int, help="grow so many strands between the file's")
    p.add_argument("--seed", type=int, default=0, help="of --strands")
    _add_of_material(p)
    return p


def _add_of_scenes(p: argparse.ArgumentParser) -> None:
    """Alembic and USD files hold meshes and motion too."""
    p.add_argument(
        "--unit",
        type=float,
        default=1.0,
        help="metres to a unit of an Alembic file; times the metersPerUnit of a USD file",
    )
    p.add_argument("--frame", type=int, help="of a file that moves; its first one if not given")
    p.add_argument(
        "--subdivide", action="store_true", help="meshes by the subdivision scheme of a USD file"
    )


def _add_of_material(p: argparse.ArgumentParser) -> None:
    """Of Principled Hair, for strands without a material of their own."""
    p.add_argument("--melanin", type=float, default=0.3, help="0 white, 1 black")
    p.add_argument("--redness", type=float, default=0.5, help="of the melanin")
    p.add_argument("--colour", type=float, nargs=3, help="linear R G B, instead of melanin")
    p.add_argument("--roughness", type=float, default=0.25, help="along the strand")
    p.add_argument("--radial-roughness", type=float, default=0.4, help="around it")
    p.add_argument("--coat", type=float, default=0.0, help="0 to 1, sharpens the highlight")
    p.add_argument("--ior", type=float, default=1.55, help="index of refraction")
    p.add_argument("--offset", type=float, default=2.0, help="tilt of the scales in degrees")
