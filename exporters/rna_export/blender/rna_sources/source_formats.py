"""The files that a source may be, and their options after `--`; does not import Blender.

A reader is in `source_scene`.
"""

import argparse
from typing import Literal, NamedTuple, NoReturn

TAPER = 0.3  # tip radius / root radius for files without radii


class _Parser(argparse.ArgumentParser):
    """Raises ValueError for bad arguments; `rna-capture` prints it."""

    def error(self, message: str) -> NoReturn:
        raise ValueError(f"{message} (after --; all options: -- --help)")


def parser(suffix: str, options: str | None) -> argparse.ArgumentParser:
    """The options after `--` for a file with this suffix, and these of its `SourceFormat`."""
    p = _Parser(
        prog=f"rna-capture groom{suffix} --out groom.rays --",
        description="Geometry and material of the strands. Lengths are in metres.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    if options == "groom":
        p.add_argument("--unit", type=float, default=0.01, help="metres per file unit")
    else:
        _add_of_scenes(p)
    p.add_argument(
        "--radius",
        type=float,
        help="strand radius, overriding the file's; for a file without radii (such as .tfx): "
        "1/2000 of the half diagonal of all strands",
    )
    p.add_argument("--tip", type=float, help=f"tip radius / root radius (without radii: {TAPER})")
    p.add_argument("--points", type=int, help="resample each strand to this many points")
    p.add_argument("--strands", type=int, help="interpolate this many extra strands")
    p.add_argument("--seed", type=int, default=0, help="random seed of --strands")
    _add_of_material(p)
    return p


def _add_of_scenes(p: argparse.ArgumentParser) -> None:
    """Options for Alembic and USD files, which also hold meshes and animation."""
    p.add_argument(
        "--unit",
        type=float,
        default=1.0,
        help="metres per unit of an Alembic file; scales the metersPerUnit of a USD file",
    )
    p.add_argument(
        "--subdivide",
        action="store_true",
        help="apply the subdivision scheme of meshes in a USD file",
    )


def _add_of_material(p: argparse.ArgumentParser) -> None:
    """Options of Principled Hair, for strands without a material."""
    p.add_argument("--melanin", type=float, default=0.3, help="0 white, 1 black")
    p.add_argument("--redness", type=float, default=0.5, help="redness of the melanin")
    p.add_argument("--colour", type=float, nargs=3, help="linear RGB colour, replaces melanin")
    p.add_argument("--roughness", type=float, default=0.25, help="longitudinal roughness")
    p.add_argument("--radial-roughness", type=float, default=0.4, help="azimuthal roughness")
    p.add_argument("--coat", type=float, default=0.0, help="coat, 0 to 1; sharpens the highlight")
    p.add_argument("--ior", type=float, default=1.55, help="index of refraction")
    p.add_argument("--offset", type=float, default=2.0, help="cuticle tilt, degrees")


class SourceFormat(NamedTuple):
    """Format of a suffix.

    up: axis that is up where neither the file nor `--up` says so; "USD" for what the file says.
    options: which ones `parser` has for it after `--`.
    """

    reader: Literal["blend", "gltf", "obj", "ply", "scene", "groom", "script"]
    up: Literal["Y", "Z", "USD"]
    options: Literal["groom", "scene"] | None = None


SOURCE_FORMATS = {
    ".blend": SourceFormat("blend", "Z"),
    ".gltf": SourceFormat("gltf", "Y"),
    ".glb": SourceFormat("gltf", "Y"),
    ".obj": SourceFormat("obj", "Y"),
    ".ply": SourceFormat("ply", "Z"),  # it says no up; Blender's then, as for scripts
    ".abc": SourceFormat("scene", "Y", "scene"),
    ".usd": SourceFormat("scene", "USD", "scene"),
    ".usda": SourceFormat("scene", "USD", "scene"),
    ".usdc": SourceFormat("scene", "USD", "scene"),
    ".usdz": SourceFormat("scene", "USD", "scene"),
    ".hair": SourceFormat("groom", "Z", "groom"),
    ".tfx": SourceFormat("groom", "Y", "groom"),
    ".py": SourceFormat("script", "Z"),
}
