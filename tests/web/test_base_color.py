"""Base colour in the viewer: as a factor of transport, and looked up in images at the hits."""

import base64
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rna_render import load_world
from rna_render.scene import read_scene
from rna_render.world.camera import Camera
from rna_sdk import runtime
from rna_sdk.package.blocks import query_width
from rna_trace.embree.instances import CAMERA_RAY
from rna_view.site_files import Site
from rna_view.site_source import site_for
from tests.gpu.test_evaluate import rows
from tests.package.builders import INPUTS
from tests.package.lobes import LOBES, even_decoder, with_lobes
from tests.package.prints import LABEL, STAMP, image_bytes, make_print, make_variants
from tests.web.pages import (
    FIRST_LOOK,
    TIMEOUT,
    base64_of,
    call_reader,
    picture,
    viewer,
    wait_for_picture,
)
from tests.web.test_picture import (
    LEAST_PSNR,
    SUNS,
    by_rna_run,
    middles_of_pixels,
    psnr,
    write_scene,
)

pytestmark = pytest.mark.chromium
__all__ = ["middles_of_pixels"]


def test_transport_as_the_runtime_has_it(tmp_path):
    """By one decoder, and by two of which one is for shadowed light."""
    path = make_print(tmp_path / "print.rna")
    with viewer(Site({}, {})) as page:
        for tier in ("small", "hq"):
            asset = runtime.load(path, tier)
            x, n, wo, wi, colors = rows(500, asset.bounds)
            expected = np.hstack(asset.evaluate(x, n, wo, wi, colors))
            queries = np.hstack([x, n, np.zeros((500, 1), np.float32), wo, wi, colors])
            text = base64.b64encode(queries.tobytes()).decode()
            call_reader(page, "load", base64_of(path), tier)
            answer = call_reader(page, "evaluate", 0, "transport", text)
            actual = np.frombuffer(base64.b64decode(answer), "<f4").reshape(500, 6)
            assert np.abs(actual - expected).max() <= 1e-3 * np.sqrt(np.mean(expected**2))


SIZE = [96, 60]
VIEW = {"position": [1.6, 1.5, 2.9], "look_at": [0.0, -0.1, 0.0]}
PRINT = """
  - path: {path}
    tier: hq
    maps: {{label: noise.png}}
    tint: [0.6, 1.2, 1]"""


def write_files(folder: Path, cells: tuple[int, int] = (256, 128)) -> dict[str, bytes]:
    """Images of so many random cells for make_print; in the folder another one, noise.png."""
    rng = np.random.default_rng(9)
    noise = [rng.integers(0, 256, (*cells[::-1], 3)).astype(np.uint8) for _ in range(2)]
    images = [np.asarray(Image.fromarray(one).resize((256, 128))) for one in noise]
    (folder / "noise.png").write_bytes(image_bytes(images[1][:100]))
    return {LABEL: image_bytes(images[0]), STAMP: image_bytes(images[1][:7, :9])}


def printed_anew(scene: Path, path: Path) -> None:
    """Changes the scene of write_scene: another map, a tint, and the tier of two decoders."""
    before = f"[{{path: {path}}}]"
    scene.write_text(scene.read_text().replace(before, PRINT.format(path=path)))


@pytest.mark.usefixtures("middles_of_pixels")
def test_the_picture_of_the_path_tracer(tmp_path):
    """By two decoders, with another map and a tint; then the package's own print, by one."""
    path = make_print(tmp_path / "print.rna", write_files(tmp_path))
    scene = write_scene(tmp_path, {"path": path, **VIEW}, SUNS, SIZE, 1)
    plain = by_rna_run(scene)
    printed_anew(scene, path)
    query = "samples=1&pixel-ratio=1&ui=0&jitter=0"
    with viewer(site_for(scene), query, *SIZE) as page:
        wait_for_picture(page, 1)
        assert psnr(picture(page), by_rna_run(scene)) >= LEAST_PSNR
        element = "document.querySelector('rna-viewer')"
        for name in ("maps", "tint", "tier"):
            page.evaluate(f"{element}.removeAttribute('{name}')")
        is_own = "rnaViewer.shown.name === 'small' && !Object.keys(rnaViewer.arrays.maps).length"
        page.wait_for(is_own, TIMEOUT)
        wait_for_picture(page, 1)
        assert psnr(picture(page), plain) >= LEAST_PSNR
        assert page.evaluate(f"{element}.availableMaps") == ["label", "stamp"]
        said = page.evaluate(f"{element}.setMap('stamps', null).catch(String)")
        assert said.endswith('expected label or stamp, found "stamps"')


