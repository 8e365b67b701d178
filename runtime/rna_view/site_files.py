"""The files of a viewer page: those of the viewer itself, the asset, what lights it."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from html import escape
from importlib.resources import files
from pathlib import Path
from urllib.parse import quote, urlencode

from rna_view.errors import ViewError

VIEWER_FILES = ("index.html", "viewer.js", "viewer.css")
IMAGE_SUFFIXES = (".hdr", ".exr", ".pic")


@dataclass(frozen=True)
class Site:
    """A page.

    Attributes:
        contents: by name, the file, or its bytes.
        query: what the page's address would ask for, as `asset=toy.rna`.
        notes: what a person should know, one line each.
    """

    contents: dict[str, Path | bytes]
    query: dict[str, str]
    notes: list[str] = field(default_factory=list)

    def index(self) -> bytes:
        """index.html, which opens the site's scene or package."""
        page = viewer_file("index.html").decode()
        asked = escape(urlencode(self.query, quote_via=quote))
        return page.replace("<body>", f'<body data-query="{asked}">', 1).encode()


def viewer_file(name: str) -> bytes:
    """A file of the viewer."""
    return (files("rna_view") / "site" / name).read_bytes()


def site_for(source: Path, tier: str | None = None, environment: Path | None = None) -> Site:
    """The page for a package or a scene file.

    Raises:
        ViewError: a file that is not there, or of another kind.
        RnaError: of a scene file, what is wrong with it.
    """
    if not source.is_file():
        raise ViewError(f"{source}: no such file")
    if source.suffix in (".yaml", ".yml"):
        from rna_view.scene_page import scene_site  # which needs the renderer

        site = scene_site(source)
    elif source.suffix == ".rna":
        site = Site({source.name: source}, {"asset": source.name})
    else:
        raise ViewError(f"{source}: expected a .rna package or a .yaml scene file")
    if tier is not None:
        site.query["tier"] = tier
    if environment is not None:
        _add_environment(site, environment)
    return site


def _add_environment(site: Site, path: Path) -> None:
    if path.suffix.lower() not in IMAGE_SUFFIXES or not path.is_file():
        raise ViewError(f"{path}: expected an environment image, .hdr or .exr")
    site.contents[path.name] = path
    site.query["env"] = path.name


def json_bytes(value: object) -> bytes:
    """JSON of one line."""
    return json.dumps(value).encode()
