"""Releases of three.js that rna-three is for: instances of an asset are what its clones are."""

import base64
import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from tests.web.pages import TIMEOUT
from tests.web.three.pages import MODULES, PAGE, REPOSITORY, THREE, TINY, installed, opened

NEWEST, OLDEST = MODULES / "three", MODULES / "three-oldest"
SIZE = 48, 30
TWICE = """(async () => {
  const { THREE, rna, picture } = test, asset = await new rna.RnaLoader().loadAsync("NAME");
  const { center, radius } = asset.content.sphere, size = 0.3 / radius;
  const middle = new THREE.Matrix4().makeTranslation(center.clone().negate());
  const place = (k, turn) => new THREE.Matrix4().compose(
    new THREE.Vector3(0.6 * k - 0.3, 0, 0),
    new THREE.Quaternion().setFromEuler(new THREE.Euler(turn, 2 * turn + k, 0)),
    new THREE.Vector3().setScalar(size * (0.8 + 0.4 * k))).multiply(middle);
  const many = asset.instanced(1), more = asset.instanced(1), seen = [];
  const groups = [0, 1].map(() => asset.clone()), both = new THREE.Group().add(...groups);
  const all = new THREE.Group().add(...many, ...more);
  for (const turn of [0.3, 1.9]) {  // each has a program of its own, and is moved
    [many, more].forEach((meshes, k) => meshes.forEach((mesh) => {
      mesh.setMatrixAt(0, place(k, turn));
      mesh.instanceMatrix.needsUpdate = true;
      mesh.frustumCulled = false;
    }));
    groups.forEach((group, k) => {
      group.matrixAutoUpdate = false;
      group.matrix.copy(place(k, turn));
    });
    for (const own of [all, both]) {
      seen.push(await picture(own, WIDTH, HEIGHT, { position: [0, 0, 3], lookAt: [0, 0, 0] }));
    }
  }
  return [THREE.REVISION, ...seen];
})()"""


def minor_of(release: Path) -> int:
    return int(json.loads((release / "package.json").read_text())["version"].split(".")[1])


def test_peers_are_from_the_oldest_to_the_newest_that_are_tested():
    wanted = json.loads((REPOSITORY / "runtime/web/three/package.json").read_text())
    oldest, after = minor_of(OLDEST), minor_of(NEWEST) + 1
    assert wanted["peerDependencies"] == {"three": f">=0.{oldest}.0 <0.{after}.0"}


@pytest.mark.chromium
@pytest.mark.parametrize("release", [THREE, OLDEST], ids=["newest", "oldest"])
def test_instances_are_what_clones_are(release, tmp_path):
    installed(tmp_path, release)
    for path in (TINY, PAGE):
        shutil.copy(path, tmp_path)
    with opened(tmp_path, PAGE.name, *SIZE) as page:
        page.wait_for("!!globalThis.test", TIMEOUT)
        words = {"NAME": TINY.name, "WIDTH": str(SIZE[0]), "HEIGHT": str(SIZE[1])}
        text = TWICE
        for word, value in words.items():
            text = text.replace(word, value)
        revision, *pictures = page.evaluate(text)
    assert int(revision.split(".")[0]) == minor_of(release)
    many, clones, moved, moved_clones = (
        np.frombuffer(base64.b64decode(picture), "<f4").reshape(SIZE[1], SIZE[0], 4)
        for picture in pictures
    )
    assert np.mean(clones[..., 3] > 0) > 0.05 and np.mean(np.abs(many - moved)) > 0.01
    assert np.mean(np.abs(many - clones)) < 1e-3 and np.mean(np.abs(moved - moved_clones)) < 1e-3
