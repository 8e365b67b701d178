"""Servers that answer while a test asks."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from socketserver import BaseServer
from typing import TypeVar

Server = TypeVar("Server", bound=BaseServer)

POLL_S = 0.02
"""How long a server may take to see that it is to stop."""


@contextmanager
def answering(server: Server) -> Iterator[Server]:
    """The server, in a thread of its own until the block ends."""
    with server:
        thread = threading.Thread(target=server.serve_forever, args=[POLL_S])
        thread.start()
        try:
            yield server
        finally:
            server.shutdown()
            thread.join()
