"""What can follow `--` for a groom, `.hair` or `.tfx`; needs nothing of Blender."""

import argparse

TAPER = 0.3  # tip over root, where the groom has no thickness


class _Parser(argparse.ArgumentParser):
    """Bad arguments become the error that `rna-capture` prints."""

    def error(self, message):
        raise ValueError(f"{message} (after --; all options: -- --help)")


def parser():
    """What can follow `--` for a groom."""
    p = _Parser(
        prog="rna-capture groom.hair --out groom.rays --",
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
    p.add_argument("--tip", type=float, help=f"tip's over root's radius (.tfx: {TAPER})")
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
