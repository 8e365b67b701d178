"""rna-three with the two newest releases of three.js, as its peer range says."""

from __future__ import annotations

import base64
import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest

from tests.web.pages import TIMEOUT
from tests.web.three.pages import MODULES, PAGE, REPOSITORY, TINY, installed, opened

RELEASES = ("three-before", "three")
SIZE = 48, 30
PICTURE = """(async () => {
    const { THREE, rna, picture, shadowingSun } = test;
    const asset = await new rna.RnaLoader().loadAsync("surface-tiny.rna");
    const lamp = new THREE.PointLight(0xffffff, 3), area = new THREE.RectAreaLight(0xffffff, 2);
    lamp.position.set(2, 1, 2);
    area.position.set(-1, 2, 2);
    area.lookAt(0, 0, 0);
    const lights = [shadowingSun(), lamp, area];
    const image = await picture(asset, WIDTH, HEIGHT, { lights, position: [0, 1, 4], lookAt: [0, 0, 0] });
    return { image, revision: THREE.REVISION };
})()"""


def test_the_peer_range_is_that_of_both():
    manifest = json.loads((REPOSITORY / "runtime" / "web" / "three" / "package.json").read_text())
    versions = [
        json.loads((MODULES / name / "package.json").read_text())["version"] for name in RELEASES
    ]
    first, last = (int(version.split(".")[1]) for version in versions)
    assert last == first + 1
    assert manifest["peerDependencies"]["three"] == f">=0.{first}.0 <0.{last + 1}.0"


@pytest.mark.chromium
def test_both_draw_the_same(tmp_path):
    seen = {release: picture(tmp_path / release, release) for release in RELEASES}
    (before, now), revisions = (
        [image for image, _ in seen.values()],
        [revision for _, revision in seen.values()],
    )
    assert len(set(revisions)) == 2
    covered = now[..., 3] > 0
    assert covered.sum() > 100 and now[covered][:, :3].mean() > 0.01
    np.testing.assert_allclose(before, now, atol=2e-3)


def picture(folder: Path, release: str) -> tuple[np.ndarray, str]:
    """(h, w, 4) float32 of the asset under three lights, one with shadows; the release's number."""
    folder.mkdir()
    installed(folder, release)
    for path in (TINY, PAGE):
        shutil.copy(path, folder)
    with opened(folder, PAGE.name, *SIZE) as page:
        page.wait_for("!!globalThis.test", TIMEOUT)
        width, height = map(str, SIZE)
        record = page.evaluate(PICTURE.replace("WIDTH", width).replace("HEIGHT", height))
    values = np.frombuffer(base64.b64decode(record["image"]), "<f4")
    assert re.fullmatch(r"\d+", record["revision"])
    return values.reshape(SIZE[1], SIZE[0], 4), record["revision"]
