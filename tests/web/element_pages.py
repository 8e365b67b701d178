"""Pages of others with `<rna-viewer>`, for the fixtures of conftest.py."""

from itertools import count
from pathlib import Path
from typing import ClassVar

from tests.render.chromium import Page
from tests.web.pages import TIMEOUT, Plain

PAGE = """<!doctype html>
<script>
  globalThis.heard = [];
  const names = ["load", "error", "camera-change", "light-change", "poster-dismissed"];
  for (const name of names) document.addEventListener(name, ({ target, detail }) => {
    if (target.localName === "rna-viewer") heard.push({ name, id: target.id, ...detail });
  }, true);
  const count = (name, id) => heard.filter((one) => one.name === name && one.id === id).length;
</script>
<script defer src="rna-viewer.js"></script>
<style>
  body { margin: 0; }
  rna-viewer { width: 64px; height: 40px; background-color: rgb(255, 255, 255); }
</style>
BODY
<div style="height: 3000px"></div>
"""
NUMBERS = count()
SMALL = 'samples="1" pixel-ratio="1"'


class Static(Plain):
    """Any web server; `requested` has the paths."""

    requested: ClassVar[list[str]] = []

    def do_GET(self) -> None:
        self.requested.append(self.path)
        super().do_GET()


def visit(page: Page, folder: Path, url: str, text: str) -> None:
    """Shows the page of this text, at an address of its own: two of one second have one date."""
    number = next(NUMBERS)
    (folder / "page.html").write_text(text)
    page.call("Page.navigate", url="about:blank")
    page.call("Page.navigate", url=f"{url}page.html?{number}")
    page.wait_for(f"location.search === '?{number}'", TIMEOUT)


def show(page: Page, folder: Path, url: str, body: str) -> None:
    """A page with this body, its element defined."""
    visit(page, folder, url, PAGE.replace("BODY", body))
    page.wait_for("customElements.get('rna-viewer') && globalThis.one", TIMEOUT)


def loads(page: Page, element: str, times: int = 1) -> None:
    page.wait_for(f"count('load', '{element}') >= {times}", TIMEOUT)


def finished(page: Page, element: str = "one") -> None:
    """Once the picture is no longer a coarse one, whose camera has fewer pixels."""
    stats = f"{element}.stage.viewer.stats"
    page.wait_for(f"{stats}.scale === 1 && {stats}.rounds === 1", TIMEOUT)


def line(page: Page, element: str = "one") -> str | None:
    """All that the element has to say to the page's maker."""
    return page.evaluate(f"{element}.notices.whole")
