"""Files that go to a Blender process or come from it, and Cycles' results along rays."""

import contextlib
import errno
import os
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from zipfile import BadZipFile

import numpy as np
import OpenEXR

from rna_export.capture.blender_axes import from_blender
from rna_sdk.errors import CaptureError

_LITTLE = 1 << 20  # bytes; with fewer, the disk is full


@contextlib.contextmanager
def exchanged(path: Path) -> Iterator[None]:
    """Raises CaptureError where a file that goes to Blender or comes from it is not whole."""
    try:
        yield
    except (OSError, RuntimeError, ValueError, KeyError, EOFError, BadZipFile) as error:
        why = no_space_left(path.parent) or " ".join(str(error).split())
        raise CaptureError(f"{path}: a file exchanged with Blender is not whole: {why}") from error


def no_space_left(folder: Path) -> str | None:
    """The system's words for a full disk; None where it is not full."""
    is_full = shutil.disk_usage(folder).free < _LITTLE
    return os.strerror(errno.ENOSPC) if is_full else None


def write_rays(path: Path, vectors: np.ndarray, width: int, height: int) -> None:
    image = np.zeros((height * width, 3), np.float32)
    image[: len(vectors)] = vectors
    header = {"compression": OpenEXR.NO_COMPRESSION, "type": OpenEXR.scanlineimage}
    channels = {"RGB": image.reshape(height, width, 3)}
    with exchanged(path), OpenEXR.File(header, channels) as file:
        file.write(str(path))


def read_render(path: Path, *needed: str) -> dict[str, np.ndarray]:
    """The channels of a multilayer or multi-part EXR, "Pass.C" -> (pixels,) float32.

    needed: passes, of which it is an error that one is missing.
    """
    planes: dict[str, np.ndarray] = {}
    if not path.is_file():
        raise CaptureError(f"{path}: Blender wrote no image")
    with exchanged(path):
        with OpenEXR.File(str(path), separate_channels=True) as file:
            for part in file.parts:
                for name, channel in part.channels.items():
                    pixels = np.asarray(channel.pixels, np.float32).reshape(-1)
                    planes[".".join(name.split(".")[-2:])] = pixels
        there = {name.rpartition(".")[0] for name in planes}
        if missing := {"Combined", *needed} - there:
            raise ValueError(f"it has no {', '.join(sorted(missing))}")
    return planes


_LOBES = ("Diffuse", "Glossy", "Transmission")

Passes = dict[str, np.ndarray]
"""Channels of a render, "Pass.C" -> (pixels,) float32."""


def needed_passes(has_fibers: bool) -> tuple[str, ...]:
    """Passes that `RenderedRays.of_passes` reads."""
    lobes = [f"{lobe} {kind}" for lobe in _LOBES for kind in ("Direct", "Color")]
    return "Combined", "Position", *(lobes if has_fibers else ())


@dataclass(frozen=True)
class RenderedRays:
    """One row a ray, float32.

    radiance: (n, 3) under irradiance 1. alpha: (n,), 1 for a hit. position: (n, 3) Cycles' own
    hits, object space. direct: (n, 3) the part of the radiance that scattered once, at the hit
    itself: without noise on fibers. None of a source without fibers. normal: (n, 3) Cycles' shading
    normals, object space; None where they were not asked for.
    """

    radiance: np.ndarray
    alpha: np.ndarray
    position: np.ndarray
    direct: np.ndarray | None
    normal: np.ndarray | None = None

    @classmethod
    def of_passes(cls, passes: Passes, n: int, has_fibers: bool) -> "RenderedRays":
        """The first n pixels of a render with the passes of `needed_passes`."""
        rgba = channels(passes, "Combined", "RGBA")[:n]
        position = from_blender(channels(passes, "Position", "XYZ")[:n])
        direct = _direct(passes)[:n] if has_fibers else None
        normal = None
        if "Normal.X" in passes:
            normal = from_blender(channels(passes, "Normal", "XYZ")[:n])
        return cls(rgba[:, :3], rgba[:, 3], position, direct, normal)


def channels(passes: Passes, name: str, letters: str) -> np.ndarray:
    """Channels of a pass, (pixels, k) float32."""
    return np.stack([passes[f"{name}.{c}"] for c in letters], axis=-1)


def _direct(passes: Passes) -> np.ndarray:
    """Light of no bounce; Cycles divides each lobe's by its colour."""
    lobes = [
        channels(passes, f"{lobe} Direct", "RGB") * channels(passes, f"{lobe} Color", "RGB")
        for lobe in _LOBES
    ]
    diffuse, glossy, transmission = lobes
    return np.asarray(diffuse + glossy + transmission)
