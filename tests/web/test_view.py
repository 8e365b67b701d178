"""What the viewer makes of its samples: view transforms, less noise, a saved picture."""

import base64
import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rna_render.image.view_transform import to_display
from rna_view.site_source import site_for
from tests.render.chromium import Page
from tests.web.pages import TIMEOUT, picture, viewer, wait_for_picture

pytestmark = pytest.mark.chromium

TOY = Path(__file__).parents[2] / "examples" / "quickstart" / "toy.rna"
DATA_URL = """rnaViewer.screenshot().then((blob) => new Promise((resolve) => {
    const reader = new FileReader();
    reader.onload = () => resolve(reader.result.split(",")[1]);
    reader.readAsDataURL(blob);
}))"""


@pytest.fixture(scope="module")
def page():
    with viewer(site_for(TOY), "samples=1&first-look=off&pixel-ratio=1&ui=0", 96, 60) as page:
        wait_for_picture(page, 1)
        yield page


def canvas(page: Page) -> np.ndarray:
    """The picture on the screen: (h, w, 3), 0 to 255."""
    data = base64.b64decode(page.evaluate(DATA_URL))
    return np.asarray(Image.open(io.BytesIO(data)).convert("RGB"), np.float64)


def test_view_transforms_are_those_of_rna_run(page):
    page.evaluate("rnaViewer.setDenoise(false), rnaViewer.setExposure(2), 0")
    white = {}
    for view in ("srgb", "filmic"):
        page.evaluate(f"rnaViewer.setView('{view}'), 0")
        wait_for_picture(page, 1)
        actual = canvas(page)
        mean = picture(page)
        page.evaluate("rnaViewer.viewer.start(), 0")
        inside = mean[..., 3] == 1
        expected = 255 * to_display(mean[..., :3], view, 2.0)
        assert inside.sum() > 500
        np.testing.assert_allclose(actual[inside], expected[inside], atol=1.01)
        white[view] = np.mean(actual[inside] == 255)
    assert white["filmic"] < 0.5 * white["srgb"]
    page.evaluate("rnaViewer.setView('srgb'), rnaViewer.setExposure(0), 0")


def test_ground_has_the_colour_of_the_page_under_both(page):
    for view in ("filmic", "srgb"):
        page.evaluate(f"rnaViewer.setView('{view}'), 0")
        wait_for_picture(page, 1)
        corner = page.evaluate(
            "(() => { const [r, g, b] = rnaViewer.viewer.ground.colour, { irradiance } ="
            " rnaViewer.lighting.lights(); return [r, g, b].map((x, c) => x * irradiance[c]); })()"
        )
        shown = to_display(np.array(corner), view)
        np.testing.assert_allclose(
            shown, to_display(np.array([0.052, 0.056, 0.063]), "srgb"), atol=2e-3
        )


BOXES = [
    ([-0.2, 0.0, -0.2], [0.2, 0.8, 0.2]),
    ([-5.0, 0.0, -0.1], [5.0, 0.2, 0.1]),
    ([1.0, 1.0, 1.0], [3.0, 3.0, 3.0]),
]


@pytest.mark.parametrize("aspect", [0.5, 1.1, 1.8])
@pytest.mark.parametrize(("low", "high"), BOXES)
def test_a_box_is_framed_whole(page, low, high, aspect):
    """However it is turned, and as near as that goes."""
    box = f"{{min: {low}, max: {high}}}"
    cameras = page.evaluate(
        f"(() => {{ const orbit = new rnaViewer.orbit.constructor(); orbit.frame({box}, {aspect});"
        " const home = orbit.azimuth;"
        " return Array.from({ length: 16 }, (_, k) => { orbit.azimuth = home + k * Math.PI / 8;"
        f" return orbit.camera({aspect}, 1); }}); }})()"
    )
    corners = np.stack(np.meshgrid(*zip(low, high, strict=True)), axis=-1).reshape(8, 3)
    farthest = []
    for camera in cameras:
        rays = np.transpose([camera["corner"], camera["stepX"], camera["stepY"]])
        depth, x, y = np.linalg.solve(rays, (corners - camera["position"]).T)
        assert (depth > 0).all()
        places = np.array([x / depth / aspect, y / depth])  # shares of the width and the height
        farthest.append(np.abs(places - 0.5).max())
    assert max(farthest) == pytest.approx(0.475)


def test_first_samples_have_less_noise(page):
    wait_for_picture(page, 1)
    roughness = {}
    for on in ("false", "true"):
        page.evaluate(f"rnaViewer.setDenoise({on}), 0")
        roughness[on] = np.abs(np.diff(canvas(page), axis=1)).mean()
    assert roughness["true"] < 0.8 * roughness["false"]


def test_a_picture_is_saved_once_it_has_all_samples(page):
    page.evaluate(
        """(() => {
            globalThis.saved = [];
            HTMLAnchorElement.prototype.click = function () {
                saved.push([this.download, rnaViewer.viewer.stats.rounds]);
            };
            rnaViewer.viewer.rounds = 3;
            rnaViewer.viewer.restart();
            document.getElementById("screenshot").click();
        })()"""
    )
    assert page.evaluate("document.getElementById('screenshot').textContent").startswith("Save now")
    page.wait_for("saved.length", TIMEOUT)
    assert page.evaluate("saved[0][1]") == 3 and page.evaluate("saved[0][0]").endswith(".png")
    page.evaluate("rnaViewer.viewer.rounds = 100000, rnaViewer.viewer.restart(), 0")
    page.evaluate("document.getElementById('screenshot').click()")
    page.evaluate("document.getElementById('screenshot').click()")  # as it is now
    page.wait_for("saved.length === 2", TIMEOUT)
    page.evaluate("rnaViewer.viewer.rounds = 1, 0")


def test_a_cheaper_tier_is_named_where_this_one_is_slow(page):
    actual = page.evaluate(
        """(() => {
            const tiers = [["hq", 900], ["small", 100], ["tiny", 20], ["unknown"]].map(
                ([name, multiplyAdds]) => ({ name, cost: multiplyAdds && { multiplyAdds } }));
            const panel = rnaPanel, { opened, shown } = rnaViewer;
            const button = document.getElementById("faster");
            const own = [opened.manifest.tiers, shown.tier];
            const told = [];
            opened.manifest.tiers = tiers;
            for (const [ms, tier] of [[90, 0], [500, 0], [5000, 0], [500, 2], [500, 3]]) {
                shown.tier = tiers[tier];
                panel._suggestTier(ms);
                told.push(button.hidden ? null : panel.faster);
            }
            [opened.manifest.tiers, shown.tier] = own;
            return told;
        })()"""
    )
    assert actual == [None, "small", "tiny", None, None]


def test_the_picture_and_its_controls_have_names(page):
    named = page.evaluate(
        """(() => {
            const { canvas } = rnaViewer, root = canvas.getRootNode();
            const keys = root.getElementById(canvas.getAttribute("aria-describedby"));
            const inputs = [...document.querySelectorAll("input, select, button:not(#faster)")];
            const unnamed = inputs.filter((one) => !one.labels?.length && !one.textContent);
            const names = ["role", "aria-label"].map((name) => canvas.getAttribute(name));
            return [...names, keys.textContent, unnamed.map(({ id }) => id)];
        })()"""
    )
    assert named[0] == "application" and named[1] == "toy" and "pinch" in named[2]
    assert named[3] == []
