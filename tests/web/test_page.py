"""The viewer's page: files dropped on it, pointer, size, tiers, what goes wrong."""

from pathlib import Path

import numpy as np
import pytest

from rna_sdk.package import query_width
from rna_view.site_source import site_for
from tests.conftest import REPOSITORY
from tests.package.builders import INPUTS, make_tier, make_tiny_fiber_package, make_tiny_package
from tests.package.carriers import make_carrier
from tests.package.lobes import even_decoder, with_lobes
from tests.render.chromium import NO_GPU, Page
from tests.web.pages import FIRST_LOOK, TIMEOUT, base64_of, notice, viewer, wait_for_picture

pytestmark = pytest.mark.chromium

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
FILE = "new File([Uint8Array.from(atob('{data}'), (c) => c.charCodeAt(0))], '{name}')"


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    """A package of two tiers."""
    folder = tmp_path_factory.mktemp("page")
    tiers = make_tier("small"), make_tier("hq", resolution=256)
    return make_tiny_package(folder / "two.rna", *tiers)


@pytest.fixture(scope="module")
def page(package):
    """The page with the package, three samples a picture."""
    with viewer(site_for(package), "samples=3&pixel-ratio=1", 160, 120) as page:
        wait_for_picture(page, 3)
        yield page


def drop(page: Page, path: Path) -> None:
    """Drop a file on the page, and wait until it is read."""
    file = FILE.format(data=base64_of(path), name=path.name)
    page.evaluate(
        f"""(async () => {{
            const dataTransfer = new DataTransfer(), file = {file};
            dataTransfer.items.add(file);
            window.dispatchEvent(new DragEvent("drop", {{ dataTransfer, cancelable: true }}));
            await new Promise((resolve) => setTimeout(resolve, 50));
            while (rnaViewer.loading) {{
                await new Promise((resolve) => setTimeout(resolve, 20));
            }}
        }})()"""
    )


def canvas_of(page: Page) -> str:
    """The picture as a data URL."""
    return page.evaluate(
        """rnaViewer.screenshot().then((blob) => new Promise((resolve) => {
            const reader = new FileReader();
            reader.onload = () => resolve(reader.result);
            reader.readAsDataURL(blob);
        }))"""
    )


def test_drag_orbits_and_alt_drag_turns_the_light(page):
    orbit, light = "rnaViewer.orbit.azimuth", "rnaViewer.lighting.rotation"
    for name, modifiers, moves in (("orbit", 0, (True, False)), ("light", 1, (False, True))):
        before = page.evaluate(f"[{orbit}, {light}]")
        picture = canvas_of(page)
        page.mouse("mousePressed", 60, 60, button="left", clickCount=1, modifiers=modifiers)
        page.mouse("mouseMoved", 90, 60, button="left", buttons=1, modifiers=modifiers)
        page.mouse("mouseReleased", 90, 60, button="left", clickCount=1, modifiers=modifiers)
        wait_for_picture(page, 3)
        after = page.evaluate(f"[{orbit}, {light}]")
        assert tuple(a != b for a, b in zip(before, after, strict=True)) == moves, name
        assert canvas_of(page) != picture


def test_size_of_the_window(page):
    for width, height in ((200, 90), (160, 120)):
        page.call(
            "Emulation.setDeviceMetricsOverride",
            width=width, height=height, deviceScaleFactor=1, mobile=False,
        )  # fmt: skip
        page.wait_for(
            f"rnaViewer.canvas.width === {width} && rnaViewer.canvas.height === {height}", TIMEOUT
        )
        wait_for_picture(page, 3)


def test_dropped_package_is_shown(page, tmp_path, package):
    """Also that of a .glb."""
    fibers = make_tiny_fiber_package(tmp_path / "fibers.rna")
    drop(page, fibers)
    page.wait_for("rnaViewer.shown.parts[0].kind === 'fiber'", TIMEOUT)
    wait_for_picture(page, 3)
    drop(page, make_carrier(package, tmp_path / "surface.glb"))
    page.wait_for("rnaViewer.shown.parts[0].kind === 'surface'", TIMEOUT)
    wait_for_picture(page, 3)
    assert notice(page) is None


