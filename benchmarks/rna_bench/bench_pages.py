"""HTML pages from Jinja2 templates, and pictures for pages."""

from __future__ import annotations

import base64
import io
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from rna_export import html_pages

_TEMPLATES = html_pages.templates("rna_bench")


def write_html(path: Path, template: str, **values: Any) -> None:
    """Write a page; `template`: a file of the folder `templates`."""
    html_pages.write_html(path, template, _TEMPLATES, **values)


def webp_address(pixels: np.ndarray, quality: int = 80) -> str:
    """A picture (h, w, 3) uint8 as a data address, for pages that need no other file."""
    buffer = io.BytesIO()
    image = Image.fromarray(np.ascontiguousarray(pixels))
    image.save(buffer, "WEBP", quality=quality, method=6)
    return "data:image/webp;base64," + base64.b64encode(buffer.getvalue()).decode()


def save_picture(image: Image.Image, path: Path) -> None:
    """Write PNG, or JPEG of high quality for documents, chosen by the suffix."""
    image.save(path, quality=90, subsampling=0, optimize=True)
