"""How large an environment's image may be: checked before it is allocated."""

from __future__ import annotations

from pathlib import Path

from rna_render.scene.limits import (
    MAX_EXPANSION,
    MAX_FREE_BYTES,
    MAX_IMAGE_PIXELS,
    MAX_PIXELS_A_SIDE,
)
from rna_sdk.errors import SceneError

BYTES_A_TEXEL = 12  # float32 RGB


def check_image_size(path: Path, width: int, height: int) -> None:
    """Raise SceneError if an image of that size is empty, too large, or too large for its file."""
    too_long = max(width, height) > MAX_PIXELS_A_SIDE or width * height > MAX_IMAGE_PIXELS
    if min(width, height) < 1 or too_long:
        raise SceneError(
            f"has {width} x {height} pixels; from 1 to {MAX_PIXELS_A_SIDE} a side, 2^27 in all",
            file=path,
        )
    size, stored = width * height * BYTES_A_TEXEL, path.stat().st_size
    if size > MAX_FREE_BYTES and size > MAX_EXPANSION * stored:
        raise SceneError(
            f"has {width} x {height} pixels in {stored} bytes; an image above {MAX_FREE_BYTES} "
            f"bytes of radiance is at most {MAX_EXPANSION} times its file",
            file=path,
        )
