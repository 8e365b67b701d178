"""HTML pages from Jinja2 templates."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from jinja2 import ChoiceLoader, Environment, PackageLoader, StrictUndefined

from rna_sdk.atomic_file import write_atomically


def templates(*packages: str) -> Environment:
    """The templates of the packages, each in a folder `templates`, and those of this one."""
    environment = Environment(
        loader=ChoiceLoader([PackageLoader(name) for name in (*packages, "rna_export")]),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.policies["json.dumps_kwargs"] = {"sort_keys": False}  # pages show things in order
    return environment


_TEMPLATES = templates()


def write_html(
    path: Path, template: str, environment: Environment = _TEMPLATES, **values: Any
) -> None:
    """Write a page from a template of the environment."""
    text = environment.get_template(template).render(**values)
    write_atomically(path, f"{text}\n".encode())
