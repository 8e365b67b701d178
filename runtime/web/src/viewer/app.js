// The page: opens packages and images, and ties the panel, the pointer and the picture together.
import { Reader } from "../conformance.js";
import { openEngine } from "../engines.js";
import { sceneArrays } from "../geometry/scene_arrays.js";
import { evenImage } from "../light/environment.js";
import { readImage } from "../light/image_files.js";
import { NotSupported, PackageError } from "../package/errors.js";
import { Package } from "../package/package.js";
import { BlobSource, UrlSource } from "../package/source.js";
import { clamp, say, wrappedDegrees } from "../ui/elements.js";
import { listen } from "../ui/pointer.js";
import { compose, sharedFiles, rayKernels } from "../webgpu/sources.js";
import { Lighting } from "./lighting.js";
import { Orbit } from "./orbit.js";
import { fileAddress } from "./parameters.js";
import { Panel } from "./panel.js";
import { beforeFilmic } from "./view_transform.js";
import { BACKDROP, Viewer } from "./viewer.js";

const MOST_PIXELS = 2.2e6;  // of the picture, whatever the screen: memory of phones

export class App {
  /** parameters: of the address. labels: what people call a file of this page, by its name. */
  constructor(parameters, labels = {}) {
    Object.assign(this, { parameters, labels, orbit: new Orbit(), lighting: new Lighting(), opened: null, loading: null });
    this.panel = new Panel(this);
    this.places = { view: document.getElementById("view") };
    new ResizeObserver(() => this.resize()).observe(this.places.view);
    this._listenForDrops();
  }

  /** The engine and an empty picture; packages that load meanwhile wait for it. */
  begin() {
    this.begun = this._begin();
    this.begun.catch((error) => this._failed(error, "engine"));
    return this.begun;
  }

  async _begin() {
    const newCanvas = () => Object.assign(document.createElement("canvas"), {
      tabIndex: 0, role: "application", ariaLabel: "The asset. Arrow keys orbit.",
    });
    const { engine, canvas, reasons } = await openEngine(newCanvas, this.parameters.get("api"));
    Object.assign(this, { engine, canvas });
    canvas.setAttribute("aria-describedby", "keys");
    this.places.view.replaceChildren(canvas);
    engine.onlost = (why) => this._recover(why);
    this.viewer = new Viewer(engine, canvas, this.orbit);
    if (this.parameters.has("rounds")) this.viewer.rounds = Number(this.parameters.get("rounds"));
    if (this.parameters.get("jitter") === "0") this.viewer.jitter = 0;
    if (this.parameters.has("view")) this.setView(this.parameters.get("view"));
    this.viewer.addEventListener("shown", () => this.panel.showStats(this.viewer.stats));
    this.viewer.addEventListener("failed", ({ error }) => this._failed(error, "asset"));
    performance.mark("engine");
    listen(canvas, this._actions());
    this.panel.showEngine(engine.constructor.label, reasons);
    this.resize();
  }

  /** An asset is on its way: no word on how to bring one. */
  expectAsset(coming = true) {
    document.body.classList.toggle("expecting", coming);
  }

  /** Shows the package at an address, or in a File. */
  async open(from) {
    this.loading?.abort();
    const loading = (this.loading = new AbortController());
    this.expectAsset();
    try {
      say(null, false, "asset");
      const source = from instanceof Blob
        ? new BlobSource(from, from.name)
        : await UrlSource.open(from, (got, all) => this.panel.showProgress(got, all), loading.signal, this.labels[from]);
      const opened = await Package.open(source);
      if (loading.signal.aborted) return;
      await this._showPoster(opened);
      await this._show(opened, this.parameters.get("tier"), true);
    } catch (error) {
      if (!loading.signal.aborted && error.name !== "AbortError") this._failed(error, "asset");
    } finally {
      if (this.loading === loading) {
        this.panel.showProgress(null);
        this.expectAsset(false);
      }
    }
  }

  /** Another tier of the package that is open. */
  async switchTier(name) {
    try {
      say(null, false, "asset");
      await this._show(this.opened, name, false);
    } catch (error) {
      this._failed(error, "asset");
    } finally {
      this.panel.showProgress(null);
    }
  }

