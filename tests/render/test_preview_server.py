"""The preview's server: what it answers, and whom it does not."""

import http.client
import io
import json

import numpy as np
import pytest
from PIL import Image

from rna_render.paths.world_in_time import load_world
from rna_render.preview.lighting import lighting_choices
from rna_render.preview.server import MAX_BODY, PreviewServer
from rna_render.preview.session import Session
from rna_render.scene.scene_file import read_scene
from rna_sdk.errors import PreviewError
from tests.answering import answering
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package
from tests.render.test_preview_session import SCENE

JSON = {"Content-Type": "application/json"}


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    folder = tmp_path_factory.mktemp("preview")
    write_lambert_package(folder / "ball.rna", sphere(4))
    (folder / "scene.yaml").write_text(SCENE)
    scene_file = read_scene(folder / "scene.yaml")
    session = Session(scene_file, load_world(scene_file), lighting_choices(scene_file.path))
    with answering(PreviewServer(0, session)) as server:
        session.start()
        yield server
        session.stop()


def ask(server, method, path, body=None, headers=None):
    """Status, headers and body."""
    connection = http.client.HTTPConnection(*server.server_address, timeout=30)
    try:
        connection.request(method, path, body, headers or {})
        answer = connection.getresponse()
        return answer.status, answer.headers, answer.read()
    finally:
        connection.close()


def change(server, text: str, **headers: str):
    status, _, body = ask(server, "POST", "/change", text, JSON | headers)
    return status, json.loads(body)


def test_the_page_brings_all_that_it_needs(server):
    status, headers, body = ask(server, "GET", "/")
    assert status == 200 and headers["Content-Type"] == "text/html; charset=utf-8"
    assert "frame-ancestors 'none'" in headers["Content-Security-Policy"]
    assert b"<canvas" in body
    for path in ("/preview.js", "/preview.css"):
        status, _, more = ask(server, "GET", path)
        assert status == 200 and path[1:].encode() in body
        body += more
    # Nothing from the network: its only address is the name of SVG.
    assert body.count(b"http") == body.count(b"http://www.w3.org/2000/svg")


def test_pictures_follow_one_another(server):
    _, state = change(server, '{"orbit_deg": [5, 0]}')
    after, samples = 0, -1
    while samples < 4:
        status, headers, body = ask(server, "GET", f"/picture?after={after}")
        if status == 204:  # kernels are compiled for long on a busy machine
            continue
        label = json.loads(headers["Rna-Label"])
        assert status == 200 and headers["Content-Type"] == "image/jpeg"
        assert label["serial"] > after and label["revision"] == state["revision"]
        assert label["samples"] >= samples and body.startswith(b"\xff\xd8")
        after, samples = label["serial"], label["samples"]


def test_a_long_poll_ends(server, monkeypatch):
    monkeypatch.setattr("rna_render.preview.server.LONG_POLL_S", 0.1)
    status, _, body = ask(server, "GET", "/picture?after=999999999")
    assert (status, body) == (204, b"")


def test_a_change_is_answered_with_the_new_state(server):
    status, state = change(server, '{"light_rotation_deg": 30, "exposure": 1.5}')
    assert status == 200
    assert (state["light_rotation_deg"], state["exposure"]) == (30, 1.5)
    assert json.loads(ask(server, "GET", "/state")[2]) == state
    assert state["scene"] == "scene.yaml" and state["resolution"] == [32, 24]


def test_the_newest_picture_as_a_png_in_another_view_transform(server):
    def png(view: str) -> np.ndarray:
        assert change(server, json.dumps({"view": view, "exposure": 3}))[1]["view"] == view
        while ask(server, "GET", "/picture?after=0")[0] != 200:
            pass
        while True:
            status, headers, body = ask(server, "GET", "/picture.png")
            assert (status, headers["Content-Type"]) == (200, "image/png")
            with Image.open(io.BytesIO(body)) as image:
                if image.size == (32, 24):  # the first look has fewer pixels
                    return np.asarray(image, int)

    clamped, filmic = png("srgb"), png("filmic")
    assert (clamped == 255).any() and filmic[clamped == 255].min() < 250
    assert ask(server, "GET", "/picture.png", None, {"Origin": "http://example.org"})[0] == 403


