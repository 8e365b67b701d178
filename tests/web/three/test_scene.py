"""An asset in a scene of three.js: how it is loaded, its picture, what it leaves behind."""

import shutil
from pathlib import Path

import numpy as np
import pytest

from tests.render.chromium import Page
from tests.web.pages import TIMEOUT
from tests.web.three.pages import REPOSITORY, TOY, installed, opened

pytestmark = pytest.mark.chromium

KIT = REPOSITORY / "spec" / "conformance" / "packages"
TINY = KIT / "surface-tiny.rna"
TWO_TIERS = KIT / "surface-float32.rna"
STRANDS = KIT / "fiber-float16.rna"
SIZE = [96, 60]


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    """A page with the module, a renderer and packages beside it."""
    folder = tmp_path_factory.mktemp("scene")
    installed(folder)
    for path in (TOY, TINY, TWO_TIERS, STRANDS, Path(__file__).parent / "page.html"):
        shutil.copy(path, folder)
    with opened(folder, "page.html", *SIZE) as page:
        page.wait_for("!!globalThis.test", TIMEOUT)
        yield page


def run(page: Page, body: str):
    """What an async function of this body returns."""
    return page.evaluate(
        f"(async () => {{ const {{ THREE, rna, renderer, picture }} = test; {body} }})()"
    )


def test_loader_has_the_manners_of_three(page):
    heard = run(
        page,
        """
        const heard = [], hear = (what) => () => heard.push(what);
        const manager = new THREE.LoadingManager(hear("all"), undefined, hear("bad"));
        const loader = new rna.RnaLoader(manager);
        const url = "surface-tiny.rna", progress = ({ loaded }) => heard.push(loaded > 0);
        const asset = await loader.loadAsync(url, progress);
        const parsed = await loader.parseAsync(await (await fetch(url)).arrayBuffer());
        const wrong = await loader.loadAsync("page.html").catch((error) => error.message);
        const missing = await loader.loadAsync("none.rna").catch((error) => error.message);
        await new Promise((resolve) => setTimeout(resolve, 100));
        const group = asset instanceof THREE.Group;
        return { heard, wrong, missing, tiers: [asset.tiers, parsed.tiers], group };
        """,
    )
    events = heard["heard"]
    first = events.index("all")
    assert first > 0 and all(
        event is True for event in events[:first]
    )  # progress, then all is there
    assert "bad" in events[first:]
    assert heard["group"] and heard["tiers"][0] == heard["tiers"][1]
    assert "404" in heard["missing"] and heard["wrong"].endswith("]")  # with an issue code


def test_abort_rejects(page):
    aborted = run(
        page,
        """
        const loader = new rna.RnaLoader();
        const pending = loader.loadAsync("toy.rna").catch((error) => error.name);
        loader.abort();
        return pending;
        """,
    )
    assert aborted == "AbortError"


@pytest.mark.parametrize("name", ["surface-float32.rna", "fiber-float16.rna"])
def test_raycaster_meets_the_asset(page, name):
    """Hits of three.js' own search lie on the drawn asset and its instances."""
    actual = run(
        page,
        f"""
        const asset = await new rna.RnaLoader().loadAsync("{name}"), [mesh] = asset.meshes;
        const [many] = asset.instanced(2), {{ center, radius }} = asset.content.sphere;
        const away = new THREE.Matrix4().makeTranslation(100 * radius, 0, 0);
        many.setMatrixAt(0, away);
        many.setMatrixAt(1, new THREE.Matrix4());
        asset.updateMatrixWorld();
        const rays = [];
        for (let k = 0; k < 400; k++) {{
          const from = new THREE.Vector3(Math.cos(2.4 * k), Math.sin(2.4 * k), 2 - k / 100);
          const target = new THREE.Vector3(Math.sin(k), Math.cos(3 * k), 0);
          const direction = target.multiplyScalar(radius / 2).addScaledVector(from, -3 * radius);
          const origin = center.clone().addScaledVector(from, 3 * radius);
          const ray = new THREE.Raycaster(origin, direction.normalize()), theirs = [];
          THREE.Mesh.prototype.raycast.call(mesh, ray, theirs);
          theirs.sort((a, b) => a.distance - b.distance);
          const [ours] = ray.intersectObject(mesh), [other] = ray.intersectObject(many);
          rays.push([theirs[0]?.distance, ours?.distance, other?.distance].map((one) => one ?? 0));
          if (ours && other?.instanceId !== 1) throw new Error("another instance");
        }}
        asset.position.x = 100;
        asset.updateMatrixWorld();
        const ray = new THREE.Raycaster(center.clone().setZ(10), new THREE.Vector3(0, 0, -1));
        return [rays, radius, ray.intersectObject(asset).length];
        """,
    )
    theirs, ours, instance = np.transpose(actual[0])
    assert actual[2] == 0 and np.sum(ours > 0) > 20
    assert np.array_equal(ours, instance)
    if name.startswith("surface"):
        assert ours == pytest.approx(theirs, abs=1e-4 * actual[1])
    else:  # the box about a strand is wider than the strand
        assert np.all(theirs[ours > 0] > 0)
        assert np.all(ours[ours > 0] > theirs[ours > 0] - 1e-4 * actual[1])


