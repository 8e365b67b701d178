"""Serves the preview's page, on this computer alone.

    GET /               the page; /preview.js and /preview.css, its script and its style
    GET /state          what its controls show, JSON
    GET /picture?after=SERIAL
                        the newest picture, JPEG, once there is one with a higher serial; its label
                        as JSON in the header Rna-Label. 204 if none comes in a while.
    GET /picture.png    the newest picture as a PNG
    POST /change        a Change, JSON; answers with the new state once no older picture is sent

Any web page that the user has open can send requests to this address, so those that do not come
from the page itself are refused: other names for this computer (DNS rebinding), other origins, and
whatever the browser says is from another site. Nothing here reads a path from a request.
"""

import json
from collections.abc import Callable
from dataclasses import asdict
from http import HTTPStatus
from importlib.resources import files
from urllib.parse import parse_qs

from pydantic import ValidationError

from rna_render.preview.change import Change
from rna_render.preview.session import Session
from rna_sdk.commands.local_server import LOOPBACK, LocalHandler, LocalServer
from rna_sdk.errors import PreviewError, QueryError

MAX_BODY = 4096
# Shorter than a browser or a proxy waits for an answer.
LONG_POLL_S = 20.0

HEADERS = {
    "Cache-Control": "no-store",
    # The page brings all it needs; no other page may frame it, and none may use its pictures.
    "Content-Security-Policy": "default-src 'none'; script-src 'self'; "
    "style-src 'self'; img-src 'self' data: blob:; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
}


# What scripts/web-bundle builds from runtime/web, by the path that it is asked for with.
PAGE = {
    "/": ("index.html", "text/html; charset=utf-8"),
    "/preview.js": ("preview.js", "text/javascript; charset=utf-8"),
    "/preview.css": ("preview.css", "text/css; charset=utf-8"),
}


def page_file(name: str) -> bytes:
    """A file of the page."""
    return (files("rna_render.preview") / "site" / name).read_bytes()


class PreviewServer(LocalServer):
    """Listens from the start, answers while `serve_forever` runs.

    port: 0 for any that is free. Raises PreviewError if it is not free.
    """

    def __init__(self, port: int, session: Session | None = None) -> None:
        self.page = {path: (kind, page_file(name)) for path, (name, kind) in PAGE.items()}
        self.session = session
        try:
            super().__init__(LOOPBACK, port, _Handler)
        except OSError as error:
            raise PreviewError(f"cannot listen on {LOOPBACK}:{port}: {error.strerror}") from error


class _Refusal(Exception):
    """A request that gets no more than a status and one line."""

    def __init__(self, status: HTTPStatus, message: str) -> None:
        super().__init__(message)
        self.status = status


class _Handler(LocalHandler):
    server: PreviewServer

    def do_GET(self) -> None:
        pages = dict.fromkeys(PAGE, self._page)
        self._answer(
            {**pages, "/state": self._state, "/picture": self._picture, "/picture.png": self._png}
        )

    def do_POST(self) -> None:
        self._answer({"/change": self._change})

    def version_string(self) -> str:
        return "rna-run"

    def _answer(self, routes: dict[str, Callable[[], None]]) -> None:
        try:
            self._check_sender()
            route = routes.get(self.target()[0])
            if route is None:
                raise _Refusal(HTTPStatus.NOT_FOUND, "there is nothing here")
            route()
        except _Refusal as refusal:
            # Its body, if it has one, is unread.
            self.close_connection = True
            body = json.dumps({"error": str(refusal)}).encode()
            self._send(refusal.status, "application/json", body, {"Connection": "close"})

    def _check_sender(self) -> None:
        headers = self.headers
        host, origin = headers.get("Host"), headers.get("Origin")
        if not self.is_for_this_server():
            raise _Refusal(HTTPStatus.FORBIDDEN, "not a name of this server")
        if origin is not None and origin != f"http://{host}":
            raise _Refusal(HTTPStatus.FORBIDDEN, "not for other pages")
        # A link to the page itself may stand anywhere.
        site = headers.get("Sec-Fetch-Site", "same-origin")
        if site not in ("same-origin", "none") and headers.get("Sec-Fetch-Mode") != "navigate":
            raise _Refusal(HTTPStatus.FORBIDDEN, "not for other pages")

    def _page(self) -> None:
        self._send(HTTPStatus.OK, *self.server.page[self.target()[0]])

    def _state(self) -> None:
        self._send_json(self._session().state())

    def _picture(self) -> None:
        after = parse_qs(self.target()[1]).get("after", ["0"])[-1]
        if not (after.isascii() and after.isdigit() and len(after) < 16):
            raise _Refusal(HTTPStatus.BAD_REQUEST, "after: expected a whole number")
        session = self._session()
        while (picture := session.wait(int(after), LONG_POLL_S)) is not None:
            jpeg = picture.jpeg
            # Encoding takes a while, and the view may have changed meanwhile.
            if session.is_current(picture):
                label = json.dumps(asdict(picture.label))
                self._send(HTTPStatus.OK, "image/jpeg", jpeg, {"Rna-Label": label})
                return
        self._session()
        self._send(HTTPStatus.NO_CONTENT, None, b"")

    def _png(self) -> None:
        picture = self._session().newest()
        if picture is None or picture.rgba is None:
            raise _Refusal(HTTPStatus.NOT_FOUND, "there is no picture yet")
        self._send(HTTPStatus.OK, "image/png", picture.png)

    def _change(self) -> None:
        # Other origins cannot send this type without asking first, and they get no answer.
        if self.headers.get_content_type() != "application/json":
            raise _Refusal(HTTPStatus.UNSUPPORTED_MEDIA_TYPE, "expected application/json")
        length = self.headers.get("Content-Length", "")
        if not (length.isascii() and length.isdigit()):
            raise _Refusal(HTTPStatus.LENGTH_REQUIRED, "expected Content-Length")
        if len(length) > 9 or int(length) > MAX_BODY:
            raise _Refusal(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, f"at most {MAX_BODY} bytes")
        try:
            change = Change.model_validate_json(self.rfile.read(int(length)))
            self._send_json(self._session().change(change))
        except ValidationError as error:
            first = error.errors()[0]
            place = ".".join(str(part) for part in first["loc"])
            message = f"{place}: {first['msg']}" if place else first["msg"]
            raise _Refusal(HTTPStatus.BAD_REQUEST, message) from error
        except QueryError as error:
            raise _Refusal(HTTPStatus.BAD_REQUEST, str(error)) from error

    def _session(self) -> Session:
        session = self.server.session
        if session is None or session.ended:
            raise _Refusal(HTTPStatus.SERVICE_UNAVAILABLE, "the preview has ended")
        return session

    def _send_json(self, value: object) -> None:
        self._send(HTTPStatus.OK, "application/json", json.dumps(value).encode())

    def _send(
        self,
        status: HTTPStatus,
        content: str | None,
        body: bytes,
        more: dict[str, str] | None = None,
    ) -> None:
        self.send_response(status)
        for name, value in {**HEADERS, **(more or {})}.items():
            self.send_header(name, value)
        if content is not None:
            self.send_header("Content-Type", content)
            self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)
