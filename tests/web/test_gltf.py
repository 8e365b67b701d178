"""`<rna-viewer src="x.glb">`: the package inside a binary glTF."""

import io
import json
import shutil
from base64 import b64decode
from pathlib import Path
from typing import Any, ClassVar

import pytest

from rna_view.site_files import ELEMENT, viewer_file
from tests.conftest import REPOSITORY
from tests.package.carriers import HARMLESS, changed, make_carrier
from tests.web.element_pages import SMALL, finished, line, loads, show
from tests.web.gltf_files import GltfFile, asset_node, write_gltf
from tests.web.in_node import SOURCES, in_node
from tests.web.pages import TIMEOUT, Ranges, served_folder
from tests.web.three.pages import TOY

KIT = REPOSITORY / "spec" / "conformance" / "packages"
TINY, STRANDS = KIT / "surface-tiny.rna", KIT / "fiber-float16.rna"
FOUND = """
import {{ readFileSync }} from "node:fs";
import {{ packageIn }} from "{module}";
import {{ BlobSource }} from "{source}";
const said = [];
for (const [name, path] of Object.entries({files})) {{
  try {{
    const found = await packageIn(new BlobSource(new Blob([readFileSync(path)]), name));
    said.push([found.name, Buffer.from(await found.read(0, found.size)).toString("base64")]);
  }} catch (error) {{
    said.push(error.message);
  }}
}}
console.log(JSON.stringify(said));
"""


def found(*paths: Path) -> list[tuple[str, bytes] | str]:
    """What comes of each file in node: its name and the package's bytes, or a line."""
    program = FOUND.format(
        module=(SOURCES / "package" / "gltf_package.js").as_uri(),
        source=(SOURCES / "package" / "source.js").as_uri(),
        files=json.dumps({path.name: str(path) for path in paths}),
    )
    return [
        one if isinstance(one, str) else (one[0], b64decode(one[1])) for one in in_node(program)
    ]


def test_the_package_of_a_file(tmp_path):
    """Also where several nodes show it, bytes follow it, or the file is odd."""
    file = GltfFile()
    view = file.view(TINY.read_bytes())
    file.view(b"something else")
    file.document["nodes"] = [asset_node(view), {"mesh": 0}, asset_node(view, scale=[-1, 1, 1])]
    write_gltf(tmp_path / "one.glb", [TINY])
    (tmp_path / "twice.glb").write_bytes(file.to_bytes())
    plain = GltfFile()
    plain.document |= {"nodes": [{"mesh": 0}], "extensionsUsed": []}
    (tmp_path / "plain.glb").write_bytes(plain.to_bytes())
    odd = list(HARMLESS)
    for name in odd:
        changed(make_carrier(TINY, tmp_path / "good.glb"), tmp_path / name, HARMLESS[name])
    names = ("one.glb", "twice.glb", *odd, "plain.glb")
    expected = [*[TINY.read_bytes()] * (2 + len(odd)), plain.to_bytes()]
    assert found(*(tmp_path / name for name in names)) == list(zip(names, expected, strict=True))


ASKED = """
import {{ readFileSync }} from "node:fs";
import {{ packageIn }} from "{module}";
import {{ UrlSource }} from "{source}";
globalThis.location = {{ href: "http://here/" }};
const file = readFileSync("{path}"), ranges = [];
globalThis.fetch = async (url, {{ headers }}) => {{
  const [start, end] = headers.Range.slice(6).split("-").map(Number);
  const part = file.subarray(start, end + 1);
  ranges.push([start, end]);
  const told = {{ "Content-Range": `bytes ${{start}}-${{end}}/${{file.length}}` }};
  return new Response(part, {{ status: 206, headers: told }});
}};
const found = await packageIn(await UrlSource.open("http://there/a.glb")), {{ size }} = found;
const places = [[0, 512], [size - 22, size], [size - 9000, size - 22]];
places.push([512, 20000], [70000, 90000]);
const read = [];
for (const [start, end] of places) read.push(Buffer.from(await found.read(start, end)));
console.log(JSON.stringify({{ ranges, read: Buffer.concat(read).toString("base64") }}));
"""