TWO_TIERS_SEEN = """
    const asset = await new rna.RnaLoader().loadAsync("surface-float32.rna");
    const [small, hq] = asset.content.data.tiers, { sphere } = asset.content;
    const rows = [{ height: 64, flip: 0.2 }, { height: 8, flip: 0.01 }];
    Object.assign(small, { work: 1, validation: { flip: 0.2, flipAtHeight: rows } });
    Object.assign(hq, { work: 2, validation: { flip: 0.01 } });
    asset.scale.setScalar(0.2 / sphere.radius);
    const seen = async (radii, more = {}) => {
      const middle = sphere.center.clone().multiply(asset.scale);
      const position = middle.clone().addScalar((0.2 * radii) / Math.sqrt(3)).toArray();
      const view = { position, lookAt: middle.toArray(), ...more };
      return [await picture(asset, 96, 60, view), asset.shown];
    };
"""


def test_clones_have_what_the_page_added(page):
    """And each is disposed of once, however often it is asked for."""
    actual = run(
        page,
        TWO_TIERS_SEEN
        + """
        const [mesh] = asset.meshes;
        const mark = new THREE.Object3D(), label = new THREE.Object3D();
        asset.add(Object.assign(label, { name: "label" }));
        mesh.add(Object.assign(mark, { name: "mark" }));
        asset.userData.article = 7;
        Object.assign(mesh, { renderOrder: 5, userData: { k: 2 } }).layers.set(1);
        mesh.position.y = 2;
        asset.tier = "hq";
        const scene = new THREE.Scene();
        scene.add(asset);
        const [copy] = scene.clone().children, [own] = copy.meshes, bare = asset.clone(false);
        const names = ({ children }) => children.map(({ name }) => name);
        const facts = [
          names(copy).at(-1), names(own), copy.userData, own.userData, own.renderOrder,
          own.layers.mask, own.position.y, copy.tier, bare.children.length, own.children.length,
        ];
        mesh.layers.set(0);
        mesh.position.y = 0;
        const [before] = await seen(4), material = mesh.material.clone();
        mesh.material = material;
        const [after] = await seen(4);
        copy.dispose();
        copy.dispose();
        bare.dispose();
        const left = asset.content.users.size;
        asset.dispose();
        return [facts, left, material.type, material.stored.length, before === after];
        """,
    )
    facts = ["label", ["mark"], {"article": 7}, {"k": 2}, 5, 2, 2]
    assert actual[0] == [*facts, "hq", 1, 1]
    assert actual[1:] == [1, "RnaMaterial", 0, True]


