"""`rna-view`: what it serves, what it exports, what it refuses."""

import errno
import hashlib
import json
import os
import shutil
import subprocess
import sys
import urllib.error
import urllib.request
from html import unescape
from pathlib import Path

import numpy as np
import pytest

from rna_render import write_exr
from rna_sdk.errors import PackageError, SceneError, ViewError
from rna_sdk.files.atomic_file import remove_leftovers, temporary_path
from rna_view.page_server import PageServer
from rna_view.rna_view_command import main
from rna_view.scene_page import scene_site
from rna_view.site_export import MARKER, export_site
from rna_view.site_files import VIEWER_FILES, Site, viewer_file
from rna_view.site_source import gallery_for, site_for
from tests.package.builders import make_tier, make_tiny_package
from tests.package.carriers import make_carrier
from tests.web.glass_files import write_ball
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


def name_of(path: Path) -> str:
    """A file's name in a page: of what it holds, whatever others call it."""
    return hashlib.sha256(path.read_bytes()).hexdigest()[:32] + path.suffix


@pytest.fixture
def package(tmp_path):
    return make_tiny_package(tmp_path / "a b.rna")


def test_server_gives_the_page_and_its_files_alone(package):
    with served(site_for(package)) as server:
        status, headers, page = fetch(server.url)
        assert status == 200 and f'src="{name_of(package)}"'.encode() in page
        assert "script-src 'self'" in headers["Content-Security-Policy"]
        assert headers["Cache-Control"] == "no-cache"
        _, headers, content = fetch(server.url + name_of(package))
        assert content == package.read_bytes() and "immutable" in headers["Cache-Control"]
        for name in ("../cli.py", "site/viewer.js", "etc/passwd", "%2e%2e/x"):
            assert fetch(server.url + name)[0] == 404
        assert fetch(server.url, Host="evil.example")[0] == 403


def test_the_package_of_a_carrier_is_served(package, tmp_path):
    carrier = make_carrier(package, tmp_path / "carrier.glb")
    with served(site_for(carrier)) as server:
        assert f'src="{name_of(package)}"'.encode() in fetch(server.url)[2]
        assert fetch(server.url + name_of(package))[2] == package.read_bytes()
    with pytest.raises(ViewError, match=r"plain\.glb: a model, not a package; rna-make"):
        (tmp_path / "plain.glb").write_bytes(b"glTF")
        site_for(tmp_path / "plain.glb")


@pytest.mark.parametrize(
    ("requested", "first", "end"),
    [("bytes=0-9", 0, 10), ("bytes=5-", 5, None), ("bytes=-7", -7, None), ("bytes=3-3", 3, 4)],
)
def test_byte_ranges(package, requested, first, end):
    data = package.read_bytes()
    with served(site_for(package)) as server:
        status, headers, actual = fetch(server.url + name_of(package), Range=requested)
        assert status == 206 and actual == data[first:end]
        start = first % len(data)
        expected = f"bytes {start}-{start + len(actual) - 1}/{len(data)}"
        assert headers["Content-Range"] == expected
        assert fetch(server.url + name_of(package), Range=f"bytes={len(data)}-")[0] == 416
        assert fetch(server.url + name_of(package), Range="bytes=0-1,4-5")[0] == 200


@pytest.mark.parametrize("name", ["viewer.js", "index.html", "package"])
def test_files_that_are_the_same_are_not_sent_again(package, name):
    with served(site_for(package)) as server:
        url = server.url + (name_of(package) if name == "package" else name)
        _, headers, content = fetch(url)
        tag = headers["ETag"]
        for known in (tag, f"W/{tag}", f'"other", {tag}'):
            status, again, body = fetch(url, **{"If-None-Match": known})
            assert (status, again["ETag"], body) == (304, tag, b"")
            assert again["Cache-Control"] == headers["Cache-Control"]
        assert fetch(url, **{"If-None-Match": '"other"'})[2] == content
        # A part of what is no longer the same file is of no use.
        part = {"Range": "bytes=0-9"}
        assert fetch(url, **part, **{"If-Range": tag})[2] == content[:10]
        assert fetch(url, **part, **{"If-Range": '"other"'})[2] == content


