"""Reads a folder of views, as `rna-bench peers-data` writes it."""

import json
from pathlib import Path

import numpy as np

from rna_bench.peers.views import Views
from rna_bench.peers.views_plan import DEPTH, EXTENSION
from rna_render import read_exr
from rna_sdk.errors import SceneError


def read_views(folder: Path, split: str, limit: int | None = None) -> Views:
    """The views of one split, the first `limit`.

    Raises SceneError, with the file, for what is missing or is not of `rna-bench peers-data`.
    """
    path = folder / f"transforms_{split}.json"
    try:
        meta = json.loads(path.read_text())
        frames = meta["frames"][:limit]
        to_world = np.array([frame["transform_matrix"] for frame in frames])
        lights = np.array([frame["pl_pos"] for frame in frames])
        centre, radius = tuple(meta["sphere_centre"]), meta["sphere_radius"]
        angle, intensity = meta["camera_angle_x"], meta["light_intensity"]
    except OSError as error:
        raise SceneError(f"cannot read it: {error.strerror}", file=path) from error
    except (ValueError, LookupError, TypeError) as error:
        raise SceneError("not as `rna-bench peers-data` writes it", file=path) from error
    files = [folder / (frame["file_path"] + EXTENSION) for frame in frames]
    rgba = np.stack([_channels(file, "RGBA") for file in files])
    depth = np.stack([_channels(_beside(file), "Z")[..., 0] for file in files])
    return Views(rgba, depth, to_world, lights, angle, centre, radius, intensity)


def splits_of(folder: Path) -> list[str]:
    """The splits that a folder has."""
    names = sorted(path.stem for path in folder.glob("transforms_*.json"))
    return [name.removeprefix("transforms_") for name in names]


def _beside(image: Path) -> Path:
    return image.with_name(f"{image.stem}{DEPTH}{EXTENSION}")


def _channels(path: Path, names: str) -> np.ndarray:
    """(h, w, channels) float32."""
    channels, _ = read_exr(path)
    if missing := [name for name in names if name not in channels]:
        raise SceneError(f"has no channel {', '.join(missing)}", file=path)
    return np.stack([channels[name] for name in names], axis=-1).astype(np.float32)