def test_what_cannot_be_is_said_at_once(page):
    said = run(
        page,
        """
        const asset = await new rna.RnaLoader().loadAsync("surface-float32.rna");
        const said = (action) => { try { action(); } catch (error) { return error.message; } };
        const options = [{ visibility: "ray" }, { environmentSamples: -3 }, { nonsense: 1 }];
        return [
          ...options.map((given) => said(() => new rna.RnaLoader().setOptions(given))),
          said(() => { asset.tier = "nope"; }), asset.tier,
        ];
        """,
    )
    assert said[0] == 'visibility: expected "rays" or "shadow-map", found "ray"'
    assert said[1] == "environmentSamples: expected a whole number from 1 to 64, found -3"
    assert said[2].startswith("rna-three has no option nonsense; there are visibility")
    assert said[3].endswith('found "nope"') and said[4] == "auto"


def test_loader_in_a_worker(page):
    """It has no document; three.js' own loaders work there, too."""
    asset = run(
        page,
        """
        const source = `import { RnaLoader } from "rna-three";
          const asset = await new RnaLoader().loadAsync(name);
          postMessage([asset.name, asset.meshes.length]);`;
        const map = JSON.parse(document.querySelector("[type=importmap]").textContent).imports;
        const at = (name) => JSON.stringify(new URL(map[name], document.baseURI).href);
        const module = await (await fetch(map["rna-three"])).text();
        const whole = ["three/webgpu", "three/tsl"].reduce(
          (text, name) => text.replaceAll(JSON.stringify(name), at(name)), module);
        const blob = (text) => URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
        const name = JSON.stringify(new URL("surface-tiny.rna", document.baseURI).href);
        const worker = new Worker(
          blob(source.replace('"rna-three"', JSON.stringify(blob(whole))).replace("name", name)),
          { type: "module" });
        return new Promise((resolve, reject) => {
          worker.onmessage = ({ data }) => resolve(data);
          worker.onerror = ({ message }) => reject(message);
        });
        """,
    )
    assert asset[1] == 1


def test_a_distant_asset_takes_the_cheaper_tier(page):
    """Heights and errors as a package records them; the height is that of the picture before."""
    shown = run(
        page,
        TWO_TIERS_SEEN
        + """
        const found = [];
        for (const radii of [4, 40, 4]) {
          await seen(radii);
          found.push(await seen(radii));
        }
        asset.tier = "small";
        found.push(await seen(4));
        asset.dispose();
        const [near, , again, forced] = found.map(([pixels]) => pixels);
        return [found.map(([, tier]) => tier), near === again, near === forced];
        """,
    )
    assert shown == [["hq", "small", "hq", "small"], True, False]


def test_shadow_maps_do_not_choose_the_tier(page):
    """A map of 1024 rows, whose camera is orthographic; from the first picture on."""
    shown = run(
        page,
        TWO_TIERS_SEEN
        + """
        const drawn = new Set(), shown = [];
        const [mesh] = asset.meshes, { onBeforeRender } = mesh;
        mesh.onBeforeRender = (...given) => {
          drawn.add(given[4].uuid);
          onBeforeRender(...given);
        };
        const light = test.shadowingSun();
        for (let k = 0; k < 3; k++) shown.push((await seen(40, { lights: [light] }))[1]);
        asset.dispose();
        light.dispose();
        return [shown, drawn.size, light.shadow.map !== null];
        """,
    )
    assert shown == [["small"] * 3, 1, True]


def test_dispose_leaves_no_memory(page):
    """After the first times, in which three.js makes what it keeps: nothing is compiled anew."""
    totals = run(
        page,
        """
        const totals = [], { memory } = renderer.info, { device } = renderer.backend;
        let pipelines = 0;
        for (const name of ["createRenderPipeline", "createRenderPipelineAsync"]) {
          device[name] = (given) => {
            pipelines += 1;
            return Object.getPrototypeOf(device)[name].call(device, given);
          };
        }
        for (let k = 0; k < 4; k++) {
          const asset = await new rna.RnaLoader().loadAsync("surface-tiny.rna");
          const copy = asset.clone();
          await picture(asset, 8, 8);
          asset.dispose();
          copy.dispose();
          const { total, storageAttributes, attributes, uniformBuffers, programs } = memory;
          const objects = { total, storageAttributes, attributes, uniformBuffers, programs };
          totals.push({ ...objects, pipelines });
        }
        return totals;
        """,
    )
    assert totals[1:] == [totals[1]] * 3
