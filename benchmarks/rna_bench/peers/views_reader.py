"""Reads a folder of views in NRHints' layout, of `rna-bench peers-data` or by others.

Images are EXR (linear, colour times alpha) or PNG (sRGB, colour not times alpha), which is decoded.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.peers.views import Views
from rna_bench.peers.views_plan import DEPTH
from rna_render import read_exr
from rna_sdk.errors import SceneError

_RIGHT_ANGLES = 1e-3  # largest error of the axes' products


def read_views(folder: Path, split: str, limit: int | None = None) -> Views:
    """The views of one split, the first `limit`.

    Raises SceneError, with the file and the frame, for what is missing or cannot be used.
    """
    path = folder / f"transforms_{split}.json"
    meta = _read_meta(path)
    frames = meta["frames"][:limit]
    if not frames:
        raise SceneError("found no frames", file=path)
    images: list[np.ndarray] = []
    depths: list[np.ndarray | None] = []
    for frame in frames:
        if not isinstance(frame, dict) or not isinstance(frame.get("file_path"), str):
            raise SceneError("a frame has no file_path", file=path)
        file = folder / (frame["file_path"] + frame.get("file_ext", ".png"))
        rgba = _read_image(file)
        if images and rgba.shape != images[0].shape:
            sizes = [f"{i.shape[1]} x {i.shape[0]}" for i in (rgba, images[0])]
            raise SceneError(f"found {sizes[0]} pixels, the first image has {sizes[1]}", file=file)
        images.append(rgba)
        depths.append(_read_depth(file, rgba.shape[:2]))
    rgba = np.stack(images)
    return Views(
        rgba,
        None if any(d is None for d in depths) else np.stack([d for d in depths if d is not None]),
        np.stack([_matrix(frame, path) for frame in frames]),
        np.stack([_light(frame, path) for frame in frames]),
        _angle(meta, path),
        tuple(meta.get("sphere_centre", (0.0, 0.0, 0.0))),
        float(meta.get("sphere_radius", 1.0)),
        meta.get("light_intensity"),
    )


def splits_of(folder: Path) -> list[str]:
    """The splits that a folder has."""
    names = sorted(path.stem for path in folder.glob("transforms_*.json"))
    return [name.removeprefix("transforms_") for name in names]


def _read_meta(path: Path) -> dict[str, Any]:
    try:
        meta = json.loads(path.read_text())
    except OSError as error:
        raise SceneError(f"cannot read it: {error.strerror}", file=path) from error
    except ValueError as error:
        raise SceneError(f"not JSON: {error}", file=path) from error
    if not isinstance(meta, dict) or not isinstance(meta.get("frames"), list):
        raise SceneError("found no list of frames", file=path)
    return meta


def _angle(meta: dict[str, Any], path: Path) -> float:
    angle = meta.get("camera_angle_x")
    if not isinstance(angle, int | float) or not 0.0 < angle < math.pi:
        raise SceneError(f"camera_angle_x: found {angle}, expected 0 to pi radians", file=path)
    return float(angle)


def _light(frame: dict[str, Any], path: Path) -> np.ndarray:
    name = frame["file_path"]
    if "pl_pos" not in frame:
        raise SceneError(f"{name}: has no pl_pos, the place of its light", file=path)
    return _numbers(frame["pl_pos"], (3,), f"{name}: pl_pos", path)


def _matrix(frame: dict[str, Any], path: Path) -> np.ndarray:
    what = f"{frame['file_path']}: transform_matrix"
    matrix = _numbers(frame.get("transform_matrix"), (4, 4), what, path)
    axes = matrix[:3, :3]
    turned = np.abs(axes @ axes.T - np.eye(3)).max() < _RIGHT_ANGLES
    if not (turned and np.linalg.det(axes) > 0.0 and np.allclose(matrix[3], [0, 0, 0, 1])):
        raise SceneError(f"{what}: expected a rotation and a translation", file=path)
    return matrix


def _numbers(value: Any, shape: tuple[int, ...], what: str, path: Path) -> np.ndarray:
    try:
        array = np.asarray(value, np.float64)
    except (TypeError, ValueError):
        array = np.zeros(0)
    if array.shape != shape or not np.isfinite(array).all():
        expected = " x ".join(map(str, shape))
        raise SceneError(f"{what}: found {value}, expected {expected} numbers", file=path)
    return array


def _read_image(path: Path) -> np.ndarray:
    """(h, w, 4) float32, linear, colour times alpha."""
    rgba = _read_exr_image(path) if path.suffix.lower() == ".exr" else _read_png(path)
    if not np.isfinite(rgba).all():
        row, column = np.argwhere(~np.isfinite(rgba).all(axis=-1))[0]
        raise SceneError(f"found NaN or infinity at row {row}, column {column}", file=path)
    return rgba


def _read_exr_image(path: Path) -> np.ndarray:
    channels, _ = read_exr(path)
    if missing := [c for c in "RGB" if c not in channels]:
        raise SceneError(f"has no channel {', '.join(missing)}", file=path)
    alpha = channels.get("A", np.ones_like(channels["R"]))
    return np.stack([*(channels[c] for c in "RGB"), alpha], axis=-1).astype(np.float32)


def _read_png(path: Path) -> np.ndarray:
    from PIL import Image

    try:
        with Image.open(path) as image:
            stored = np.asarray(image.convert("RGBA"), np.float32) / 255.0
    except FileNotFoundError as error:
        raise SceneError("no such file", file=path) from error
    except (OSError, SyntaxError) as error:
        raise SceneError(f"cannot read the image: {error}", file=path) from error
    rgb, alpha = stored[..., :3], stored[..., 3:]
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    return np.concatenate([linear * alpha, alpha], axis=-1).astype(np.float32)


def _read_depth(image: Path, size: tuple[int, ...]) -> np.ndarray | None:
    """(h, w) float32 beside the image; None where there is none."""
    path = image.with_name(f"{image.stem}{DEPTH}.exr")
    if not path.is_file():
        return None
    channels, _ = read_exr(path)
    depth = channels.get("Z")
    if depth is None or depth.shape != size or not np.isfinite(depth).all():
        raise SceneError("expected a finite channel Z of the image's size", file=path)
    return np.asarray(depth, np.float32)