  /** Camera, lights and asset of a scene, as rna-view hands them over; null if it cannot be read. */
  async openScene(url) {
    try {
      const scene = JSON.parse(new TextDecoder().decode(await fetched(url)));
      const { radiance, image } = scene.environment ?? {};
      if (radiance) scene.environment.key = this.lighting.add("The scene's", evenImage(radiance));
      if (image) {
        const label = this.labels[image] ?? image;
        scene.environment.key = this.lighting.add(label, readImage(await fetched(fileAddress(image)), image));
      }
      await this.begun;
      this.applyScene(scene);
      return scene;
    } catch (error) {
      this._failed(error, "scene");
      return null;
    }
  }

  async openImage(from, name) {
    try {
      say(null, false, "light");
      const buffer = from instanceof Blob ? await from.arrayBuffer() : await fetched(from);
      this.lighting.choice = this.lighting.add(this.labels[name] ?? name, readImage(buffer, name));
      this.panel.showLighting(this.lighting);
      this.changed();
    } catch (error) {
      this._failed(error, "light");
    }
  }

  /** Something about the light changed. */
  changed(moving = false) {
    if (!this.viewer) return;
    const { lights, irradiance } = this.lighting.lights();
    if (lights.some(({ kind }) => kind === "environment") && this.uploaded !== this.lighting.tables()) {
      this.uploaded = this.lighting.tables();
      this.engine.setEnvironment(this.uploaded);
    }
    this.viewer.lights = lights;
    this.viewer.ground = this._ground(irradiance);
    this.viewer.restart(moving);
  }

  resetView() {
    this.lighting.reset();
    this.orbit = this.viewer.orbit = Object.assign(this.orbit, { azimuth: 0.6, elevation: 0.35, fov: 30 });
    if (this.box) this.orbit.frame(this.box, this.canvas.width / this.canvas.height);
    if (this.sceneView) this.applyScene(this.sceneView);
    this.panel.showLighting(this.lighting);
    this.changed();
  }

  /** Camera and lights of a scene, as rna-view hands them over. */
  applyScene({ camera, suns, environment, ground, exposure, view }) {
    this.sceneView = { camera, suns, environment, ground, exposure, view };
    if (camera) this.orbit.lookFrom(camera.position, camera.look_at, camera.vertical_fov_deg);
    if (suns) this.lighting.suns = suns;
    if (environment) {
      this.lighting.choice = environment.key ?? this.lighting.choice;
      this.lighting.strength = environment.strength ?? 1;
      this.lighting.imageTurn = environment.rotation_deg ?? 0;
    }
    if (ground !== undefined) this.panel.setGround(ground);
    if (exposure !== undefined) this.setExposure(exposure);
    if (view && !this.parameters.has("view")) this.setView(view);
    this.panel.showLighting(this.lighting);
    this.changed();
  }

  setExposure(stops) {
    if (!this.viewer) return;
    this.viewer.exposure = stops;
    this.panel.showExposure(stops);
    this.viewer.show();
  }

  /** view: srgb or filmic, as in a scene file. */
  setView(view) {
    if (!this.viewer) return;
    this.viewer.view = view;
    this.panel.showView(view);
    if (this.viewer.ground) this.changed();  // it has the colour of the page
    this.viewer.show();
  }

  setDenoise(on) {
    this.viewer.denoise = on;
    this.viewer.show();
  }

  resize() {
    if (!this.viewer) return;
    const { clientWidth: w, clientHeight: h } = this.places.view;
    const ratio = Number(this.parameters.get("dpr")) || Math.min(devicePixelRatio, 2);
    const scale = Math.min(ratio, Math.sqrt(MOST_PIXELS / Math.max(1, w * h)));
    const width = Math.max(1, Math.round(w * scale)), height = Math.max(1, Math.round(h * scale));
    if (this.canvas.width === width && this.canvas.height === height) return;
    Object.assign(this.canvas, { width, height });
    this.viewer.restart();
  }

  /** The shaders, for the test that they are rna_gpu's. */
  get wgsl() {
    return { compose, sharedFiles, rayKernels };
  }

  /** Asks the engine without a picture: for the conformance kit. */
  reader() {
    this.viewer.pause();
    return new Reader(this.engine);
  }

  /** A PNG of the picture as it is now. */
  screenshot() {
    this.viewer.show();
    return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
  }

