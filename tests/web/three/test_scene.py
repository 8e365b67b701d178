"""An asset in a scene of three.js: how it is loaded, its picture, what it leaves behind."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.render.chromium import Page
from tests.web.pages import TIMEOUT
from tests.web.three.pages import REPOSITORY, TOY, installed, opened

pytestmark = pytest.mark.chromium

TINY = REPOSITORY / "spec" / "conformance" / "packages" / "surface-tiny.rna"
SIZE = [96, 60]


@pytest.fixture(scope="module")
def page(tmp_path_factory) -> Iterator[Page]:
    """A page with the module, a renderer and packages beside it."""
    folder = tmp_path_factory.mktemp("scene")
    installed(folder)
    for path in (TOY, TINY, Path(__file__).parent / "page.html"):
        shutil.copy(path, folder)
    with opened(folder, "page.html", *SIZE) as page:
        page.wait_for("!!globalThis.test", TIMEOUT)
        yield page


def run(page: Page, body: str):
    """What an async function of this body returns."""
    return page.evaluate(
        f"(async () => {{ const {{ THREE, rna, renderer, picture }} = test; {body} }})()"
    )


def test_loader_has_the_manners_of_three(page):
    heard = run(
        page,
        """
        const heard = [], hear = (what) => () => heard.push(what);
        const manager = new THREE.LoadingManager(hear("all"), undefined, hear("bad"));
        const loader = new rna.RnaLoader(manager);
        const url = "surface-tiny.rna", progress = ({ loaded }) => heard.push(loaded > 0);
        const asset = await loader.loadAsync(url, progress);
        const parsed = await loader.parseAsync(await (await fetch(url)).arrayBuffer());
        const wrong = await loader.loadAsync("page.html").catch((error) => error.message);
        const missing = await loader.loadAsync("none.rna").catch((error) => error.message);
        await new Promise((resolve) => setTimeout(resolve, 100));
        const group = asset instanceof THREE.Group;
        return { heard, wrong, missing, tiers: [asset.tiers, parsed.tiers], group };
        """,
    )
    events = heard["heard"]
    first = events.index("all")
    assert first > 0 and all(
        event is True for event in events[:first]
    )  # progress, then all is there
    assert "bad" in events[first:]
    assert heard["group"] and heard["tiers"][0] == heard["tiers"][1]
    assert "404" in heard["missing"] and heard["wrong"].endswith("]")  # with an issue code


def test_abort_rejects(page):
    aborted = run(
        page,
        """
        const loader = new rna.RnaLoader();
        const pending = loader.loadAsync("toy.rna").catch((error) => error.name);
        loader.abort();
        return pending;
        """,
    )
    assert aborted == "AbortError"


def test_raycaster_meets_the_asset(page):
    hits = run(
        page,
        """
        const asset = await new rna.RnaLoader().loadAsync("surface-tiny.rna");
        const from = asset.content.sphere.center.clone().add(new THREE.Vector3(0, 0, 10));
        const ray = new THREE.Raycaster(from, new THREE.Vector3(0, 0, -1));
        const found = ray.intersectObject(asset).length;
        asset.position.x = 100;
        asset.updateMatrixWorld();
        return [found, ray.intersectObject(asset).length];
        """,
    )
    assert hits[0] > 0 and hits[1] == 0


def test_dispose_leaves_no_memory(page):
    """After the first time, in which three.js makes what it keeps."""
    totals = run(
        page,
        """
        const totals = [], { memory } = renderer.info;
        for (let k = 0; k < 4; k++) {
          const asset = await new rna.RnaLoader().loadAsync("surface-tiny.rna");
          const copy = asset.clone();
          await picture(asset, 8, 8);
          asset.dispose();
          copy.dispose();
          const { total, storageAttributes, attributes, uniformBuffers, programs } = memory;
          totals.push({ total, storageAttributes, attributes, uniformBuffers, programs });
        }
        return totals;
        """,
    )
    assert totals[1:] == [totals[1]] * 3