def test_a_file_that_changed_has_another_tag(package):
    tags = set()
    for title in ("one", "two"):
        site = site_for(package)
        site.labels[name_of(package)] = title
        with served(site) as server:
            tags.add(fetch(server.url)[1]["ETag"])
    assert len(tags) == 2


def test_export_writes_a_page_for_any_server(package, tmp_path, capsys):
    folder = tmp_path / "site"
    for _ in range(2):  # an earlier export is written over
        assert main([str(package), "--export", str(folder)]) == 0
    assert {path.name for path in folder.iterdir()} == {*VIEWER_FILES, MARKER, name_of(package)}
    assert (folder / name_of(package)).read_bytes() == package.read_bytes()
    page = (folder / "index.html").read_text()
    assert f'<rna-viewer src="{name_of(package)}"' in page
    assert 'http-equiv="Content-Security-Policy"' in page and "script-src 'self'" in page
    assert "HTTPS" in capsys.readouterr().out


def test_export_leaves_other_folders_alone(package, tmp_path, capsys):
    for name in ("mine.txt", "viewer.js"):  # the second is no proof of an earlier export
        folder = tmp_path / f"with {name}"
        folder.mkdir()
        (folder / name).write_text("keep")
        assert main([str(package), "--export", str(folder)]) == 1
        assert "other files" in capsys.readouterr().err
        assert [path.name for path in folder.iterdir()] == [name]


def test_export_removes_what_an_earlier_one_wrote_alone(package, tmp_path):
    folder, other = tmp_path / "site", make_tiny_package(tmp_path / "other.rna", make_tier("hq"))
    main([str(package), "--export", str(folder)])
    (folder / "mine.txt").write_text("keep")
    record = json.loads((folder / MARKER).read_text())
    record["files"] += ["mine.txt", "../other.rna", "viewer.js"]  # by whoever edits it
    (folder / MARKER).write_text(json.dumps(record))
    main([str(other), "--export", str(folder)])
    expected = {*VIEWER_FILES, MARKER, name_of(other), "mine.txt"}
    assert {path.name for path in folder.iterdir()} == expected and other.is_file()


def test_scene_becomes_camera_and_lights():
    toy = EXAMPLES / "quickstart" / "toy.rna"
    site = scene_site(EXAMPLES / "quickstart" / "scene.yaml")
    assert site.attributes == {"scene": "scene.json"} and not site.notes
    assert site.contents[name_of(toy)] == toy and site.labels == {name_of(toy): "toy.rna"}
    notes = scene_site(EXAMPLES / "scene" / "scene.yaml").notes
    assert any("object" in note for note in notes)


def test_a_page_says_that_its_camera_has_no_lens(tmp_path):
    text = (EXAMPLES / "quickstart" / "scene.yaml").read_text()
    text = text.replace("toy.rna", str(EXAMPLES / "quickstart" / "toy.rna"))
    (tmp_path / "scene.yaml").write_text(text.replace("camera:\n", "camera:\n  aperture: 0.1\n"))
    (note,) = [one for one in scene_site(tmp_path / "scene.yaml").notes if "folder" not in one]
    assert "a pinhole in place of the camera's lens" in note


SCENE = """
assets: [{path: "a b.rna"}]
camera: {position: [1, 1, 1], look_at: [0, 0, 0]}
lights: [{type: environment, path: "IMAGE"}]
resolution: [8, 8]
samples: 1
"""
HDR = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + bytes([128, 128, 128, 129] * 2)


def scene_with(folder: Path, image: str) -> Path:
    (folder / "scene.yaml").write_text(SCENE.replace("IMAGE", image))
    return folder / "scene.yaml"