@pytest.mark.usefixtures("middles_of_pixels")
def test_variants_as_the_path_tracer_shows_them(tmp_path):
    """By the scene, then by the attribute; of one that is not there a line is said."""
    path = make_variants(tmp_path / "print.rna")
    scene = write_scene(tmp_path, {"path": path, **VIEW}, SUNS, SIZE, 1)
    plain, text = by_rna_run(scene), scene.read_text()
    scene.write_text(text.replace(f"{{path: {path}}}", f"{{path: {path}, variant: deep red}}"))
    red = by_rna_run(scene)
    assert psnr(plain, red) < LEAST_PSNR - 10
    element = "document.querySelector('rna-viewer')"
    with viewer(site_for(scene), "samples=1&pixel-ratio=1&ui=0&jitter=0", *SIZE) as page:
        wait_for_picture(page, 1)
        assert psnr(picture(page), red) >= LEAST_PSNR
        assert page.evaluate(f"{element}.availableVariants") == ["as it is", "deep red"]
        for name, shown in (("as it is", plain), ("deep red", red), ("blue", plain)):
            page.evaluate(f"{element}.variantName = '{name}'")
            chosen = "null" if name == "blue" else f"'{name}'"
            page.wait_for(f"rnaViewer.arrays.variant === {chosen}", TIMEOUT)
            page.evaluate("rnaViewer.viewer.start()")  # `picture` has paused it
            wait_for_picture(page, 1)
            assert psnr(picture(page), shown) >= LEAST_PSNR, name
        text = page.evaluate(f"{element}.shadowRoot.textContent + document.body.textContent")
        assert 'variant-name: expected "as it is" or "deep red", found "blue"' in text


@pytest.mark.usefixtures("middles_of_pixels")
def test_the_first_look_is_as_sharp_as_the_print(tmp_path):
    """Beside the runtime's print detail, under an even sky that every lobe has whole."""
    plain = make_print(tmp_path / "plain.rna", write_files(tmp_path))
    columns = query_width(INPUTS, 2) + 16
    lobes = even_decoder(columns)
    path = with_lobes(plain, tmp_path / "print.rna", decoder=lobes)
    sky = "{type: environment, radiance: [1.5, 1.5, 1.5], visible_to_camera: false}"
    scene = write_scene(tmp_path, {"path": path, **VIEW}, sky, SIZE, 1)
    expected = 1.5 * LOBES / 16 * (1.0 + print_detail(scene, path))
    with viewer(site_for(scene), "samples=1&pixel-ratio=1&ui=0&jitter=0", *SIZE) as page:
        wait_for_picture(page, 1)
        look = np.float32(page.evaluate(FIRST_LOOK)).reshape(*SIZE[::-1], 4)
    inside = look[..., 3] > 0.999
    assert np.ptp(expected[inside]) > 0.2 and inside.sum() > 300
    shown = np.dstack([expected, inside])
    assert psnr(look, shown) >= LEAST_PSNR - 1


def print_detail(scene: Path, path: Path) -> np.ndarray:
    """Print detail at what the middles of pixels show: (h, w, 3) float32, 1 beside the asset."""
    scene_file = read_scene(scene)
    camera = Camera(scene_file.scene.camera, scene_file.scene.resolution)
    pixels = np.arange(SIZE[0] * SIZE[1], dtype=np.uint32)
    directions = camera.directions(pixels, np.full((len(pixels), 2), 0.5))
    origin = np.tile(camera.position, (len(pixels), 1))
    hits = load_world(scene_file).scene.intersect(origin, directions, rays=CAMERA_RAY)
    seen = np.flatnonzero(hits.instance >= 0)
    widths = np.float32(camera.spread) * hits.t[seen]
    where = hits.primitive[seen], hits.u[seen], hits.v[seen], widths
    asset = runtime.load(path)
    result = np.ones((len(pixels), 3), np.float32)
    result[seen] = asset.print_detail_at(*where, asset.base_color_at(*where))
    return result.reshape(*SIZE[::-1], 3)
