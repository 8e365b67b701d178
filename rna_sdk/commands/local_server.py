"""Web servers for pages of this computer's user: few connections, and no names of other sites.

Any web page that the user has open can send requests to a port of this computer. The browser keeps
its scripts from reading the answers, unless the page's own name leads here (DNS rebinding): so
requests that name a host which may be another site's are refused.
"""

import ipaddress
import socket
import sys
import threading
import time
from contextlib import suppress
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

LOOPBACK = "127.0.0.1"
MAX_CONNECTIONS = 64
"""Open at a time; each has a thread. A browser opens 6 to a server."""
IDLE_S = 60.0
"""Seconds that a connection may wait for its next request."""
PATIENCE_S = 2.0
"""Seconds for a request to come in whole, where others wait for a connection."""

_BUSY = (
    b"HTTP/1.1 503 Service Unavailable\r\nContent-Length: 0\r\nRetry-After: 1\r\n"
    b"Connection: close\r\n\r\n"
)
# Names that no other site can have: RFC 6762 (local), RFC 8375 (home.arpa), ICANN 2024 (internal).
_PRIVATE_SUFFIXES = (".local", ".home.arpa", ".internal")


class LocalServer(ThreadingHTTPServer):
    """Listens from the start, answers while `serve_forever` runs.

    host: loopback, or an address that other machines reach. port: 0 for any that is free. Raises
    OSError if the address cannot be used.
    """

    daemon_threads = True
    block_on_close = False
    request_queue_size = MAX_CONNECTIONS  # a client that finds the queue full tries again after 1 s

    def __init__(self, host: str, port: int, handler: type["LocalHandler"]) -> None:
        self._free = threading.BoundedSemaphore(MAX_CONNECTIONS)
        self._waiting: dict[socket.socket, float] = {}  # for a request, and since when
        self._lock = threading.Lock()
        try:
            super().__init__((host, port), handler)
        except (OverflowError, UnicodeError) as error:
            raise OSError(0, f"no such address ({error})") from error
        self.is_local = host in (LOOPBACK, "localhost")

    @property
    def url(self) -> str:
        """The page's address."""
        return f"http://{self.server_address[0]!s}:{self.server_port}/"

    def answers_to(self, host: str | None) -> bool:
        """Whether a request's Host header names this computer, and cannot be another site's name.

        On loopback: 127.0.0.1 and localhost with the port. Else also addresses, names without a
        dot and names of the local network.
        """
        if host is None:
            return False
        name, _, port = host.rpartition(":")
        if not name or port != str(self.server_port):
            name, port = host, "80"  # which browsers leave out
        if port != str(self.server_port):
            return False
        if self.is_local:
            return name in (LOOPBACK, "localhost")
        return _is_address(name.strip("[]")) or _is_private(name.lower())

    def process_request(self, request: Any, client_address: Any) -> None:
        """A thread for the connection; one too many takes the place of one that waits for long."""
        if not self._free.acquire(blocking=False) and not self._has_made_room():
            with suppress(OSError):
                request.sendall(_BUSY)
            self.shutdown_request(request)
            return
        try:
            super().process_request(request, client_address)
        except BaseException:
            self._free.release()
            raise

    def is_waiting(self, connection: socket.socket, waits: bool) -> None:
        """Note whether a connection waits for its next request."""
        with self._lock:
            self._waiting.pop(connection, None)
            if waits:
                self._waiting[connection] = time.monotonic()

    def _has_made_room(self) -> bool:
        """Whether the connection that has waited longest could be closed, and its place taken."""
        with self._lock:
            longest, since = next(iter(self._waiting.items()), (None, 0.0))
        if longest is None or time.monotonic() - since < PATIENCE_S:
            return False
        self.is_waiting(longest, False)
        with suppress(OSError):
            longest.shutdown(socket.SHUT_RDWR)
        return self._free.acquire(timeout=PATIENCE_S)

    def process_request_thread(self, request: Any, client_address: Any) -> None:
        """Work of the connection's thread."""
        try:
            super().process_request_thread(request, client_address)
        finally:
            self.is_waiting(request, False)
            self._free.release()

    def handle_error(self, request: Any, client_address: Any) -> None:
        """A page that was closed is no error."""
        if not isinstance(sys.exception(), ConnectionError | TimeoutError):
            super().handle_error(request, client_address)


class LocalHandler(BaseHTTPRequestHandler):
    """Requests of one connection; quiet, for the terminal is for the address."""

    server: LocalServer
    protocol_version = "HTTP/1.1"
    disable_nagle_algorithm = True
    timeout = IDLE_S

    def handle_one_request(self) -> None:
        """Waits for a request, and answers it."""
        self.server.is_waiting(self.connection, True)
        super().handle_one_request()

    def parse_request(self) -> bool:
        """Reads the headers; a request with a body is then complete, and short."""
        is_whole = super().parse_request()
        if self.command in ("GET", "HEAD"):
            self.server.is_waiting(self.connection, False)
        return is_whole

    def log_message(self, *arguments: Any) -> None:
        """Nothing."""

    def is_for_this_server(self) -> bool:
        """Whether the request names this server, once; see `LocalServer.answers_to`."""
        hosts = self.headers.get_all("Host", [])
        return len(hosts) == 1 and self.server.answers_to(hosts[0])

    def target(self) -> tuple[str, str]:
        """Path and query that are asked for, percent-encoded, whatever the client sent.

        A whole address (RFC 9112, 3.2.2) gives its path.
        """
        target = self.path
        scheme, result, rest = target.partition("://")
        if result and scheme.lower() in ("http", "https"):
            target = "/" + rest.partition("/")[2]
        path, _, query = target.partition("#")[0].partition("?")
        return path, query


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def _is_private(name: str) -> bool:
    return "." not in name or name.endswith(_PRIVATE_SUFFIXES) or name == socket.getfqdn().lower()
