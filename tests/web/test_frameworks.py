"""The element in small apps of frameworks: defined, heard, and still where a finger scrolls.

`scripts/web-frameworks` builds all of them; the suite two. Nuxt takes Node 22 from npm.
"""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.render.chromium import NO_GPU, Page, open_page
from tests.web.pages import TIMEOUT, served_folder
from tests.web.three.pages import TOY, packed

pytestmark = pytest.mark.chromium

APPS = Path(__file__).parent / "frameworks"
BUILDS = {
    "angular": ("ng build", "dist/browser"),
    "astro": ("astro build", "dist"),
    "next": ("next build", "out"),
    "nuxt": ("nuxt generate", ".output/public"),
    "react": ("vite build", "dist"),
    "svelte": ("vite build", "build"),
    "vite": ("vite build", "dist"),
}
"""The command of each framework, and the folder of the pages that it writes."""
STATIC = {"svelte": "static"}
"""The folder of files that are copied as they are, where it is not `public`."""
CHOSEN = os.environ.get("RNA_FRAMEWORKS", "react svelte").split()
QUIET = {"ASTRO_TELEMETRY_DISABLED": "1", "NEXT_TELEMETRY_DISABLED": "1", "NG_CLI_ANALYTICS": "0"}


def built(name: str, folder: Path) -> Path:
    """The pages of a framework's app, with the package that is packed here."""
    if subprocess.run(["npm", "ping"], capture_output=True).returncode:
        pytest.skip("the npm registry does not answer")
    shutil.copytree(APPS / name, folder, dirs_exist_ok=True)
    static = folder / STATIC.get(name, "public")
    static.mkdir()
    shutil.copy(TOY, static)
    install = ["npm", "install", "--no-audit", "--no-fund", "--loglevel=error"]
    subprocess.run([*install, packed("rna-viewer")], cwd=folder, check=True, timeout=1800)
    command, out = BUILDS[name]
    environment = {**os.environ, **QUIET}
    subprocess.run(["npx", *command.split()], cwd=folder, env=environment, check=True, timeout=1800)
    return folder / out


def touch(page: Page, points: list[tuple[float, float]]) -> None:
    """A finger along these places."""
    for kind, places in (("touchStart", points[:1]), ("touchMove", points[1:])):
        for x, y in places:
            page.call("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y}])
    page.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])


@pytest.mark.parametrize("name", CHOSEN)
def test_app(name, tmp_path):
    pages = built(name, tmp_path)
    with served_folder(pages) as url, open_page(400, 400, NO_GPU) as page:
        page.call("Emulation.setTouchEmulationEnabled", enabled=True)
        page.call("Page.navigate", url=url)
        page.wait_for("customElements.get('rna-viewer') && globalThis.one?.stage", TIMEOUT)
        assert page.evaluate("[one.src, one.cameraControls]") == ["/toy.rna", True]
        # There is no GPU: people see the stand-in, which they can turn.
        page.wait_for("one.stage.standIn.shownCamera !== null", TIMEOUT)
        page.evaluate("one.scrollIntoView()")
        view, (x, y) = page.evaluate("one.cameraOrbit"), (200, 120)
        touch(page, [(x, y - 5 * k) for k in range(20)])
        page.wait_for("scrollY > 0", TIMEOUT)
        assert page.evaluate("one.cameraOrbit") == view
        page.evaluate("one.scrollIntoView()")
        touch(page, [(x + 5 * k, y) for k in range(20)])
        moved = "globalThis.heard?.some(([type, source]) => source === 'user-interaction')"
        page.wait_for(moved, TIMEOUT)
        assert page.evaluate("one.cameraOrbit") != view
