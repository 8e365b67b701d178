"""Front and up axes: the options, and the rotation to +Z and +Y."""

import re

import numpy as np

from rna_sdk.errors import CaptureError

AXES = ("X", "Y", "Z", "-X", "-Y", "-Z")


def joined_axes(arguments: list[str]) -> list[str]:
    """Arguments with `--front -Z` as `--front=-Z`: argparse takes a -Z alone for an option."""
    joined: list[str] = []
    for argument in arguments:
        if joined and joined[-1] in ("--front", "--up") and re.fullmatch("-[XYZ]", argument):
            joined[-1] += "=" + argument
        else:
            joined.append(argument)
    return joined


def rotation(front: str, up: str) -> np.ndarray:
    """The rotation (3, 3) that takes +Z to `front` and +Y to `up`, two of `AXES`.

    Raises CaptureError if they are not at right angles.
    """
    z, y = _axis(front), _axis(up)
    if z @ y != 0.0:
        raise CaptureError(f"front {front} and up {up} are along one axis, expected two")
    return np.stack([np.cross(y, z), y, z], axis=1)


def _axis(name: str) -> np.ndarray:
    axis: np.ndarray = np.eye(3)["XYZ".index(name[-1])]
    return -axis if name[0] == "-" else axis
