"""Means of pictures of a scene that rests: less noise of lights from all sides, and a new start."""

import base64
import shutil

import numpy as np
import pytest

from tests.web.pages import TIMEOUT
from tests.web.three.pages import PAGE, TINY, installed, opened

pytestmark = pytest.mark.chromium

SIZE = 32  # before three.js 0.187 rows of other sizes are padded to 256 bytes
MEANS = """(async () => {
  const { THREE, rna } = test, renderer = new THREE.WebGPURenderer(), scene = new THREE.Scene();
  await renderer.init();
  const told = [];
  const { device } = renderer.backend;
  device.addEventListener("uncapturederror", ({ error }) => told.push(error.message));
  const asset = await new rna.RnaLoader().loadAsync("NAME");
  const { center, radius } = asset.content.sphere;
  const camera = new THREE.PerspectiveCamera(30, 1, radius, 100);
  camera.position.copy(center).add(new THREE.Vector3(0, 0, 4 * radius));
  scene.add(asset, new THREE.HemisphereLight(0xffffff, 0x402010, 3));
  const target = new THREE.RenderTarget(SIZE, SIZE, { type: THREE.FloatType });
  const still = new rna.StillPicture(renderer, scene, camera, { pictures: 128 });
  const shot = async (count) => {
    while (still.count < count) { renderer.setRenderTarget(target); still.render(); }
    const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, SIZE, SIZE);
    let text = "";
    for (const byte of new Uint8Array(pixels.buffer)) text += String.fromCharCode(byte);
    return btoa(text);
  };
  const pictures = [];
  for (const count of [1, 32, 128]) pictures.push(await shot(count));
  renderer.setRenderTarget(target);
  still.render();  // no more than 128
  const counts = [still.count];
  camera.position.x += 0.1;
  renderer.setRenderTarget(target);
  still.render();
  counts.push(still.count);
  still.dispose();
  return { pictures, counts, told };
})()"""


def test_noise_goes_while_nothing_moves(tmp_path):
    installed(tmp_path)
    for path in (TINY, PAGE):
        shutil.copy(path, tmp_path)
    with opened(tmp_path, PAGE.name, 64, 64) as page:
        page.wait_for("!!globalThis.test", TIMEOUT)
        actual = page.evaluate(MEANS.replace("NAME", TINY.name).replace("SIZE", str(SIZE)))
    assert actual["told"] == [] and actual["counts"] == [128, 1]
    first, mean, reference = (
        np.frombuffer(base64.b64decode(picture), "<f4").reshape(SIZE, SIZE, 4)[..., :3]
        for picture in actual["pictures"]
    )
    assert reference.max() > 0.01
    errors = [np.sqrt(np.mean((one - reference) ** 2)) for one in (first, mean)]
    assert errors[1] < 0.4 * errors[0]
    assert mean.mean() == pytest.approx(reference.mean(), rel=0.02)
