"""HTML pages from Jinja2 templates."""

from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from rna_sdk.files.atomic_file import write_atomically

_TEMPLATES = Environment(
    loader=PackageLoader("rna_export"),
    autoescape=True,
    undefined=StrictUndefined,
    trim_blocks=True,
    lstrip_blocks=True,
)
_TEMPLATES.policies["json.dumps_kwargs"] = {"sort_keys": False}  # pages show things in order


def write_html(path: Path, template: str, **values: Any) -> None:
    """Write a page from a template in `templates`."""
    text = _TEMPLATES.get_template(template).render(**values)
    write_atomically(path, f"{text}\n".encode())