SHOWN = """globalThis.pictures = [];
rnaViewer.viewer.addEventListener("shown", () => {
    const { stats: { rounds, scale }, shown: { firstLook } } = rnaViewer.viewer;
    pictures.push([rounds, scale, firstLook]);
});"""


SHARPENED = """new Promise((resolve) => {
    const { viewer, engine, canvas: { width, height } } = rnaViewer;
    viewer.msPerPixel = 1;
    viewer.addEventListener("shown", function shown() {
        if (viewer.stats.scale !== 4 || viewer.shownCamera.width !== width) return;
        viewer.removeEventListener("shown", shown);
        viewer.pause();
        engine.done().then(() => {  // the next size has begun by then, and ends
            engine.target = { width, height };  // of what FIRST_LOOK reads
            resolve();
        });
    });
    viewer.restart();
})"""
"""Until the first look has light of a quarter of the size, and edges of the full one."""


def test_package_with_lobes_has_a_first_look(page, tmp_path, package):
    """It is whole before the first sample, what shows while something moves, and fades."""
    columns = query_width(INPUTS, 4) + 16
    lobes = even_decoder(columns)
    drop(page, with_lobes(package, tmp_path / "lobes.rna", decoder=lobes))
    page.evaluate(SHOWN)
    page.evaluate("rnaViewer.setGround(false)")
    page.evaluate("rnaViewer.setLight({ choice: 'white', sun: 0, strength: 1.5 })")
    wait_for_picture(page, 3)
    assert notice(page) is None
    pictures = page.evaluate("pictures")
    assert pictures[0][0] == 0
    assert [0, 1, 1] in pictures
    shares = [look for rounds, scale, look in pictures if scale == 1]
    assert shares == sorted(shares, reverse=True)
    look = np.reshape(page.evaluate(FIRST_LOOK), (-1, 4))
    cover = look[:, 3:]
    assert np.sum(cover > 0.999) > 1000
    assert np.sum((cover > 0.1) & (cover < 0.9)) > 50  # edges are smooth
    # Four lobes of .125 under a radiance of 1.5.
    assert look[:, :3] == pytest.approx(0.75 * np.repeat(cover, 3, axis=1), rel=2e-3, abs=1e-6)
    wait_for_picture(page, 3)
    page.evaluate(SHARPENED)
    sharpened = np.reshape(page.evaluate(FIRST_LOOK), (-1, 4))
    assert sharpened.shape == look.shape
    assert np.abs(sharpened - look).max(axis=1).mean() < 0.002
    wait_for_picture(page, 3)
    page.evaluate("pictures.length = 0; rnaViewer.turnTable(0.3, true)")
    page.wait_for("pictures.length", TIMEOUT)
    assert page.evaluate("pictures.every(([rounds, , look]) => rounds === 0 && look === 1)")
    page.evaluate("rnaViewer.reset(), rnaViewer.chooseImage('studio'), rnaViewer.setGround(true)")
    drop(page, package)
    wait_for_picture(page, 3)
    assert page.evaluate("rnaViewer.viewer.shown.firstLook") == 0


@pytest.mark.parametrize("suffix", [".hdr", ".exr"])
def test_dropped_image_lights_the_asset(page, tmp_path, suffix):
    rows = np.full((4, 8, 3), 0.25, np.float32)
    rows[0, :, 0] = 2.0  # the zenith
    rows[:, 6, 2] = 1.0  # towards +x
    path = write_image(tmp_path / f"sky{suffix}", rows)
    drop(page, path)
    page.wait_for("rnaViewer.lighting.choice.startsWith('image-')", TIMEOUT)
    wait_for_picture(page, 3)
    floats = page.evaluate("[...rnaViewer.lighting.tables().floats]")
    actual = np.reshape(floats[: rows.size], rows.shape)  # texels come first
    np.testing.assert_allclose(actual, rows, rtol=0.01)
    page.evaluate("rnaViewer.lighting.choice = 'studio', rnaViewer.changed()")


