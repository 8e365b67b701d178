"""Pictures of reports, as PNG files."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

import numpy as np
from PIL import Image

from rna_sdk.atomic_file import write_atomically


def write_picture(path: Path, picture: Image.Image | np.ndarray) -> None:
    """Write a PNG atomically. picture: an array is (h, w, 3) uint8, sRGB."""
    data = BytesIO()
    image = Image.fromarray(picture) if isinstance(picture, np.ndarray) else picture
    image.save(data, "PNG")
    write_atomically(path, data.getvalue())
