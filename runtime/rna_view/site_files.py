"""The files of a viewer page: the viewer, the asset, its lighting."""

import hashlib
import io
import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from html import escape
from importlib.resources import files
from pathlib import Path

from rna_sdk.errors import ViewError
from rna_sdk.package import Package

ELEMENT = "rna-viewer.js"
"""Defines the element, on the page and on any other."""
VIEWER_FILES = ("index.html", "viewer.js", "viewer.css", ELEMENT)
GALLERY_FILES = ("gallery.html", "gallery.js", "gallery.css", ELEMENT)
LIGHT = ' sun="40deg 45deg 2" ground'
"""Attributes that the page's element has where there is no scene file."""
SCENE = "scene.json"
SITE_NAME = re.compile(rf"[0-9a-f]{{32}}\.(rna|glb|exr|hdr|png|jpg|webp)|{re.escape(SCENE)}")
"""Names that a page's own files can have; no file of the viewer has such a name."""

# First bytes of the file, by which images are distinguished everywhere.
_IMAGE_SUFFIXES = {b"\x76\x2f\x31\x01": ".exr", b"#?": ".hdr"}
_PRINT_SUFFIXES = {b"\x89PNG": ".png", b"\xff\xd8\xff": ".jpg", b"RIFF": ".webp"}


@dataclass(frozen=True)
class Site:
    """A page.

    Attributes:
        contents: by name, the file, or its bytes. Names are hashes of what the files hold, with a
            suffix that says what that is: a name that somebody else chose can be taken for an
            address, or for a file of the viewer.
        attributes: of the page's element, as `src="NAME"`.
        maps: other images of base colour: names of files by label.
        labels: what people call a file, by its name.
        notes: what a person should know, one line each.
    """

    contents: dict[str, Path | bytes] = field(default_factory=dict)
    attributes: dict[str, str] = field(default_factory=dict)
    maps: dict[str, str] = field(default_factory=dict)
    labels: dict[str, str] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)

    def pages(self) -> dict[str, bytes]:
        """The page's own files, by name."""
        return {name: viewer_file(name) for name in VIEWER_FILES} | {"index.html": self.index()}

    def add_package(self, path: Path) -> str:
        """Add a package; returns its name in the page. Raises PackageError for any other file.

        A page that shows the package of a .glb has no use for its fallback.
        """
        with Package.open(path) as package:
            carried = bytes(package.file_data) if package.carrier else None
        return self._add(path, ".rna", carried)

    def add_glass(self, path: Path) -> None:
        """Show the package with the smooth glass beside it.

        Raises ViewError for a file that does not begin as a .glb.
        """
        with path.open("rb") as file:
            if file.read(4) != b"glTF":
                raise ViewError(f"{path}: expected the glass as a .glb")
        self.attributes["glass"] = self._add(path, ".glb")

    def add_image(self, path: Path) -> str:
        """Add an environment image, .exr or .hdr; returns its name in the page.

        Raises ViewError for a file that does not begin as one.
        """
        return self._add_image(path, _IMAGE_SUFFIXES, "an environment image, .hdr or .exr")

    def add_print(self, label: str, path: Path) -> None:
        """Add another image for the asset's base colour with that label.

        Raises ViewError for a file that does not begin as one.
        """
        self.maps[label] = self._add_image(path, _PRINT_SUFFIXES, "a PNG, JPEG or WebP image")

    def add_scene(self, record: object) -> str:
        """Add the scene's facts for the page; returns its name in the page."""
        self.contents[SCENE] = json.dumps(record).encode()
        return SCENE

    def index(self) -> bytes:
        """index.html, which opens the site's scene or package."""
        labels = escape(json.dumps(self.labels))
        tag = f'<rna-viewer{self.written_attributes()} data-rna-labels="{labels}"'
        return viewer_file("index.html").replace(b"<rna-viewer", tag.encode(), 1)

    def written_attributes(self, address: str = "") -> str:
        """The element's attributes in HTML, each after a space. address: of the page's folder."""
        addresses = {name: address for name in ("src", "glass", "environment", "scene")}
        written = {name: addresses.get(name, "") + value for name, value in self.attributes.items()}
        if self.maps:
            pairs = (f"{label}={address}{name}" for label, name in self.maps.items())
            written["maps"] = " ".join(pairs)
        return "".join(f' {name}="{escape(value)}"' for name, value in written.items())

    def _add_image(self, path: Path, suffixes: Mapping[bytes, str], expected: str) -> str:
        with path.open("rb") as file:
            start = file.read(4)
        found = [suffix for magic, suffix in suffixes.items() if start.startswith(magic)]
        if not found:
            raise ViewError(f"{path}: expected {expected}")
        return self._add(path, found[0])

    def _add(self, path: Path, suffix: str, data: bytes | None = None) -> str:
        """data: to show in the place of the file's."""
        with path.open("rb") if data is None else io.BytesIO(data) as file:
            digest = hashlib.file_digest(file, "sha256").hexdigest()
        name = digest[:32] + suffix
        self.contents[name] = path if data is None else data
        self.labels[name] = path.name
        return name


@dataclass(frozen=True)
class Gallery(Site):
    """A page of several assets under one light.

    Attributes:
        assets: the page of each alone, by what people call it. Their contents are the page's.
    """

    assets: list[tuple[str, Site]] = field(default_factory=list)

    def add(self, title: str, site: Site) -> None:
        """Show the package of a page in this one, too."""
        self.contents.update(site.contents)
        self.labels.update(site.labels)
        self.assets.append((title, site))

    def pages(self) -> dict[str, bytes]:
        """The page's own files, by name."""
        first, *others = GALLERY_FILES
        figures = "".join(self._figure(title, site) for title, site in self.assets).encode()
        index = viewer_file(first).replace(b'<main id="assets">', b'<main id="assets">' + figures)
        return {"index.html": index} | {name: viewer_file(name) for name in others}

    def _figure(self, title: str, site: Site) -> str:
        name = escape(title)
        attributes = site.written_attributes() + LIGHT
        if "environment" in self.attributes:
            attributes += f' environment="{self.attributes["environment"]}"'
        viewer = f'<rna-viewer{attributes} alt="{name}" camera-controls>'
        return f"<figure>{viewer}</rna-viewer><figcaption>{name}</figcaption></figure>"


def viewer_file(name: str) -> bytes:
    """A file of the viewer."""
    return (files("rna_view") / "site" / name).read_bytes()