def test_scene_publishes_images_alone(package, tmp_path, capsys):
    """A scene file that names any other file: nothing of it is copied or served."""
    (tmp_path / "private.txt").write_text("secret")
    (tmp_path / "viewer.js").write_text("document.title = 'not ours'")
    (tmp_path / "half.hdr").write_bytes(HDR[:-3])
    for name in ("private.txt", "viewer.js", "half.hdr", "/etc/passwd", "a b.rna"):
        scene = scene_with(tmp_path, name)
        assert main([str(scene), "--export", str(tmp_path / "site")]) == 1
        error = capsys.readouterr().err
        assert "scene.yaml:4: lights[0].path" in error and error.count("\n") == 1
        assert not (tmp_path / "site").exists()


@pytest.mark.parametrize("name", [*VIEWER_FILES, "scene.json", "Sky #2 ?.hdr"])
def test_names_in_a_page_are_ours(package, tmp_path, name):
    """An image by the name of a viewer's file does not take its place; nor is a name an address."""
    (tmp_path / name).write_bytes(HDR)
    site = scene_site(scene_with(tmp_path, name))
    image = hashlib.sha256(HDR).hexdigest()[:32] + ".hdr"
    assert set(site.contents) == {image, "scene.json", name_of(package)}
    assert json.loads(site.contents["scene.json"])["environment"]["image"] == image
    assert site.labels[image] == name
    folder = tmp_path / "site"
    export_site(site, folder)
    assert (folder / "viewer.js").read_bytes() == viewer_file("viewer.js")
    with served(site) as server:
        assert fetch(f"{server.url}viewer.js")[2] == viewer_file("viewer.js")


def test_what_a_killed_export_left_goes_with_the_next(package, tmp_path):
    """Whether it was killed before it had marked the folder, or later."""
    folder = tmp_path / "site"
    folder.mkdir()
    for _ in range(2):
        leftover = temporary_path(folder / "index.html")
        leftover.write_bytes(b"half")
        remove_leftovers.cache_clear()  # another process
        export_site(site_for(package), folder)
        assert (folder / MARKER).is_file() and not leftover.exists()
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / ".index.html.part").touch()  # of somebody else
    with pytest.raises(ViewError, match="holds other files"):
        export_site(site_for(package), tmp_path / "other")


def test_the_glass_beside_a_package_is_shown(package, tmp_path):
    glass = write_ball(tmp_path / "a b.glass.glb")
    site = site_for(package)
    assert site.attributes == {"src": name_of(package), "glass": name_of(glass)} and not site.notes
    with served(site) as server:
        _, headers, content = fetch(server.url + name_of(glass))
        assert content == glass.read_bytes() and headers["Content-Type"] == "model/gltf-binary"
    scene = tmp_path / "glass.yaml"
    text = SCENE.replace('{type: environment, path: "IMAGE"}', "").replace("lights: []\n", "")
    scene.write_text(text + 'objects: [{path: "a b.glass.glb"}]\n')
    assert site_for(scene).attributes == {"glass": name_of(glass), "scene": "scene.json"}
    moved = "{path: a b.glass.glb, transform: {translation: [0, 1, 0]}}"
    scene.write_text(text + f"objects: [{moved}]\n")
    site = site_for(scene)
    assert "glass" not in site.attributes and "a b.glass.glb" in site.notes[0]
    glass.write_text("private")
    with pytest.raises(ViewError, match="expected the glass"):
        site_for(package)


def test_what_lies_outside_the_scenes_folder_is_named(package, tmp_path, capsys):
    inner = tmp_path / "inner"
    inner.mkdir()
    (tmp_path / "sky.hdr").write_bytes(HDR)
    (inner / "a b.rna").symlink_to(package)
    scene = scene_with(inner, "../sky.hdr")
    assert main([str(scene), "--export", str(tmp_path / "site")]) == 0
    notes = capsys.readouterr().err
    assert f"outside the scene's folder: {tmp_path / 'sky.hdr'}" in notes
    assert f"outside the scene's folder: {package}" in notes


