"""Small files of motions, for `scenes.py` to mutate, and how it checks what they became."""

from pathlib import Path

import numpy as np

from rna_render.motion.asset_motion import open_asset_motion
from rna_sdk.motion import write_motion
from rna_sdk.package import Mesh
from tests.motion.gltf_files import bending_arm, moving_node, quaternion

GLTF_MOTIONS, MOTION_FILES = "glTF motions", "motion files"


def _sheet() -> Mesh:
    """4 x 4 vertices in the plane of x and z."""
    x, z = (a.reshape(-1) for a in np.mgrid[0:1:4j, 0:1:4j])
    i, j = (a.reshape(-1) for a in np.mgrid[0:3, 0:3])
    corner = 4 * i + j
    quads = np.stack([corner, corner + 1, corner + 5, corner, corner + 5, corner + 4], axis=1)
    up = np.tile(np.float32([0, 1, 0]), (16, 1))
    return Mesh(
        np.float32(np.stack([x, 0 * x, z], 1)), up, None, quads.reshape(-1, 3).astype(np.uint32)
    )


def write_motions(folder: Path) -> dict[str, list[Path]]:
    """Writes the files; kind -> paths."""
    sheet, times = _sheet(), [0, 0.5, 1]
    turns = [quaternion((0, 1, 0), angle) for angle in (0, 40, 90)]
    places, sizes = [[0, 0, 0], [0, 1, 0], [1, 1, 0]], [[1, 1, 1], [2, 1, 1], [1, 1, 3]]
    tracks = [("rotation", times, turns), ("translation", times, places), ("scale", times, sizes)]
    cubic = [("translation", times, np.repeat(places, 3, axis=0))]
    frames = [[sheet.positions + np.float32([0, k, 0])] for k in range(3)]
    motion = folder / "sheet.rnam"
    write_motion(motion, [sheet], frames, count=3, rate=24.0)
    return {
        GLTF_MOTIONS: [
            moving_node(folder / "linear.gltf", sheet, tracks),
            moving_node(folder / "step.gltf", sheet, tracks, "STEP"),
            moving_node(folder / "cubic.gltf", sheet, cubic, "CUBICSPLINE"),
            bending_arm(folder / "arm.gltf", sheet, 60.0),
        ],
        MOTION_FILES: [motion],
    }


def check_motion(path: Path) -> list[tuple[str, np.ndarray]]:
    """Positions at some frames, with names."""
    motion = open_asset_motion(path, [_sheet()], "sheet.rna")
    last = motion.frames - 1
    frames = sorted({0, min(0.5, last), last // 2, min(last, 24), last})
    return [(f"frame {k}", array) for k in frames for array in motion.positions(k)]
