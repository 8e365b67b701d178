"""What an address of a cluster needs, found out before Ray is imported: Ray reads it then."""

from __future__ import annotations

import os
import socket
from pathlib import Path

from rna_sdk.errors import WorkError

_SECONDS = 10.0
_ASKED = {  # of a head, and of the server of its ray:// address
    "": "/ray.rpc.NodeInfoGcsService/CheckAlive",
    "ray": "/ray.rpc.RayletDriver/ClusterInfo",
}


def prepare(address: str) -> None:
    """See that somebody listens, and show the cluster's token if it asks for one.

    Ray itself would try for minutes. Raises WorkError.
    """
    scheme, _, rest = address.rpartition("://")
    host, colon, port = rest.rpartition(":")
    if not colon or not (port.isascii() and port.isdigit()):
        return  # such as `auto`
    try:
        socket.create_connection((host, int(port)), timeout=_SECONDS).close()
    except (OSError, OverflowError, ValueError) as error:  # of ports and names that cannot be
        raise WorkError(f"--cluster {address}: no cluster answers: {error}") from error
    if "RAY_AUTH_MODE" not in os.environ and scheme in _ASKED and _asks(rest, _ASKED[scheme]):
        if not _has_token():
            raise WorkError(
                f"--cluster {address}: requires a token: copy ~/.ray/auth_token from its head node "
                "to this machine"
            )
        os.environ["RAY_AUTH_MODE"] = "token"


def _asks(target: str, method: str) -> bool:
    """Whether a server wants a token. Without this module's answer Ray takes it that none does."""
    try:
        import grpc
    except ModuleNotFoundError:
        return False
    with grpc.insecure_channel(target) as channel:
        try:
            channel.unary_unary(method)(b"", timeout=_SECONDS)
        except grpc.RpcError as error:
            return bool(error.code() == grpc.StatusCode.UNAUTHENTICATED)
    return False


def _has_token() -> bool:
    named = any(os.environ.get(name) for name in ("RAY_AUTH_TOKEN", "RAY_AUTH_TOKEN_PATH"))
    return named or (Path.home() / ".ray" / "auth_token").is_file()