def test_what_is_no_package_or_image_is_refused(package, tmp_path):
    (tmp_path / "text.rna").write_text("x")
    (tmp_path / "text.hdr").write_text("x")
    with pytest.raises(PackageError, match=r"text\.rna"):
        site_for(tmp_path / "text.rna")
    for image in (tmp_path / "text.hdr", tmp_path / "none.hdr", tmp_path):
        with pytest.raises((ViewError, SceneError), match=image.name):
            site_for(package, environment=image)


def test_an_environment_that_visitors_cannot_read_is_refused(package, tmp_path, capsys):
    write_exr(tmp_path / "sky.exr", dict.fromkeys("RGB", np.ones((8, 16), np.float32)), {})
    for name, size in (("whole", None), ("cut", 300)):
        (tmp_path / f"{name}.exr").write_bytes((tmp_path / "sky.exr").read_bytes()[:size])
    export = ["--export", str(tmp_path / "site")]
    assert main([str(package), "--env", str(tmp_path / "cut.exr"), *export]) == 1
    said = capsys.readouterr().err
    assert "cut.exr: cannot read the image" in said and not (tmp_path / "site").exists()
    assert main([str(package), "--env", str(tmp_path / "whole.exr"), *export]) == 0


@pytest.mark.filterwarnings("default::UserWarning")
def test_an_infinite_sun_is_cut_and_told(package, tmp_path, capsys):
    sun = np.ones((8, 16), np.float16)
    sun[2, 3] = np.inf
    write_exr(tmp_path / "sun.exr", dict.fromkeys("RGB", sun), {})
    export = ["--export", str(tmp_path / "site")]
    assert main([str(package), "--env", str(tmp_path / "sun.exr"), *export]) == 0
    assert "infinite radiance in 1 texels is cut to 65,504" in capsys.readouterr().err


@pytest.mark.parametrize("earlier", [False, True])
def test_an_export_on_a_full_disk_leaves_nothing_new(
    package, earlier, tmp_path, capsys, monkeypatch
):
    folder, other = tmp_path / "site", make_tiny_package(tmp_path / "other.rna", make_tier("hq"))
    if earlier:
        assert main([str(other), "--export", str(folder)]) == 0
    before = {path.name for path in folder.iterdir()} if earlier else None

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(shutil, "copyfile", full)
    assert main([str(package), "--export", str(folder)]) == 1
    assert "No space left on device" in capsys.readouterr().err
    assert ({path.name for path in folder.iterdir()} if folder.exists() else None) == before


def test_attributes_are_escaped(package):
    page = Site({}, {"src": 'a"b&c.rna'}).index().decode()
    requested = page.split('<rna-viewer src="')[1].split('"')[0]
    assert unescape(requested) == 'a"b&c.rna'


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
        "import rna_view.rna_view_command, sys; renderer = ('rna_render.', 'rna_trace', 'torch'); "
        "found = {name for name in sys.modules if name.startswith(renderer)}; "
        "sys.exit(bool(found))"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_several_packages_are_a_gallery(package, tmp_path, capsys):
    other = make_tiny_package(tmp_path / "c.rna", make_tier("hq"))
    assert main([str(package), str(other), "--export", str(tmp_path / "site")]) == 0
    page = (tmp_path / "site" / "index.html").read_text()
    for path in (package, other):
        assert f'src="{name_of(path)}"' in page and f"<figcaption>{path.stem}<" in page
        assert (tmp_path / "site" / name_of(path)).read_bytes() == path.read_bytes()
    names = {path.name for path in (tmp_path / "site").iterdir()}
    assert {"gallery.js", "gallery.css", "rna-viewer.js"} <= names and "viewer.js" not in names
    with served(gallery_for([package, other])) as server:
        assert fetch(server.url)[2].decode().count("<rna-viewer") == 2
        assert fetch(server.url + "gallery.js")[0] == 200
    scene = tmp_path / "scene.yaml"
    scene.write_text(f"asset: {package.name}\n")
    assert main([str(package), str(scene), "--export", str(tmp_path / "two")]) == 1
    assert "expected only packages" in capsys.readouterr().err
