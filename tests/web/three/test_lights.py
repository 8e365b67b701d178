"""Under each kind of light of three.js an asset's picture is that of rna-run."""

import base64
import json
import shutil

import numpy as np
import OpenEXR
import pytest

from rna_sdk.package.command.rna_info import main as rna_info
from rna_sdk.package.manifest.extensions import MirrorLobe, Mixture, Sampling
from rna_sdk.package.packing import Unpacked
from tests.render.chromium import Page
from tests.web.pages import TIMEOUT, base64_of
from tests.web.test_picture import (
    CURLS,
    DIM_SUN,
    GLOWING,
    GLOWING_CURLS,
    TOY,
    by_rna_run,
    middles_of_pixels,
    psnr,
    write_scene,
)
from tests.web.three.pages import PAGE, installed, opened

pytestmark = pytest.mark.chromium

SIZE = [96, 60]
LOBES = tuple(
    Mixture(
        first=first,
        cosine=cosine,
        mirror=(MirrorLobe(share=share, width=0.06), MirrorLobe(share=share, width=0.1)),
    )
    for first, cosine, share in ((0, 0.46, 0.21), (4809, 0.6, 0.07))
)
"""Lobes of rays that leave the toy, by triangles, as `rna-export` fits them."""
SUN = "{type: directional, direction: [0.55, 0.75, 0.65], irradiance: [2.5, 2.5, 2.5]}"
POINT = "{type: point, position: [0.9, 1.0, 0.8], intensity: [3.0, 2.5, 2.0]}"
POINT_OF_THREE = 'light("PointLight", [0.9, 1, 0.8], new THREE.Color(3, 2.5, 2), 1)'
SPOT = """{type: spot, position: [0.9, 1.0, 0.8], look_at: [0.2, 0.15, 0.0],
  intensity: [6.0, 5.0, 4.0], outer_angle_deg: 20, inner_angle_deg: 10}"""
SPOT_OF_THREE = (
    'light("SpotLight", [0.9, 1, 0.8], new THREE.Color(6, 5, 4), 1, 0, Math.PI / 9, 0.5)'
)
RECTANGLE = """{type: rectangle, position: [0.9, 1.0, 0.8], look_at: [0.2, 0.15, 0.0],
  size: [0.4, 0.3], radiance: [18.0, 15.0, 12.0], visible_to_camera: false}"""
RECTANGLE_OF_THREE = (
    'light("RectAreaLight", [0.9, 1, 0.8], new THREE.Color(18, 15, 12), 1, 0.4, 0.3)'
)
SKY = "{{type: environment, path: sky.exr, rotation_deg: {rotation}, visible_to_camera: false}}"
SKY_OF_THREE = """light("HemisphereLight", [0, 1, 0],
    new THREE.Color(1, 1.5, 3), new THREE.Color(1.2, 0.5, 0.4), 1)"""
LOAD = 'new rna.RnaLoader().loadAsync("{}")'
LOAD_STANDIN = "(await new GLTFLoader().loadAsync('data:;base64,{}')).scene"
__all__ = ["middles_of_pixels"]


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    folder = tmp_path_factory.mktemp("lights")
    installed(folder)
    for path in (*(one["path"] for one in (TOY, CURLS, GLOWING, GLOWING_CURLS)), PAGE):
        shutil.copy(path, folder)
    toy = Unpacked.read(TOY["path"]).with_extension(Sampling(parts=(LOBES,)), {})
    toy.write(folder / TOY["path"].name)
    with opened(folder, PAGE.name, *SIZE) as page:
        page.wait_for("!!globalThis.test", TIMEOUT)
        yield page


def by_three(
    page: Page, asset: dict, light: str, size: list[int], more: str = "", load: str = LOAD
) -> np.ndarray:
    """The picture, (h, w, 4) float32. light, more, load: JavaScript of `picture`."""
    view = json.dumps({"position": asset["position"], "lookAt": asset["look_at"]})
    actual = page.evaluate(
        f"""(async () => {{
            const {{ THREE, GLTFLoader, rna, picture, imageLight, sun, shadowingSun }} = test;
            const light = (kind, at, ...values) => {{
                const one = new THREE[kind](...values), middle = new THREE.Vector3(0.2, 0.15, 0);
                one.position.set(...at);
                if (kind === "RectAreaLight") one.lookAt(middle);
                one.target?.position.copy(middle);
                one.target?.updateMatrixWorld();
                return one;
            }};
            const asset = await {load.format(asset["path"].name)};
            const view = {{ ...{view}, lights: [{light}], {more} }};
            const found = await picture(asset, {size[0]}, {size[1]}, view);
            asset.dispose?.();
            return found;
        }})()"""
    )
    return np.frombuffer(base64.b64decode(actual), "<f4").reshape(size[1], size[0], 4)


