"""`rna-view`: what it serves, what it exports, what it refuses."""

from __future__ import annotations

import subprocess
import sys
import urllib.error
import urllib.request
from html import unescape
from pathlib import Path

import pytest

from rna_view.cli import main
from rna_view.errors import ViewError
from rna_view.page_server import PageServer
from rna_view.scene_page import scene_site
from rna_view.site_files import VIEWER_FILES, Site, site_for
from tests.package.builders import make_tiny_package
from tests.web.pages import served

EXAMPLES = Path(__file__).parents[2] / "examples"


def fetch(url: str, **headers: str) -> tuple[int, dict[str, str], bytes]:
    request = urllib.request.Request(url, headers=headers)
    try:
        with urllib.request.urlopen(request, timeout=10) as answer:
            return answer.status, dict(answer.headers), answer.read()
    except urllib.error.HTTPError as error:
        with error:
            return error.code, dict(error.headers), error.read()


@pytest.fixture
def package(tmp_path) -> Path:
    return make_tiny_package(tmp_path / "a b.rna")


def test_server_gives_the_page_and_its_files_alone(package):
    with served(site_for(package)) as server:
        status, headers, page = fetch(server.url)
        assert status == 200 and b'data-query="asset=a%20b.rna"' in page
        assert "script-src 'self'" in headers["Content-Security-Policy"]
        assert fetch(f"{server.url}a%20b.rna")[2] == package.read_bytes()
        for name in ("../cli.py", "site/viewer.js", "etc/passwd", "%2e%2e/x"):
            assert fetch(server.url + name)[0] == 404
        assert fetch(server.url, Host="evil.example")[0] == 403


@pytest.mark.parametrize(
    ("asked", "first", "end"),
    [("bytes=0-9", 0, 10), ("bytes=5-", 5, None), ("bytes=-7", -7, None), ("bytes=3-3", 3, 4)],
)
def test_byte_ranges(package, asked, first, end):
    data = package.read_bytes()
    with served(site_for(package)) as server:
        status, headers, found = fetch(f"{server.url}a%20b.rna", Range=asked)
        assert status == 206 and found == data[first:end]
        start = first % len(data)
        expected = f"bytes {start}-{start + len(found) - 1}/{len(data)}"
        assert headers["Content-Range"] == expected
        assert fetch(f"{server.url}a%20b.rna", Range=f"bytes={len(data)}-")[0] == 416
        assert fetch(f"{server.url}a%20b.rna", Range="bytes=0-1,4-5")[0] == 200


def test_export_writes_a_page_for_any_server(package, tmp_path, capsys):
    folder = tmp_path / "site"
    for _ in range(2):  # an earlier export is written over
        assert main([str(package), "--export", str(folder)]) == 0
    assert {path.name for path in folder.iterdir()} == {*VIEWER_FILES, "a b.rna"}
    assert (folder / "a b.rna").read_bytes() == package.read_bytes()
    assert b'data-query="asset=a%20b.rna"' in (folder / "index.html").read_bytes()
    assert "HTTPS" in capsys.readouterr().out
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "mine.txt").write_text("keep")
    assert main([str(package), "--export", str(tmp_path / "full")]) == 1
    assert "other files" in capsys.readouterr().err
    assert [path.name for path in (tmp_path / "full").iterdir()] == ["mine.txt"]


def test_scene_becomes_camera_and_lights():
    site = scene_site(EXAMPLES / "quickstart" / "scene.yaml")
    assert site.query == {"scene": "scene.json"} and not site.notes
    assert site.contents["toy.rna"] == EXAMPLES / "quickstart" / "toy.rna"
    notes = scene_site(EXAMPLES / "scene" / "scene.yaml").notes
    assert any("objects" in note for note in notes)


def test_query_is_escaped(package):
    page = Site({}, {"asset": 'a"b&c.rna'}).index().decode()
    asked = page.split('data-query="')[1].split('"')[0]
    assert unescape(asked) == "asset=a%22b%26c.rna"


def test_what_is_no_asset_is_refused(tmp_path):
    (tmp_path / "x.txt").write_text("x")
    for path in (tmp_path / "x.txt", tmp_path / "none.rna"):
        with pytest.raises(ViewError, match=path.name):
            site_for(path)


def test_port_that_is_taken(package):
    with PageServer(site_for(package)) as server, pytest.raises(ViewError, match="cannot listen"):
        PageServer(site_for(package), port=server.server_port)


def test_viewer_needs_no_renderer():
    code = (
        "import rna_view.cli, sys; sys.exit('rna_render' in sys.modules or 'torch' in sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
