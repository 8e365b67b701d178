"""Pictures that are taken while samples are under way."""

import numpy as np
import pytest

from tests.web.element_pages import loads, show

pytestmark = pytest.mark.chromium

PIXELS = """(blob) => createImageBitmap(blob).then((image) => {
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    context.drawImage(image, 0, 0);
    return [...context.getImageData(0, 0, image.width, image.height).data];
})"""
TAKEN = f"""(async () => {{
    const {{ viewer, engine }} = one.stage, pixels = {PIXELS}, bands = viewer._band.bind(viewer);
    engine.bandPixels = 64 * 10;  // four bands a sample
    const first = Promise.withResolvers(), half = Promise.withResolvers();
    viewer._band = (camera, round, lights, from, to) => {{
        bands(camera, round, lights, from, to);
        if (viewer.shown === null) first.resolve(one.toBlob());
        // In the next microtask the band counts.
        const take = () => Promise.resolve().then(() => one.toBlob());
        if (viewer.stats.rounds === 1 && round === 1 && from === 10) half.resolve(take());
    }};
    viewer.restart();
    const blobs = [await first.promise, await half.promise];
    await viewer.converged();
    return Promise.all([...blobs, await one.toBlob()].map(pixels));
}})()"""


def test_pictures_while_samples_are_under_way(page, folder, url):
    """Before the first is there, and in the middle of the second of two, which have no noise."""
    light = 'environment-intensity="0" sun="20deg 45deg 2" jitter="0"'
    body = f'<rna-viewer id="one" src="tiny.rna" samples="2" pixel-ratio="1" {light}></rna-viewer>'
    show(page, folder, url, body)
    loads(page, "one")
    page.evaluate("one.stage.setDenoise(false), one.stage.viewer.converged().then(() => 0)")
    first, half, whole = np.reshape(page.evaluate(TAKEN), (3, 40, 64, 4)).astype(int)
    assert np.sum(whole[:20, :, :3] < 250) > 150  # the asset is in the rows that have two samples
    assert np.max(np.abs(half - whole)) <= 1
    assert np.sum(first[:, :, :3] < 250) > 150 and np.all(first[0, 0] == 255)  # coarse, not blank
