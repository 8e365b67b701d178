"""The options for frames of an animated source: at rest, and the poses to learn."""

import argparse
import re

from rna_export.capture.capture_settings import CaptureSettings

FRAME_SETTINGS = ("rest_frame", "poses")


def add_frames(p: argparse.ArgumentParser) -> None:
    """The options `--rest-frame` and `--poses`."""
    about, poses = (CaptureSettings.model_fields[name].description for name in FRAME_SETTINGS)
    p.add_argument(
        "--rest-frame",
        type=int,
        metavar="N",
        help=f"{about}: modifiers, armatures, caches and hair are evaluated there (int, default: "
        "the frame that a .blend or a script ends with, the first one of Alembic and USD, frame 0 "
        "of an animated glTF)",
    )
    p.add_argument(
        "--poses",
        type=_frames,
        metavar="N,N",
        help=f"{poses} (frames such as 12,24, default: only the rest frame)",
    )


def _frames(text: str) -> tuple[int, ...]:
    if re.fullmatch(r"-?\d{1,7}(,-?\d{1,7})*", text) is None:
        raise argparse.ArgumentTypeError(f"expected frames such as 12,24, found {text!r}")
    return tuple(map(int, text.split(",")))