def write_image(path: Path, rows: np.ndarray) -> Path:
    """An .exr, or an .hdr without compression; rows from the top."""
    if path.suffix == ".exr":
        import OpenEXR

        OpenEXR.File({}, {"RGB": rows}).write(str(path))
        return path
    mantissa, exponent = np.frexp(rows.max(axis=-1, keepdims=True))
    scaled = np.floor(rows * (mantissa * 256 / rows.max(axis=-1, keepdims=True)))
    pixels = np.concatenate([scaled, exponent + 128], axis=-1).astype(np.uint8)
    header = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {rows.shape[0]} +X {rows.shape[1]}\n"
    path.write_bytes(header.encode() + pixels.tobytes())
    return path


# Counts bytes of buffers that were not let go.
COUNT_BUFFERS = """
    globalThis.alive = 0;
    const device = rnaViewer.engine.device, make = device.createBuffer.bind(device);
    device.createBuffer = (description) => {
        const own = make(description), destroy = own.destroy.bind(own);
        let there = true;
        alive += description.size;
        own.destroy = () => { if (there) alive -= description.size; there = false; destroy(); };
        return own;
    };
"""
LOADS, SETTLED = 200, 20


def test_memory_is_flat_over_many_loads(page, package):
    page.evaluate(f"(() => {{ {COUNT_BUFFERS} }})()")
    file = FILE.format(data=base64_of(package), name="again.rna")
    page.evaluate(f"globalThis.again = {file}, 0")
    load = "(async () => { for (let k = 0; k < 10; k++) await rnaViewer.open(again); })()"
    readings = []
    for times in (SETTLED, LOADS - SETTLED):
        for _ in range(times // 10):
            page.evaluate(load)
        wait_for_picture(page, 3)  # whose size, and so its memory, is always the same
        page.call("HeapProfiler.collectGarbage")
        heap = page.call("Runtime.getHeapUsage")["usedSize"]
        readings.append((heap, page.evaluate("alive")))
    (heap, alive), (heap_after, alive_after) = readings
    assert alive_after == alive
    assert heap_after - heap < 4e6


def test_package_of_30_megabytes_is_read_in_ranges(tmp_path):
    tiers = make_tier("small"), make_tier("large", resolution=1118)
    path = make_tiny_package(tmp_path / "large.rna", *tiers)
    size = path.stat().st_size
    assert size > 30e6
    with viewer(site_for(path), "samples=1&pixel-ratio=1", 96, 64) as page:
        wait_for_picture(page, 1)
        assert page.evaluate("rnaViewer.opened.source.fetched") < 1e6
        page.evaluate("rnaViewer.switchTier('large')")
        wait_for_picture(page, 1)
        assert page.evaluate("rnaViewer.opened.source.fetched") < 1.02 * size


def test_page_without_any_gpu_shows_the_stand_in_and_one_line():
    with viewer(site_for(TOY), gpu=NO_GPU) as page:
        parts = "document.querySelector('rna-viewer').parts"
        page.wait_for(f"{parts}.image.naturalWidth > 0 && {parts}.loading.hidden", TIMEOUT)
        assert notice(page).startswith("WebGPU has no adapter here: no more than a stand-in")
        assert page.evaluate(f"[rnaViewer.failures, {parts}.poster.hidden]") == [1, True]
        fetched = "performance.getEntriesByType('resource').map((one) => one.transferSize)"
        assert page.evaluate(f"Math.max(...{fetched})") < TOY.stat().st_size / 2
