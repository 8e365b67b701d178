"""Serves one page and its files, with byte ranges and entity tags (RFC 9110), and nothing else.

Only the names that the site has are answered: nothing here reads a path from a request.
"""

import hashlib
import os
import re
from collections.abc import Mapping
from http import HTTPStatus
from pathlib import Path
from urllib.parse import unquote

from rna_sdk.commands.local_server import LOOPBACK, LocalHandler, LocalServer
from rna_sdk.errors import ViewError
from rna_view.site_files import SCENE, SITE_NAME, Site

TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".json": "application/json",
    ".glb": "model/gltf-binary",
}
HEADERS = {
    "Content-Security-Policy": "default-src 'none'; script-src 'self'; style-src 'self'; "
    "img-src 'self' blob: data:; connect-src 'self' blob:; base-uri 'none'; form-action 'none'",
    "Cross-Origin-Resource-Policy": "same-origin",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
}
_RANGE = re.compile(r"bytes=(\d{1,18})?-(\d{1,18})?")
_PIECE = 1 << 20


class PageServer(LocalServer):
    """Listens on this machine from the start, answers while `serve_forever` runs.

    port: 0 for any that is free. Raises ViewError if the address cannot be used.
    """

    def __init__(self, site: Site, port: int = 0) -> None:
        # The viewer's own files last: none of the site's takes their place.
        self.contents: dict[str, Path | bytes] = {
            **site.contents,
            **site.pages(),
        }
        self.tags = {name: _tag(name, content) for name, content in self.contents.items()}
        try:
            super().__init__(LOOPBACK, port, _Handler)
        except OSError as error:
            raise ViewError(f"cannot listen on port {port}: {error.strerror}") from error


class _Handler(LocalHandler):
    server: PageServer

    def do_GET(self) -> None:
        self._answer(with_body=True)

    def do_HEAD(self) -> None:
        self._answer(with_body=False)

    def version_string(self) -> str:
        return "rna-view"

    def _answer(self, with_body: bool) -> None:
        if not self.is_for_this_server():
            return self._refuse(HTTPStatus.FORBIDDEN)
        name = unquote(self.target()[0]).lstrip("/") or "index.html"
        content = self.server.contents.get(name)
        if content is None:
            return self._refuse(HTTPStatus.NOT_FOUND)
        try:
            self._send(name, content, with_body)
        except (FileNotFoundError, PermissionError):
            self._refuse(HTTPStatus.GONE)

    def _send(self, name: str, content: Path | bytes, with_body: bool) -> None:
        size = len(content) if isinstance(content, bytes) else os.stat(content).st_size
        tag = self.server.tags[name]
        if tag in _tags(self.headers.get("If-None-Match")):
            return self._begin(HTTPStatus.NOT_MODIFIED, name)
        is_same = self.headers.get("If-Range", tag) == tag
        span = _span(self.headers.get("Range") if is_same else None, size)
        if span is None:
            return self._refuse(HTTPStatus.REQUESTED_RANGE_NOT_SATISFIABLE, f"bytes */{size}")
        start, end = span
        is_part = (start, end) != (0, size)  # the whole is no part, even where it was asked for so
        more = {"Content-Length": str(end - start)}
        if is_part:
            more["Content-Range"] = f"bytes {start}-{end - 1}/{size}"
        self._begin(HTTPStatus.PARTIAL_CONTENT if is_part else HTTPStatus.OK, name, more)
        if with_body:
            self._write(content, start, end)

    def _begin(self, status: HTTPStatus, name: str, more: Mapping[str, str] = {}) -> None:
        """Status and headers of a file."""
        is_hash = SITE_NAME.fullmatch(name) is not None and name != SCENE
        headers = {
            "Content-Type": TYPES.get(Path(name).suffix, "application/octet-stream"),
            "Cache-Control": "public, max-age=31536000, immutable" if is_hash else "no-cache",
            "ETag": self.server.tags[name],
            "Accept-Ranges": "bytes",
        }
        self.send_response(status)
        for key, value in {**headers, **more, **HEADERS}.items():
            self.send_header(key, value)
        self.end_headers()

    def _write(self, content: Path | bytes, start: int, end: int) -> None:
        if isinstance(content, bytes):
            self.wfile.write(content[start:end])
            return
        with content.open("rb") as file:
            file.seek(start)
            while start < end and (piece := file.read(min(_PIECE, end - start))):
                self.wfile.write(piece)
                start += len(piece)
        self.close_connection = self.close_connection or start < end  # the file has become shorter

    def _refuse(self, status: HTTPStatus, content_range: str | None = None) -> None:
        self.send_response(status)
        if content_range is not None:
            self.send_header("Content-Range", content_range)
        self.send_header("Content-Length", "0")
        self.send_header("Connection", "close")  # a body that came with it is unread
        self.end_headers()


def _tag(name: str, content: Path | bytes) -> str:
    """A strong entity tag. Names of a site's files are hashes of them."""
    return f'"{hashlib.sha256(content).hexdigest()[:32] if isinstance(content, bytes) else name}"'


def _tags(header: str | None) -> list[str]:
    """Tags of an If-None-Match header, weak ones as strong ones (RFC 9110, 13.1.2)."""
    return [tag.strip().removeprefix("W/") for tag in (header or "").split(",")]


def _span(header: str | None, size: int) -> tuple[int, int] | None:
    """First byte and end of a Range header's range; all without one; None for an empty range.

    A header of another form, such as one of several ranges, is one that this server does not
    know, and gets all.
    """
    match = _RANGE.fullmatch(header or "")
    if match is None or match.group(1) is match.group(2) is None:
        return 0, size
    first, last = match.groups()
    if first is None:
        start, end = max(0, size - int(last)), size
    else:
        start, end = int(first), min(size, int(last) + 1) if last is not None else size
    return (start, end) if start < end else None
