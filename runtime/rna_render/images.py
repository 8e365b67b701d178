"""Image files. Each is written beside its place and then renamed, so none is ever half there."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np

from rna_render.srgb import encode_srgb
from rna_sdk.errors import SceneError


def write_exr(path: Path, channels: Mapping[str, np.ndarray], attributes: dict[str, str]) -> None:
    """Write a scan-line EXR with lossless ZIP compression.

    channels: name to (height, width) float32 or uint32. attributes: text kept in the header.
    Raises SceneError if the file cannot be written.
    """
    import OpenEXR

    header = {
        "compression": OpenEXR.ZIP_COMPRESSION,
        "type": OpenEXR.scanlineimage,
        **attributes,
    }
    file = OpenEXR.File(header, dict(channels))
    _write(path, lambda temporary: file.write(str(temporary)))


def read_exr(path: Path) -> tuple[dict[str, np.ndarray], dict[str, object]]:
    """The channels, each (height, width), and the header of a single-part EXR.

    Raises SceneError if the file cannot be read.
    """
    import OpenEXR

    try:
        with OpenEXR.File(str(path), separate_channels=True) as file:
            channels = {name: channel.pixels.copy() for name, channel in file.channels().items()}
            return channels, dict(file.header())
    except (OSError, RuntimeError, ValueError) as error:
        raise SceneError(f"cannot read the image: {error}", file=path) from error


def write_png(path: Path, rgb: np.ndarray, exposure: float = 0.0) -> None:
    """Write an 8-bit sRGB PNG of linear radiance times 2^exposure, clamped to [0, 1].

    rgb: (height, width, 3) float. Raises SceneError if the file cannot be written.
    """
    from PIL import Image

    encoded = encode_srgb(np.asarray(rgb, np.float64) * 2.0**exposure)
    image = Image.fromarray(np.rint(encoded * 255.0).astype(np.uint8))
    _write(path, lambda temporary: image.save(temporary, format="PNG"))


def _write(path: Path, save: Callable[[Path], object]) -> None:
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        save(temporary)
        os.replace(temporary, path)
    except (OSError, RuntimeError) as error:
        raise SceneError(f"cannot write the image: {error}", file=path) from error
    finally:
        temporary.unlink(missing_ok=True)