@pytest.mark.parametrize("before", [0, 2**20])
def test_the_ends_of_a_package_come_at_once(tmp_path, before):
    """Where it begins with the file, what came with the JSON is not asked for again."""
    file, package = GltfFile(), TOY.read_bytes()
    file.view(bytes(before))
    file.document["nodes"] = [asset_node(file.view(package))]
    file.view(bytes(2**20))
    data = file.to_bytes()
    (tmp_path / "a.glb").write_bytes(data)
    program = ASKED.format(
        module=(SOURCES / "package" / "gltf_package.js").as_uri(),
        source=(SOURCES / "package" / "source.js").as_uri(),
        path=tmp_path / "a.glb",
    )
    actual, start, size = in_node(program), data.index(package), len(package)
    heads = [[0, 65535], *([[start, start + 65535]] if before else [])]
    ends = [[start + size - 16384, start + size - 1], [start + 70000, start + 89999]]
    assert actual["ranges"] == heads + ends
    places = [(0, 512), (size - 22, size), (size - 9000, size - 22), (512, 20000), (70000, 90000)]
    assert b64decode(actual["read"]) == b"".join(package[first:last] for first, last in places)


class Counted(Ranges):
    """`sent` has path and bytes of each answer to a range."""

    sent: ClassVar[list[tuple[str, int]]] = []

    def send_head(self) -> Any:
        answer = super().send_head()
        if isinstance(answer, io.BytesIO):
            self.sent.append((self.path, len(answer.getvalue())))
        return answer


PICTURE = """
(async () => {{
    const {{ engine, viewer, opened }} = {element}.stage;
    viewer.pause();
    await engine.done();
    return [Array.from(new Uint32Array((await engine.picture()).buffer)), opened.source.name];
}})()
"""


@pytest.mark.chromium
def test_the_element_shows_the_same_bits_from_ranges_of_either_file(page, tmp_path):
    """The JSON of the .glb comes on top; the fallback and other bytes are not requested."""
    (tmp_path / ELEMENT).write_bytes(viewer_file(ELEMENT))
    shutil.copy(TOY, tmp_path / "toy.rna")
    file = GltfFile()
    file.view(bytes(2**20))
    file.document["nodes"] = [asset_node(file.view(TOY.read_bytes()))]
    (tmp_path / "toy.glb").write_bytes(file.to_bytes())
    once = f'jitter="0" first-look="off" {SMALL}'
    body = "".join(
        f'<rna-viewer id="{name}" src="toy.{suffix}" {once}></rna-viewer>'
        for name, suffix in (("one", "rna"), ("two", "glb"))
    )
    Counted.sent.clear()
    with served_folder(tmp_path, Counted) as url:
        show(page, tmp_path, url, body)
        loads(page, "one")
        loads(page, "two")
        finished(page, "one")
        finished(page, "two")
    one, two = (page.evaluate(PICTURE.format(element=name)) for name in ("one", "two"))
    assert (one[1], two[1]) == ("toy.rna", "toy.glb")
    assert one[0] == two[0] and len(set(one[0])) > 1000
    packages, gltfs = (
        [size for path, size in Counted.sent if path.endswith(end)] for end in ("rna", "glb")
    )
    assert len(gltfs) == len(packages) + 1 and sum(gltfs) == sum(packages) + 65536


@pytest.mark.chromium
def test_what_the_element_cannot_show_has_a_line(page, folder, url):
    packages = [folder / "tiny.rna", folder / "fibers.rna"]
    write_gltf(folder / "two.glb", packages)
    show(page, folder, url, f'<rna-viewer id="one" src="two.glb" {SMALL}></rna-viewer>')
    page.wait_for("count('error', 'one') === 1", TIMEOUT)
    assert "two.glb: expected one package, found 2" in line(page)
    assert page.evaluate("heard.at(-1).code") == "GLB_SEVERAL"
    write_gltf(folder / "one.glb", packages[:1])
    page.evaluate("one.src = 'one.glb', 0")
    page.wait_for("count('load', 'one') === 1", TIMEOUT)
    assert line(page) is None
