"""Serves one page and its files, with byte ranges (RFC 9110, section 14), and nothing else.

Only the names that the site has are answered: nothing here reads a path from a request.
"""

from __future__ import annotations

import os
import re
import sys
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import unquote, urlsplit

from rna_view.errors import ViewError
from rna_view.site_files import VIEWER_FILES, Site, viewer_file

TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".json": "application/json",
}
HEADERS = {
    "Content-Security-Policy": "default-src 'none'; script-src 'self'; style-src 'self'; "
    "img-src 'self' blob: data:; connect-src 'self' blob:; base-uri 'none'; form-action 'none'",
    "Cache-Control": "no-cache",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
}
_RANGE = re.compile(r"bytes=(\d{1,18})?-(\d{1,18})?")
_PIECE = 1 << 20


class PageServer(ThreadingHTTPServer):
    """Listens from the start, answers while `serve_forever` runs.

    port: 0 for any that is free. Raises ViewError if the address cannot be used.
    """

    daemon_threads = True
    block_on_close = False

    def __init__(self, site: Site, host: str = "127.0.0.1", port: int = 0) -> None:
        self.contents: dict[str, Path | bytes] = {
            **{name: viewer_file(name) for name in VIEWER_FILES},
            **site.contents,
            "index.html": site.index(),
        }
        try:
            super().__init__((host, port), _Handler)
        except OSError as error:
            raise ViewError(f"cannot listen on {host}:{port}: {error.strerror}") from error
        self.is_local = host in ("127.0.0.1", "localhost")
        names = ("127.0.0.1", "localhost")
        self.hosts = {f"{name}:{self.server_port}" for name in names} if self.is_local else None

    @property
    def url(self) -> str:
        """The page's address."""
        host = str(self.server_address[0])
        return f"http://{host}:{self.server_port}/"

    def handle_error(self, request: object, client_address: object) -> None:
        """A page that was closed is no error."""
        if not isinstance(sys.exception(), ConnectionError | TimeoutError):
            super().handle_error(request, client_address)  # type: ignore[arg-type]


class _Handler(BaseHTTPRequestHandler):
    server: PageServer
    protocol_version = "HTTP/1.1"
    disable_nagle_algorithm = True
    timeout = 60.0

    def do_GET(self) -> None:
        self._answer(with_body=True)

    def do_HEAD(self) -> None:
        self._answer(with_body=False)

    def version_string(self) -> str:
        return "rna-view"

    def log_message(self, *arguments: object) -> None:
        """The terminal is for the address."""

    def _answer(self, with_body: bool) -> None:
        # Other names for this computer would be those of other pages (DNS rebinding).
        hosts = self.server.hosts
        if hosts is not None and self.headers.get("Host") not in hosts:
            return self._refuse(HTTPStatus.FORBIDDEN)
        name = unquote(urlsplit(self.path).path).lstrip("/") or "index.html"
        content = self.server.contents.get(name)
        if content is None:
            return self._refuse(HTTPStatus.NOT_FOUND)
        try:
            self._send(name, content, with_body)
        except FileNotFoundError:
            self._refuse(HTTPStatus.GONE)

    def _send(self, name: str, content: Path | bytes, with_body: bool) -> None:
        size = len(content) if isinstance(content, bytes) else os.stat(content).st_size
        span = _span(self.headers.get("Range"), size)
        if span is None:
            return self._refuse(HTTPStatus.REQUESTED_RANGE_NOT_SATISFIABLE, f"bytes */{size}")
        start, end = span
        is_part = (start, end) != (0, size)  # the whole is no part, even where it was asked for so
        self.send_response(HTTPStatus.PARTIAL_CONTENT if is_part else HTTPStatus.OK)
        if is_part:
            self.send_header("Content-Range", f"bytes {start}-{end - 1}/{size}")
        kind = TYPES.get(Path(name).suffix, "application/octet-stream")
        headers = {"Content-Type": kind, "Content-Length": str(end - start)}
        for key, value in {"Accept-Ranges": "bytes", **headers, **HEADERS}.items():
            self.send_header(key, value)
        self.end_headers()
        if with_body:
            self._write(content, start, end)

    def _write(self, content: Path | bytes, start: int, end: int) -> None:
        if isinstance(content, bytes):
            self.wfile.write(content[start:end])
            return
        with content.open("rb") as file:
            file.seek(start)
            while start < end and (piece := file.read(min(_PIECE, end - start))):
                self.wfile.write(piece)
                start += len(piece)

    def _refuse(self, status: HTTPStatus, content_range: str | None = None) -> None:
        self.send_response(status)
        if content_range is not None:
            self.send_header("Content-Range", content_range)
        self.send_header("Content-Length", "0")
        self.end_headers()


def _span(asked: str | None, size: int) -> tuple[int, int] | None:
    """First byte and end of a Range header's range; all without one; None for an empty range.

    A header of another form, such as one of several ranges, is one that this server does not
    know, and gets all.
    """
    found = _RANGE.fullmatch(asked or "")
    if found is None or found.group(1) is found.group(2) is None:
        return 0, size
    first, last = found.groups()
    if first is None:
        start, end = max(0, size - int(last)), size
    else:
        start, end = int(first), min(size, int(last) + 1) if last is not None else size
    return (start, end) if start < end else None
