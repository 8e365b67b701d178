"""The servers of pages: whom they answer, how many at a time, what they make of odd requests."""

import socket
import threading
import time
from contextlib import ExitStack

import pytest

from rna_render.preview.server import PreviewServer
from rna_sdk.commands import local_server
from rna_sdk.commands.local_server import MAX_CONNECTIONS, LocalHandler, LocalServer
from rna_view.page_server import PageServer
from rna_view.site_files import Site
from tests.answering import answering

SERVERS = {"rna-view": lambda: PageServer(Site()), "rna-run": lambda: PreviewServer(0)}


@pytest.fixture(params=SERVERS)
def server(request):
    with answering(SERVERS[request.param]()) as server:
        yield server


def send(server: LocalServer, request: str) -> bytes:
    """All that the server says to these bytes before it hangs up."""
    with socket.create_connection(server.server_address, timeout=10) as connection:
        connection.sendall(request.replace("PORT", str(server.server_port)).encode())
        actual = b""
        while more := connection.recv(65536):
            actual += more
        return actual


END = " HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\nConnection: close\r\n\r\n"


@pytest.mark.parametrize(
    "target",
    ["http://[/", "http://[::1/x", "//[", "/%", "/%ff%00", "/\x00", "*", "?", "a:b", "/" * 999],
)
def test_odd_addresses_get_an_answer(server, target, capsys):
    assert send(server, f"GET {target}{END}").startswith(b"HTTP/1.1 ")
    assert capsys.readouterr().err == ""


def test_a_whole_address_gives_its_path(server):
    assert send(server, f"GET http://127.0.0.1:PORT/{END}").startswith(b"HTTP/1.1 200")
    assert send(server, f"GET http://127.0.0.1:PORT{END}").startswith(b"HTTP/1.1 200")


@pytest.mark.parametrize("method", ["PUT", "DELETE", "OPTIONS", "TRACE", "CONNECT", "X"])
def test_other_methods_are_refused(server, method):
    assert send(server, f"{method} /{END}").startswith(b"HTTP/1.1 501")


@pytest.mark.parametrize(
    "hosts",
    ["", "Host: example.org:PORT\r\n", "Host: 127.0.0.1\r\n", "Host: 127.0.0.1:PORT\r\n" * 2],
)
def test_other_names_of_this_computer_are_refused(server, hosts):
    request = f"GET / HTTP/1.1\r\n{hosts}Connection: close\r\n\r\n"
    assert send(server, request).startswith(b"HTTP/1.1 403")


def test_one_connection_too_many_is_refused_and_a_closed_one_makes_room(server, monkeypatch):
    monkeypatch.setattr(local_server, "PATIENCE_S", 60.0)
    before = threading.active_count()
    with ExitStack() as open_ones:
        for _ in range(MAX_CONNECTIONS):
            one = socket.create_connection(server.server_address, timeout=10)
            open_ones.enter_context(one)
        for _ in range(8):
            assert send(server, "").startswith(b"HTTP/1.1 503")
        assert threading.active_count() <= before + MAX_CONNECTIONS
        one.close()
        while not (answer := send(server, f"GET /{END}")).startswith(b"HTTP/1.1 200"):
            assert answer.startswith(b"HTTP/1.1 503")


@pytest.mark.parametrize(
    "half", ["", "GET / HT", "POST /change HTTP/1.1\r\nContent-Length: 9\r\n\r\n"]
)
def test_half_requests_lock_nobody_out(server, half, monkeypatch):
    monkeypatch.setattr(local_server, "PATIENCE_S", 0.5)
    with ExitStack() as open_ones:
        for _ in range(MAX_CONNECTIONS):
            one = socket.create_connection(server.server_address, timeout=10)
            open_ones.enter_context(one)
            one.sendall(half.encode())
        time.sleep(0.6)
        for _ in range(8):
            assert send(server, f"GET /{END}").startswith(b"HTTP/1.1 200")


@pytest.mark.parametrize(
    ("host", "answered"),
    [
        ("192.168.1.5:{port}", True),
        ("[fe80::1]:{port}", True),
        ("workstation:{port}", True),
        ("workstation.local:{port}", True),
        ("example.org:{port}", False),
        ("example.org", False),
        ("192.168.1.5.example.org:{port}", False),
        ("192.168.1.5:1", False),
        (None, False),
    ],
)
def test_an_open_server_answers_to_addresses_and_local_names(host, answered):
    with LocalServer("0.0.0.0", 0, LocalHandler) as server:
        name = host and host.format(port=server.server_port)
        assert server.answers_to(name) is answered


@pytest.mark.parametrize(("host", "port"), [("127.0.0.1", 70000), ("a..b", 0), ("::x::", 0)])
def test_an_address_that_there_is_not_is_one_error(host, port):
    with pytest.raises(OSError):
        LocalServer(host, port, LocalHandler)
