"""docs/viewer.md and docs/preview.md, word for word: commands, parameters, the line to embed."""

import re
import shlex
from html import escape

import pytest

from rna_render.command import rna_run as rna_run
from rna_view import rna_view_command as rna_view
from rna_view.site_export import EMBED
from tests.conftest import REPOSITORY
from tests.package.builders import make_tiny_package

VIEWER = (REPOSITORY / "docs" / "viewer.md").read_text()
ELEMENT = (REPOSITORY / "docs" / "element.md").read_text()
PREVIEW = (REPOSITORY / "docs" / "preview.md").read_text()
PANEL = {
    name: (REPOSITORY / "runtime" / "web" / "src" / name / "index.html").read_text()
    for name in ("viewer", "preview")
}
COMMANDS = re.findall(r"^    (rna-(?:view|run) .*)$", VIEWER + PREVIEW, re.MULTILINE)


@pytest.mark.parametrize("command", COMMANDS)
def test_commands(command, tmp_path, monkeypatch):
    """Up to where the page would be served, which other tests do."""
    make_tiny_package(tmp_path / "asset.rna")
    text = (REPOSITORY / "examples" / "quickstart" / "scene.yaml").read_text()
    (tmp_path / "scene.yaml").write_text(text.replace("toy.rna", "asset.rna"))
    monkeypatch.chdir(tmp_path)
    served = []
    monkeypatch.setattr(rna_view, "_serve", lambda site, options: served.append(site))
    monkeypatch.setattr(
        "rna_render.preview.preview_command.preview", lambda *a, **k: served.append(a)
    )
    name, *arguments = shlex.split(command)
    assert {"rna-view": rna_view, "rna-run": rna_run}[name].main(arguments) == 0
    assert bool(served) != (tmp_path / "site" / "index.html").is_file()


def test_commands_are_found():
    assert {"rna-view asset.rna", "rna-view asset.rna --export site/"} <= set(COMMANDS)
    assert "rna-run scene.yaml --preview" in COMMANDS


def test_parameters_are_those_of_the_page():
    source = (REPOSITORY / "runtime/web/src/viewer/parameters.js").read_text()
    known = set(re.findall(r'"(\w+)"', source.split("const OWN = ")[1].split(";")[0]))
    table = VIEWER.split("| parameter | meaning |")[1].split("\n\n")[0]
    assert set(re.findall(r"`(\w+)=", table)) == known


def test_attributes_and_events_are_those_of_the_element():
    sources = REPOSITORY / "runtime" / "web" / "src" / "element"
    readers = (sources / "attributes.js").read_text().split("READERS = {")[1].split("};")[0]
    known = set(re.findall(r'"?([a-z-]+)"?: ', readers))
    table = ELEMENT.split("| attribute | meaning | default |\n| --- | --- | --- |\n")[1]
    rows = [row.split("|")[1] for row in table.split("\n\n")[0].splitlines()]
    named = {name for row in rows for name in re.findall(r"`([a-z-]+)`", row)}
    assert named == known
    fired = set(re.findall(r'_fire\("([a-z-]+)"', (sources / "rna_viewer.js").read_text()))
    table = ELEMENT.split("| event | `detail` |")[1].split("\n\n")[0]
    assert set(re.findall(r"^\| `([a-z-]+)`", table, re.MULTILINE)) == fired


def test_the_line_to_embed_is_that_of_the_command(tmp_path, capsys):
    line = EMBED.format(address="https://example.org/site/", title="asset")
    assert line in VIEWER
    package = make_tiny_package(tmp_path / 'a "b".rna')
    assert rna_view.main([str(package), "--export", str(tmp_path / "site")]) == 0
    assert f'title="{escape(package.stem)}"' in capsys.readouterr().out


@pytest.mark.parametrize(("page", "text"), [("viewer", VIEWER), ("preview", PREVIEW)])
def test_controls_that_are_named_are_there(page, text):
    """Bold or italic words at the start of a sentence are labels of the panel."""
    named = {"viewer": r"\*([A-Z][\w ]+)\*", "preview": r"\*\*([A-Z][\w ]+)\*\*"}[page]
    labels = re.findall(named, text)
    assert labels and [label for label in labels if label not in PANEL[page]] == []