@pytest.mark.parametrize(
    ("asset", "light", "of_three", "size", "samples", "least"),
    [  # with the noise of four columns of nearby light
        (TOY, SUN, "sun()", SIZE, 64, 28.0),
        (TOY, SUN, "shadowingSun()", SIZE, 64, 28.0),  # the map's shadow of the asset is not seen
        (CURLS, SUN, "sun()", SIZE, 1, 30.0),
        (TOY, POINT, POINT_OF_THREE, SIZE, 64, 28.0),
        (TOY, SPOT, SPOT_OF_THREE, SIZE, 64, 28.0),
        (TOY, RECTANGLE, RECTANGLE_OF_THREE, [48, 30], 256, 31.0),  # of four points of the lamp
    ],
    ids=["toy-sun", "toy-sun-with-map", "curls-sun", "toy-point", "toy-spot", "toy-rectangle"],
)
@pytest.mark.usefixtures("middles_of_pixels")
def test_light(asset, light, of_three, size, samples, least, page, tmp_path):
    actual = by_three(page, asset, of_three, size)
    expected = by_rna_run(write_scene(tmp_path, asset, light, size, samples))
    assert psnr(actual, expected) >= least


@pytest.mark.parametrize(
    ("asset", "columns"), [(GLOWING, 16), (GLOWING_CURLS, 4)], ids=["surface", "strands"]
)
@pytest.mark.usefixtures("middles_of_pixels")
def test_nearby_light(asset, columns, page, tmp_path):
    """With the noise of so many columns; by the package's means without rays."""
    size = [64, 40]
    expected = by_rna_run(write_scene(tmp_path, asset, DIM_SUN, size, 64))
    sun = 'light("DirectionalLight", [0.55, 0.75, 0.65], new THREE.Color(0.15, 0.15, 0.15), 1)'
    load = 'new rna.RnaLoader().setOptions({{OPTION}}).loadAsync("{}")'
    by_columns, by_means = (
        by_three(page, asset, sun, size, load=load.replace("OPTION", option))
        for option in (f"nearbySamples: {columns}", 'visibility: "shadow-map"')
    )
    inside = (expected[..., 3] > 0.999) & (by_columns[..., 3] > 0.999)
    expected[~inside] = 0.0
    brightness = by_columns[inside].mean(0) / expected[inside].mean(0)
    assert brightness == pytest.approx(1.0, abs=0.04)
    assert psnr(by_columns, expected) >= psnr(by_means, expected) + 3


@pytest.mark.usefixtures("middles_of_pixels")
def test_hemisphere_and_environment(page, tmp_path):
    """Blue from above, red from below, and an image, turned; with the noise of 4 directions."""
    sky = np.zeros((32, 64, 3), np.float32)
    sky[:16], sky[16:] = np.divide([1.0, 1.5, 3.0], np.pi), np.divide([1.2, 0.5, 0.4], np.pi)
    around = 2 * np.pi * (np.arange(64, dtype=np.float32) + 0.5) / 64
    row = 0.5 + 0.3 * np.stack([np.cos(around), np.sin(around), -np.cos(around)], axis=1)
    image = np.repeat(row[None], 32, axis=0)
    for name, values in (("image.exr", image), ("sky.exr", sky + 0.5 * image)):
        OpenEXR.File({}, {"RGB": values}).write(str(tmp_path / name))
    turned = f"...await imageLight('data:;base64,{base64_of(tmp_path / 'image.exr')}', 2.0, 0.5)"
    actual = by_three(page, TOY, SKY_OF_THREE, SIZE, f"environment: {{ {turned} }}")
    light = SKY.format(rotation=np.degrees(2.0) - 90)  # three.js has the image's middle at +x
    expected = by_rna_run(write_scene(tmp_path, TOY, light, SIZE, 128))
    seen = expected[..., 3] > 0
    brightness = actual[seen][:, :3].mean(0) / expected[seen][:, :3].mean(0)
    assert brightness == pytest.approx(1.0, abs=0.03)
    assert psnr(actual, expected) >= 17.0


@pytest.mark.usefixtures("middles_of_pixels")
def test_standin(page, tmp_path):
    """The plain glTF of rna-info in GLTFLoader: place, size, shape and about the colours."""
    assert rna_info([str(TOY["path"]), "--glb", str(tmp_path / "toy.glb")]) == 0
    load = (
        LOAD_STANDIN.format(base64_of(tmp_path / "toy.glb")).replace("{", "{{").replace("}", "}}")
    )
    actual = by_three(page, TOY, "sun()", SIZE, load=load)
    expected = by_rna_run(write_scene(tmp_path, TOY, SUN, SIZE, 64))
    assert np.mean((actual[..., 3] > 0.5) != (expected[..., 3] > 0.5)) < 0.002
    seen = expected[..., 3] > 0
    shown = [np.minimum(image[seen], 1.0).mean(0) for image in (actual, expected)]
    assert shown[0] == pytest.approx(shown[1], rel=0.2)
    assert psnr(actual, expected) >= 24.0