def test_it_listens_on_this_computer_alone(server):
    assert server.server_address[0] == "127.0.0.1"


HOSTS = ["example.org", "127.0.0.1", "127.0.0.1:1", "localhost", "", "127.0.0.1.example.org:PORT"]


@pytest.mark.parametrize("host", HOSTS)
@pytest.mark.parametrize(("method", "path"), [("GET", "/"), ("GET", "/state"), ("POST", "/change")])
def test_other_names_for_this_computer_are_refused(server, host, method, path):
    host = host.replace("PORT", str(server.server_port))
    status, _, body = ask(server, method, path, "{}", JSON | {"Host": host})
    assert status == 403 and b"scene.yaml" not in body


def test_localhost_is_its_other_name(server):
    host = f"localhost:{server.server_port}"
    assert ask(server, "GET", "/state", None, {"Host": host})[0] == 200
    assert change(server, "{}", Host=host, Origin=f"http://{host}")[0] == 200


@pytest.mark.parametrize(
    "headers",
    [
        {"Origin": "http://example.org"},
        {"Origin": "null"},
        {"Origin": "http://127.0.0.1:1"},
        {"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "no-cors"},
        {"Sec-Fetch-Site": "same-site", "Sec-Fetch-Mode": "cors"},
    ],
)
def test_other_pages_are_refused(server, headers):
    assert change(server, '{"orbit_deg": [5, 0]}', **headers)[0] == 403
    status, answered, _ = ask(server, "GET", "/picture", None, headers)
    assert status == 403 and "Access-Control-Allow-Origin" not in answered


def test_a_link_on_another_page_may_lead_here(server):
    headers = {"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "navigate"}
    assert ask(server, "GET", "/", None, headers)[0] == 200


@pytest.mark.parametrize(
    ("method", "path", "status"),
    [
        ("GET", "/nothing", 404),
        ("GET", "/index.html", 404),
        ("GET", "/../../etc/passwd", 404),
        ("GET", "/change", 404),
        ("POST", "/", 404),
        ("OPTIONS", "/change", 501),
        ("GET", "/picture?after=-1", 400),
        ("GET", "/picture?after=x", 400),
        ("GET", "/picture?after=1e3", 400),
    ],
)
def test_other_requests(server, method, path, status):
    assert ask(server, method, path)[0] == status


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("", "JSON"),
        ("{", "JSON"),
        ("[]", ""),
        ('{"roll": 1}', "roll"),
        ('{"orbit_deg": [1]}', "orbit_deg"),
        ('{"orbit_deg": [1, NaN]}', ""),
        ('{"orbit_deg": [1, 1e9]}', "orbit_deg"),
        ('{"dolly": 0}', "dolly"),
        ('{"dolly": "1"}', "dolly"),
        ('{"exposure": true}', "exposure"),
        ('{"view": "agx"}', "view"),
        ('{"lighting": "../sky.hdr"}', "lighting"),
    ],
)
def test_a_bad_change_is_refused_with_its_place(server, text, place):
    before = json.loads(ask(server, "GET", "/state")[2])
    status, answer = change(server, text)
    assert status == 400 and place in answer["error"] and "\n" not in answer["error"]
    assert json.loads(ask(server, "GET", "/state")[2]) == before


def test_a_body_of_another_type_or_size_is_refused(server):
    assert ask(server, "POST", "/change", "{}", {"Content-Type": "text/plain"})[0] == 415
    assert ask(server, "POST", "/change", "{}", JSON | {"Content-Length": "-1"})[0] == 411
    assert change(server, " " * (MAX_BODY + 1))[0] == 413


def test_nothing_is_there_before_the_scene_is_loaded():
    with answering(PreviewServer(0)) as server:
        assert ask(server, "GET", "/state")[0] == 503


def test_a_port_that_is_taken_is_one_clear_error(server):
    with pytest.raises(PreviewError, match=f"cannot listen on 127.0.0.1:{server.server_port}: "):
        PreviewServer(server.server_port)
