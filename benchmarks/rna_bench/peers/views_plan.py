"""Which cameras and lights the views of an asset have, and NRHints' layout of their folder.

    DIR/transforms_train.json   camera_angle_x; file_path, transform_matrix, pl_pos a frame
    DIR/train/r_0000.exr        RGBA, linear, colour times alpha
    DIR/train/r_0000_depth.exr  Z: distance along the ray from the camera, 0 for none

Everything is in units of the asset's bounding sphere, whose centre is the origin. `train`, `val`
and `test` have the camera and the light in places of their own, as Zeng et al. 2023 have them;
`train_collocated` and `val_collocated` have both in one place, as Bi et al. 2020.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

NEAREST, FARTHEST = 4.0, 5.0  # of cameras and lights from the centre (NRHints' data)
FOV_X = math.radians(30.0)  # the sphere is in the picture from NEAREST
INTENSITY = math.pi * 4.5**2
"""W/sr in units of the sphere: irradiance pi at the centre from 4.5, as PSNRs of ours expose."""

SPLITS = ("train", "val", "test", "train_collocated", "val_collocated")
DEPTH = "_depth"
EXTENSION = ".exr"


@dataclass(frozen=True)
class ViewsPlan:
    """How many views, their size, and Cycles' samples a pixel of the trained and held-out ones."""

    views: int
    collocated: int
    held_out: int
    resolution: int
    samples: int
    held_out_samples: int
    seed: int = 0

    def count(self, split: str) -> int:
        """Views of a split."""
        trained = {"train": self.views, "train_collocated": self.collocated}
        is_unused = split == "val_collocated" and not self.collocated
        return trained.get(split, 0 if is_unused else self.held_out)

    def samples_of(self, split: str) -> int:
        """Cycles' samples a pixel."""
        return self.samples if split.startswith("train") else self.held_out_samples

    def frames(self, split: str) -> list[dict[str, Any]]:
        """The frames as the JSON has them; the first ones do not change with their number."""
        frames = []
        for k in range(self.count(split)):
            rng = np.random.default_rng((self.seed, SPLITS.index(split), k))
            eye = _place(rng)
            light = eye if split.endswith("collocated") else _place(rng)
            frames.append(
                {
                    "file_path": f"{split}/r_{k:04d}",
                    "file_ext": EXTENSION,
                    "transform_matrix": looking_at_centre(eye).tolist(),
                    "pl_pos": light.tolist(),
                }
            )
        return frames


def looking_at_centre(eye: np.ndarray) -> np.ndarray:
    """(4, 4) camera (looks along -z) to world at `eye`, +Y up."""
    back = eye / np.linalg.norm(eye)
    right = np.cross([0.0, 1.0, 0.0], back)
    if np.linalg.norm(right) < 1e-6:  # straight above
        right = np.array([1.0, 0.0, 0.0])
    right /= np.linalg.norm(right)
    to_world = np.eye(4)
    to_world[:3] = np.stack([right, np.cross(back, right), back, eye], axis=1)
    return to_world


def _place(rng: np.random.Generator) -> np.ndarray:
    """Uniform over the directions of the upper half space, and over the distance."""
    height, turn = rng.random(), 2.0 * math.pi * rng.random()
    return rng.uniform(NEAREST, FARTHEST) * _direction(turn, math.asin(height))


def _direction(azimuth: float, elevation: float) -> np.ndarray:
    return np.array(
        [
            math.cos(elevation) * math.sin(azimuth),
            math.sin(elevation),
            math.cos(elevation) * math.cos(azimuth),
        ]
    )
