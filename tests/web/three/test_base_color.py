"""Base colour in three.js is that of rna-run: the package's own print, and another one."""

import shutil

import numpy as np
import pytest

from tests.package.prints import make_print, make_variants
from tests.web.pages import TIMEOUT
from tests.web.test_base_color import VIEW, printed_anew, write_files
from tests.web.test_picture import LEAST_PSNR, by_rna_run, middles_of_pixels, psnr, write_scene
from tests.web.three.pages import PAGE, installed, opened
from tests.web.three.test_lights import LOAD, SUN, by_three

pytestmark = pytest.mark.chromium
__all__ = ["middles_of_pixels"]

SIZE = [96, 60]
CELLS = (
    8,
    4,
)  # smooth, and without edges: SwiftShader rasterises corners on a grid of 1/16 of a pixel
PRINTED_ANEW = """(async () => {{
    const asset = await new rna.RnaLoader().loadAsync("{}");
    asset.tier = "hq";
    const other = await asset.setMap("stamps", null).catch((error) => error.message);
    if (!other.includes('expected label or stamp, found "stamps"')) throw new Error(other);
    await picture(asset, 8, 8);
    await asset.setMap("label", await (await fetch("noise.png")).blob());
    asset.setTint(new THREE.Color(0.6, 1.2, 1));
    return asset;
}})()"""

VARIANT = """(async () => {{
    const loader = new rna.RnaLoader().setVariant("blue");
    const other = await loader.loadAsync("{0}").catch((error) => error.message);
    const expected = 'setVariant: expected "as it is" or "deep red", found "blue"';
    if (other !== expected) throw new Error(other);
    const asset = await loader.setVariant("deep red").loadAsync("{0}");
    if (asset.variants.join() !== "as it is,deep red") throw new Error(asset.variants);
    return asset;
}})()"""


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    folder = tmp_path_factory.mktemp("prints")
    installed(folder)
    make_print(folder / "print.rna", write_files(folder, CELLS))
    make_variants(folder / "variants.rna", images=write_files(folder, CELLS))
    shutil.copy(PAGE, folder)
    with opened(folder, PAGE.name, *SIZE) as page:
        page.wait_for("!!globalThis.test", TIMEOUT)
        yield page


@pytest.mark.parametrize("load", [LOAD, PRINTED_ANEW], ids=["its own print", "another print"])
@pytest.mark.usefixtures("middles_of_pixels")
def test_the_picture_of_the_path_tracer(load, page, tmp_path):
    """By one decoder; after another picture by two, with another map and a tint."""
    path = make_print(tmp_path / "print.rna", write_files(tmp_path, CELLS))
    scene = write_scene(tmp_path, {"path": path, **VIEW}, SUN, SIZE, 1)
    if load == PRINTED_ANEW:
        printed_anew(scene, path)
    actual = by_three(page, {"path": path, **VIEW}, "sun()", SIZE, load=load)
    expected = by_rna_run(scene)
    assert psnr(actual, without_edges(expected, actual)) >= LEAST_PSNR
    assert psnr(1.1 * actual, without_edges(expected, actual)) < LEAST_PSNR


@pytest.mark.usefixtures("middles_of_pixels")
def test_a_variant(page, tmp_path):
    path = make_variants(tmp_path / "variants.rna", images=write_files(tmp_path, CELLS))
    scene = write_scene(tmp_path, {"path": path, **VIEW}, SUN, SIZE, 1)
    plain, text = by_rna_run(scene), scene.read_text()
    scene.write_text(text.replace(f"{{path: {path}}}", f"{{path: {path}, variant: deep red}}"))
    expected = by_rna_run(scene)
    actual = by_three(page, {"path": path, **VIEW}, "sun()", SIZE, load=VARIANT)
    assert psnr(actual, without_edges(expected, actual)) >= LEAST_PSNR
    assert psnr(actual, without_edges(plain, actual)) < LEAST_PSNR - 10


def without_edges(expected: np.ndarray, actual: np.ndarray) -> np.ndarray:
    """The 95% of the pixels that are most alike: not those that show another face."""
    worst = np.abs(np.clip(actual, 0, 1) - np.clip(expected, 0, 1))[..., :3].max(axis=-1)
    result = expected.copy()
    result[worst > np.quantile(worst[expected[..., 3] > 0], 0.95), 3] = 0
    return result
