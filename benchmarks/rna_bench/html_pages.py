"""HTML pages from Jinja2 templates."""

from __future__ import annotations

import base64
import io
from pathlib import Path
from typing import Any

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined
from PIL import Image

from rna_sdk.atomic_file import write_atomically

_TEMPLATES = Environment(
    loader=PackageLoader("rna_bench", "templates"),
    autoescape=True,
    undefined=StrictUndefined,
    trim_blocks=True,
    lstrip_blocks=True,
)
_TEMPLATES.policies["json.dumps_kwargs"] = {"sort_keys": False}  # pages show things in order


def write_html(path: Path, template: str, **values: Any) -> None:
    """Write a page; `template`: a file of the folder `templates`."""
    text = _TEMPLATES.get_template(template).render(**values)
    write_atomically(path, f"{text}\n".encode())


def webp_address(pixels: np.ndarray, quality: int = 80) -> str:
    """A picture (h, w, 3) uint8 as a data address, for pages that need no other file."""
    buffer = io.BytesIO()
    image = Image.fromarray(np.ascontiguousarray(pixels))
    image.save(buffer, "WEBP", quality=quality, method=6)
    return "data:image/webp;base64," + base64.b64encode(buffer.getvalue()).decode()
