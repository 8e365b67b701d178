"""Attributes that change after the picture is there, and those that cannot be used."""

import json

import pytest

from rna_sdk.package import query_width
from tests.package.builders import INPUTS, make_tiny_package
from tests.package.lobes import even_decoder, with_lobes
from tests.web.element_pages import SMALL, Static, line, loads, show
from tests.web.pages import TIMEOUT

pytestmark = pytest.mark.chromium

LOBES = query_width(INPUTS, 4) + 16


@pytest.fixture
def element(page, folder, url):
    """One element with lobes, whose first look is there."""
    make_tiny_package(folder / "plain.rna")
    with_lobes(folder / "plain.rna", folder / "lobes.rna", decoder=even_decoder(LOBES))
    scene = {"camera": {"position": [0, 0, 9], "look_at": [0, 0, 0], "vertical_fov_deg": 20}}
    (folder / "scene.json").write_text(json.dumps(scene))
    show(page, folder, url, f'<rna-viewer id="one" src="lobes.rna" {SMALL}></rna-viewer>')
    loads(page, "one")


@pytest.mark.usefixtures("element")
def test_what_samples_the_picture_can_change(page):
    sampling = "[one.stage.viewer.rounds, one.stage.viewer.jitter]"
    page.evaluate("one.samples = 3, one.jitter = 0")
    assert page.evaluate(sampling) == [3, 0]
    page.evaluate("one.stage.viewer.converged().then(() => 0)")
    assert page.evaluate("one.stage.viewer.stats.rounds") == 3
    page.evaluate("one.samples = null, one.jitter = null")
    assert page.evaluate(sampling) == [256, 1]
    looks = "one.stage.viewer.firstLights !== null"
    assert page.evaluate(looks)
    page.evaluate("one.firstLook = 'off', 0")
    page.wait_for(f"!({looks})", TIMEOUT)
    page.evaluate("one.firstLook = null, 0")
    page.wait_for(looks, TIMEOUT)
    page.evaluate("one.scene = 'scene.json', 0")
    page.wait_for("one.fieldOfView === '20deg'", TIMEOUT)
    page.evaluate("one.scene = null, 0")
    page.wait_for("one.fieldOfView === '30deg'", TIMEOUT)


@pytest.mark.usefixtures("element")
def test_a_tier_that_is_not_there_is_told(page):
    page.evaluate("Object.assign(one, { src: 'tiny.rna', tier: 'nope' }), 0")
    loads(page, "one", 2)
    assert page.evaluate("[one.tier, one.availableTiers]") == ["small", ["small", "hq"]]
    assert line(page) == 'tier: expected small or hq, found "nope"'
    page.evaluate("one.tier = 'hq', 0")
    page.wait_for("one.stage.shown.name === 'hq'", TIMEOUT)
    assert line(page) is None
    page.evaluate("one.tier = null, 0")
    page.wait_for("one.stage.shown.name === 'small'", TIMEOUT)


@pytest.mark.usefixtures("element")
def test_a_tier_that_is_set_while_the_package_loads(page):
    page.evaluate(
        """(() => {
            const { stage } = one, show = stage._show;
            stage._show = function (...given) {
                delete stage._show;
                one.tier = "hq";
                return show.apply(stage, given);
            };
            one.src = "tiny.rna";
            return 0;
        })()"""
    )
    page.wait_for("one.stage.shown?.name === 'hq'", TIMEOUT)


@pytest.mark.usefixtures("element")
def test_the_same_address_is_tried_again_after_a_failure(page, folder):
    wrong = {"src": "later.rna", "environment": "later.hdr", "scene": "later.json"}
    page.evaluate(f"Object.assign(one, {json.dumps(wrong)}), 0")
    page.wait_for("count('error', 'one') === 3", TIMEOUT)
    (folder / "later.rna").write_bytes((folder / "tiny.rna").read_bytes())
    Static.requested.clear()
    page.evaluate("one.src = one.src, 0")
    loads(page, "one", 2)
    page.evaluate(f"Object.assign(one, {json.dumps(wrong)}), 0")
    page.wait_for("count('error', 'one') === 5", TIMEOUT)
    assert [path for path in Static.requested if path.startswith("/later")].count("/later.rna") == 1


@pytest.mark.usefixtures("element")
def test_without_an_address_there_is_no_asset(page):
    page.evaluate("one.src = null, 0")
    assert page.evaluate("[one.loaded, one.availableTiers, one.stage.shown]") == [False, [], None]
    assert page.evaluate("one.toBlob()") is None
    page.wait_for("one.stage.engine", TIMEOUT)
    assert page.evaluate("[one.stage.viewer.shown, one.stage.shown]") == [None, None]
    page.evaluate("one.src = 'tiny.rna', 0")
    loads(page, "one", 2)
    page.evaluate("one.src = 'lobes.rna', one.src = null, 0")
    page.wait_for("one.stage.engine && !one.stage.loading", TIMEOUT)
    assert page.evaluate("[one.loaded, one.stage.shown]") == [False, None] and line(page) is None


def test_a_tint_that_is_no_colour_by_itself_is_told(page, folder, url):
    show(page, folder, url, '<rna-viewer id="one" hidden tint="crimson"></rna-viewer>')
    assert page.evaluate("one.settings.tint") == pytest.approx([0.716, 0.007, 0.045], abs=1e-3)
    for text in ("var(--accent)", "inherit", "currentcolor", "transparent", "crimsom"):
        page.evaluate(f"one.tint = '{text}', 0")
        expected = f'expected a colour, or R G B of linear light, as 1 0.5 0.2, found "{text}"'
        assert line(page) == f"tint: {expected}"


def test_a_property_takes_what_it_gives(page, folder, url):
    """As its types say: text or a number."""
    given = {
        "tint": "crimson",
        "maps": "label=label-de.png",
        "minCameraOrbit": "auto 10deg auto",
        "maxFieldOfView": "60deg",
        "rotationPerSecond": "20deg",
        "autoRotateDelay": 100,
        "alt": "",
        "touchAction": "none",
        "cameraControls": True,
    }
    show(page, folder, url, '<rna-viewer id="one" hidden></rna-viewer>')
    for name, value in given.items():
        page.evaluate(f"one.{name} = {json.dumps(value)}, 0")
        assert page.evaluate(f"one.{name}") == value
        assert line(page) is None
    page.evaluate("one.tint = 'no colour', 0")
    assert page.evaluate("one.tint") is None


def test_false_is_off(page, folder, url):
    """Vue and Svelte write "false"; any other text is on, as in HTML."""
    attributes = 'auto-rotate="false" camera-controls="true" ground=""'
    show(page, folder, url, f'<rna-viewer id="one" hidden {attributes}></rna-viewer>')
    is_on = "[one.autoRotate, one.cameraControls, one.ground, one.skybox, one.settings.autoRotate]"
    assert page.evaluate(is_on) == [False, True, True, False, False]
    page.evaluate("one.autoRotate = true, 0")
    assert page.evaluate("[one.autoRotate, one.getAttribute('auto-rotate')]") == [True, ""]
