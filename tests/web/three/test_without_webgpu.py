"""Renderers without WebGPU: the asset's shape in grey, and one line; at its compatibility level
the asset itself.
"""

import shutil

import numpy as np
import pytest

from tests.web.pages import TIMEOUT
from tests.web.three.pages import PAGE, TINY, installed, opened

pytestmark = pytest.mark.chromium

PRINT = TINY.with_name("surface-print.rna")
"""Base colour is one more storage buffer of a material."""

RENDERERS = {
    "WebGL 2 backend": "new THREE.WebGPURenderer({ forceWebGL: true })",
    "WebGLRenderer": "new classic.WebGLRenderer()",
    "no storage buffers": "bare()",
}
BARE = """() => {
    const limit = "maxStorageBuffersInFragmentStage";
    Object.defineProperty(GPUSupportedLimits.prototype, limit, { get: () => 0 });
    return new THREE.WebGPURenderer();
}"""
COMPATIBLE = """() => {
    const { requestDevice } = GPUAdapter.prototype, core = "core-features-and-limits";
    GPUAdapter.prototype.requestDevice = function ({ requiredFeatures = [], ...more }) {
        const features = [...requiredFeatures].filter((name) => name !== core);
        return requestDevice.call(this, { ...more, requiredFeatures: features });
    };
    return new THREE.WebGPURenderer();
}"""
"""Makes a renderer whose device has four storage buffers for fragments."""


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    folder = tmp_path_factory.mktemp("without")
    installed(folder)
    for path in (PRINT, PAGE):
        shutil.copy(path, folder)
    with opened(folder, PAGE.name, 64, 64) as page:
        page.wait_for("!!globalThis.test", TIMEOUT)
        yield page


AT_BOTH_LEVELS = """(async () => {{
    const {{ THREE, rna }} = test, compatible = {COMPATIBLE}, told = [];
    console.warn = console.error = (...words) => told.push(words.join(" "));
    const pictures = [], limits = [];
    for (const open of [() => new THREE.WebGPURenderer(), compatible]) {{
        const renderer = open();
        await renderer.init();
        const {{ device }} = renderer.backend;
        device.addEventListener("uncapturederror", ({{ error }}) => told.push(error.message));
        limits.push(device.limits.maxStorageBuffersInFragmentStage);
        limits.push(device.limits.maxUniformBufferBindingSize);
        const asset = await new rna.RnaLoader().loadAsync("{NAME}");
        const {{ center, radius }} = asset.content.sphere, scene = new THREE.Scene();
        const camera = new THREE.PerspectiveCamera(30, 1, radius, 100);
        camera.position.copy(center).add(new THREE.Vector3(0, 0, 4 * radius));
        scene.add(asset, test.sun());
        const target = new THREE.RenderTarget(48, 48, {{ type: THREE.FloatType }});
        renderer.setRenderTarget(target);
        for (const tier of asset.tiers) {{
            asset.tier = tier;
            renderer.render(scene, camera);
            const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, 48, 48);
            pictures.push([...pixels]);
        }}
        asset.dispose();
    }}
    return {{ pictures, limits, told }};
}})()"""


def test_the_compatibility_level_shows_the_asset(page):
    """With four storage buffers, and weights that do not fit its uniform buffers."""
    text = AT_BOTH_LEVELS.format(COMPATIBLE=COMPATIBLE, NAME=PRINT.name)
    actual = page.evaluate(text)
    assert actual["told"] == []
    most, uniform, most_there, uniform_there = actual["limits"]
    assert (most_there, uniform_there) == (4, 16384) and most >= 8 and uniform >= 65536
    pictures = np.float32(actual["pictures"])
    whole, there = pictures[: len(pictures) // 2], pictures[len(pictures) // 2 :]
    assert (whole[..., :].max(axis=1) > 0.01).all() and np.abs(whole[0] - whole[1]).max() > 1e-3
    np.testing.assert_allclose(there, whole, atol=2e-3)


@pytest.mark.parametrize("renderer", RENDERERS)
def test_grey_shape_and_one_line(page, renderer):
    """Before a red box; of an instanced mesh, too."""
    actual = page.evaluate(
        f"""(async () => {{
            const {{ THREE, rna }} = test;
            const classic = await import("./node_modules/three/build/three.module.js");
            const bare = {BARE}, renderer = {RENDERERS[renderer]};
            const told = [], warn = console.warn;
            console.warn = (...words) => told.push(words.join(" "));
            await renderer.init?.();
            renderer.setSize(64, 64, false);
            const asset = await new rna.RnaLoader().loadAsync("{PRINT.name}");
            const {{ center, radius }} = asset.content.sphere;
            const red = new THREE.MeshBasicMaterial({{ color: "red" }});
            const box = new THREE.Mesh(new THREE.BoxGeometry(20, 20, 1), red);
            const scene = new THREE.Scene();
            const camera = new THREE.PerspectiveCamera(30, 1, radius, 100);
            box.position.copy(center).add(new THREE.Vector3(0, 0, -5 - radius));
            camera.position.copy(center).add(new THREE.Vector3(0, 0, 4 * radius));
            const sun = test.sun();
            sun.castShadow = renderer.shadowMap.enabled = true;
            const [many] = asset.instanced(1);
            many.setMatrixAt(0, new THREE.Matrix4());
            const count = (shown) => {{
                scene.clear().add(box, sun, shown);
                renderer.render(scene, camera);
                renderer.render(scene, camera);
                const context = new OffscreenCanvas(64, 64).getContext("2d");
                context.drawImage(renderer.domElement, 0, 0);
                const {{ data }} = context.getImageData(0, 0, 64, 64);
                const found = {{ red: 0, grey: 0 }};
                for (let k = 0; k < data.length; k += 4) {{
                    const [r, g, b] = data.subarray(k, k + 3);
                    if (r > 200 && g < 20) found.red += 1;
                    if (r > 40 && Math.abs(r - g) < 4 && Math.abs(r - b) < 4) found.grey += 1;
                }}
                return found;
            }};
            const counts = [asset, many].map(count);
            console.warn = warn;
            asset.dispose();
            return {{ counts, told }};
        }})()"""
    )
    for count in actual["counts"]:
        assert count["grey"] > 500 and count["red"] > 500
        assert count["grey"] + count["red"] > 64 * 64 - 200
    assert len([line for line in actual["told"] if line.startswith("rna-three")]) == 1