  async _show(opened, tier, isNew) {
    const shown = await opened.load(tier);
    opened.forget();
    performance.mark("package");
    await this.begun;
    if (isNew) this.viewer.hasShown = false;
    this.viewer.pause();
    const arrays = isNew ? sceneArrays(shown.parts) : this.arrays;
    performance.mark("hierarchy");
    await this.engine.setAsset(arrays, shown.parts);
    performance.mark("asset");
    Object.assign(this, { opened, shown, arrays, box: arrays.box });
    if (isNew) this.orbit.frame(this.box, this.canvas.width / this.canvas.height);
    if (isNew && this.sceneView) this.applyScene(this.sceneView);
    document.body.classList.add("loaded");
    this.panel.showPackage(opened, shown);
    this.viewer.stats.ms = 0;
    this.changed();
    this.viewer.start();
    this.viewer.addEventListener("shown", () => this.panel.showPoster(null), { once: true });
  }

  async _showPoster(opened) {
    try {
      this.panel.showPoster(await opened.posterImage());
    } catch {
      // A poster that is broken is a warning (spec, 10): the asset is shown without it.
    }
  }

  _ground(irradiance) {
    if (!this.panel.hasGround || !this.box) return null;
    const backdrop = this.viewer.view === "filmic" ? beforeFilmic(BACKDROP) : BACKDROP;
    const { min, max } = this.box, size = Math.hypot(...max.map((high, k) => high - min[k]));
    return {
      height: min[1] - 1e-4 * size, x: (min[0] + max[0]) / 2, z: (min[2] + max[2]) / 2, size: 2 * size,
      colour: backdrop.map((value, c) => (irradiance[c] > 0 ? value / irradiance[c] / 2 ** this.viewer.exposure : 0)),
    };
  }

  _actions() {
    const moved = (change) => (...values) => {
      change(...values);
      this.viewer.restart(values.at(-1) === true);
    };
    return {
      orbit: moved((x, y) => this.orbit.turn(x, y)),
      pan: moved((x, y) => this.orbit.pan(x, y)),
      zoom: moved((factor) => this.orbit.zoom(factor)),
      light: (x, y, moving) => {
        this.lighting.rotation = wrappedDegrees(this.lighting.rotation + (x * 180) / Math.PI);
        this.lighting.sunHeight = clamp(this.lighting.sunHeight + (y * 180) / Math.PI, -10, 90);
        this.panel.showLighting(this.lighting);
        this.changed(moving === true);
      },
      settle: () => this.viewer.moving && this.viewer.restart(),
      reset: () => this.resetView(),
    };
  }

  _listenForDrops() {
    const body = document.body;
    for (const name of ["dragenter", "dragover"]) {
      addEventListener(name, (event) => {
        event.preventDefault();
        body.classList.add("dropping");
      });
    }
    addEventListener("dragleave", () => body.classList.remove("dropping"));
    addEventListener("drop", async (event) => {
      event.preventDefault();
      body.classList.remove("dropping");
      for (const file of [...(event.dataTransfer?.files ?? [])]) await this.openFile(file);
    });
  }

  /** A file that was dropped or chosen: a package, or an image to light it with. */
  openFile(file) {
    if (/\.(hdr|pic|exr)$/i.test(file.name)) return this.openImage(file, file.name);
    return this.open(file);
  }

  async _recover(why) {
    const { shown, arrays } = this;
    say(`${why}; starting again`, true, "engine");
    this.viewer?.stop();
    this.uploaded = null;
    try {
      const { exposure, rounds, view, denoise } = this.viewer;
      await this.begin();
      this.viewer.hasShown = true;
      Object.assign(this.viewer, { exposure, rounds, view, denoise });
      if (shown) {
        await this.engine.setAsset(arrays, shown.parts);
        this.changed();
        this.viewer.start();
      }
      say(null, false, "engine");
    } catch (error) {
      this._failed(error, "engine");
    }
  }

  /** about: what the line stands for until that works; see say. */
  _failed(error, about = "page") {
    const known = error instanceof PackageError || error instanceof NotSupported;
    if (!known) console.error(error);
    say(known ? error.message : `this did not work: ${error.message ?? error}`, false, about);
    this.failures = (this.failures ?? 0) + 1;
  }
}

async function fetched(url) {
  const answer = await fetch(url).catch(() => null);
  if (!answer?.ok) throw new NotSupported(`cannot load ${url}${answer ? `: HTTP ${answer.status}` : ""}`);
  return answer.arrayBuffer();
}
