"""An element that is taken out of the page while it loads, and put back."""

import json

import numpy as np
import pytest

from tests.web.element_pages import SMALL, Static, finished, loads, show
from tests.web.pages import TIMEOUT
from tests.web.test_page import write_image

pytestmark = pytest.mark.chromium

MOMENTS = {
    "engine": "GPUAdapter.prototype, 'requestDevice', () => true",
    "scene": "globalThis, 'fetch', (file) => /scene/.test(file)",
    "package": "globalThis, 'fetch', (file) => /tiny/.test(file)",
    "shaders": "GPUDevice.prototype, 'createComputePipelineAsync', () => one.stage.loading",
    "hierarchy": "performance, 'mark', (name) => name === 'hierarchy'",
    "first-rays": "GPUQueue.prototype, 'onSubmittedWorkDone', () => true",
}
"""Calls of the engine when the element goes: an object, its method, and which call."""
BODY = """<link rel="icon" href="data:,"><script>
  globalThis.devices = [];
  const hear = (object, name, before) => {
    const real = object[name];
    object[name] = function (...given) {
      before(given);
      return real.apply(this, given);
    };
  };
  const ask = GPUAdapter.prototype.requestDevice;
  GPUAdapter.prototype.requestDevice = async function (...given) {
    const record = { isLost: false }, device = await ask.apply(this, given);
    devices.push(record);
    device.lost.then(() => { record.isLost = true; });
    return device;
  };
  const leaveAt = (object, name, isIt) => hear(object, name, (given) => {
    if (globalThis.kept || !isIt(...given)) return;
    globalThis.kept = globalThis.one = one;  // a name that lasts
    one.remove();
    if (COMES_BACK) setTimeout(() => document.body.prepend(kept), 0);
  });
  leaveAt(MOMENT);
</script>
<rna-viewer id="one" scene="scene.json" loading="eager" SMALL></rna-viewer>"""


@pytest.fixture(scope="module")
def scene(folder):
    """Names the package, a camera and an image for light."""
    write_image(folder / "sky.hdr", np.full((4, 8, 3), 0.25, np.float32))
    camera = {"position": [3, 1, 0], "look_at": [0, 0, 0], "vertical_fov_deg": 30}
    record = {"asset": "tiny.rna", "camera": camera, "environment": {"image": "sky.hdr"}}
    (folder / "scene.json").write_text(json.dumps(record))


@pytest.mark.parametrize(
    ("moment", "is_put_back_at_once"),
    [
        *((moment, False) for moment in MOMENTS),
        ("scene", True),
        ("package", True),
        ("shaders", True),
    ],
)
def test_taken_out_while_it_loads(page, folder, url, scene, moment, is_put_back_at_once):
    """Nothing is said, the GPU is free, and the element works where it is put back."""
    body = BODY.replace("MOMENT", MOMENTS[moment]).replace("SMALL", SMALL)
    with page.complaints() as said:
        show(page, folder, url, body.replace("COMES_BACK", str(is_put_back_at_once).lower()))
        page.wait_for("!!globalThis.kept", TIMEOUT)
        if not is_put_back_at_once:
            page.wait_for("!kept.stage.engine && devices.every(({ isLost }) => isLost)", TIMEOUT)
            page.evaluate("new Promise((resolve) => setTimeout(resolve, 300))")
            assert page.evaluate(
                "!kept.stage.engine && heard.every(({ name }) => /change/.test(name))"
            )
            page.evaluate("document.body.prepend(kept), 0")
        loads(page, "one")
        finished(page, "kept")
    assert said == []
    assert page.evaluate("devices.filter(({ isLost }) => !isLost).length") == 1
    assert page.evaluate("kept.notices.whole === null && count('error', 'one') === 0")
    assert page.evaluate("kept.stage.lighting.tables().floats[0]") == 0.25


TIER_LATER = """(() => {
    const real = performance.mark;
    performance.mark = (name) => {
        performance.mark = real;
        if (name === "package") kept.remove();
    };
    globalThis.kept = globalThis.one = one;
    one.tier = "hq";
    one.cameraOrbit = "50deg 60deg 3m";
})()"""


def test_what_has_a_scene_comes_back_as_it_was(page, folder, url, scene):
    """With the last camera, and the tier that was on its way; the scene is read once."""
    element = f'<rna-viewer id="one" scene="scene.json" loading="eager" {SMALL}></rna-viewer>'
    show(page, folder, url, element)
    loads(page, "one")
    page.evaluate(TIER_LATER)
    page.wait_for("!kept.isConnected && !kept.stage.engine", TIMEOUT)
    Static.requested.clear()
    page.evaluate("document.body.prepend(kept), 0")
    page.wait_for("kept.stage.shown.name === 'hq'", TIMEOUT)
    assert page.evaluate("kept.cameraOrbit") == "50deg 60deg 3m"
    assert not any(path.endswith("scene.json") for path in Static.requested)
