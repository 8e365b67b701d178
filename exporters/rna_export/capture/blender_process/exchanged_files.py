"""Files that go to a Blender process or come from it."""

from __future__ import annotations

import contextlib
import errno
import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from zipfile import BadZipFile

import numpy as np
import OpenEXR

from rna_sdk.errors import CaptureError

_LITTLE = 1 << 20  # bytes; with fewer, the disk is full


@contextlib.contextmanager
def exchanged(path: Path) -> Iterator[None]:
    """Raises CaptureError where a file that goes to Blender or comes from it is not whole."""
    try:
        yield
    except (OSError, RuntimeError, ValueError, KeyError, EOFError, BadZipFile) as error:
        is_full = shutil.disk_usage(path.parent).free < _LITTLE
        why = os.strerror(errno.ENOSPC) if is_full else " ".join(str(error).split())
        raise CaptureError(f"{path}: a file exchanged with Blender is not whole: {why}") from error


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
