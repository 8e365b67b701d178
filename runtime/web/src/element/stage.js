// An asset on a canvas: engine, package, camera and lights, and what becomes of them where one fails. It tells what
// happens by events; a page's panel and the element listen.
import { nearestHit } from "../geometry/nearest_hit.js";
import { sceneArrays } from "../geometry/scene_arrays.js";
import { evenImage } from "../light/environment.js";
import { readImage } from "../light/image_files.js";
import { NotSupported } from "../package/errors.js";
import { fileAddress } from "../package/file_address.js";
import { otherFile } from "../package/other_files.js";
import { readGlass } from "../package/glass.js";
import { pictureOf } from "../package/images.js";
import { Package } from "../package/package.js";
import { BlobSource, nameOf, UrlSource } from "../package/source.js";
import { finished } from "../steps.js";
import { wrappedDegrees } from "../ui/elements.js";
import { Glide } from "./glide.js";
import { rayThrough } from "./hotspots.js";
import { LastingEngine } from "./lasting_engine.js";
import { Lighting } from "./lighting.js";
import { limitsOf, Orbit, viewFrom } from "./orbit.js";
import { StandIn } from "./stand_in.js";
import { beforeFilmic } from "./view_transform.js";
import { SHARP } from "./viewer.js";

const DECAY_MS = 50;  // of the way of a camera that glides

/**
 * Events: "engine"; "loading", "progress" (got, all), "package", "load", "ended", of an asset; "shown", of a picture;
 * "camera" and "light" (byUser), "set" of any control; "canvas", another one; "stand-in", there or gone; "failed" (error, about).
 */
export class Stage extends LastingEngine {
  constructor(place, notices, settings) {
    super(place, notices, settings);
    Object.assign(this, { orbit: new Orbit(), lighting: new Lighting(), labels: {}, ground: false, scene: null, isTouched: false, isStill: false });
    this.glide = new Glide(this);
    this.standIn = new StandIn(this);
    Object.assign(this, { opened: null, shown: null, loading: null, lit: Promise.resolve(), placing: Promise.resolve() });
    Object.assign(this, { isWhole: false, arrived: null });
  }

  /** Lets the GPU go; begin() takes up what was shown. */
  close() {
    this.loading?.abort();
    this.requestedScene = null;
    this.end();
    this.standIn.end();
  }

  /** With the stand-in of what was shown until then. */
  replace() {
    this.isWhole = false;
    const begun = super.replace();
    this.standIn.again();
    return begun;
  }

  _giveUp(error) {
    this.isWhole = false;
    super._giveUp(error);
    if (this.standIn.isShown) this.mount(document.createElement("canvas"));  // for gestures
    else this.standIn.again(!this.loading);  // while a package loads, `open` does
  }

  /** The picture once more: see Viewer.restart. */
  restart(moving, coarsest) {
    this.standIn.draw();
    if (moving && this.standIn.isShown) this.viewer?.hold();
    else this.viewer?.restart(moving, coarsest);
  }

  rest(on) {
    super.rest(on);
    this.standIn.draw();
  }

  /** Lets asset and GPU go; begin() starts without an asset. */
  clear() {
    this.close();
    this.standIn.forget();
    Object.assign(this, { opened: null, shown: null, arrays: null, box: undefined, canvas: null });
    this.place.replaceChildren();
    this.notices.say(null, false, "asset");
  }

  /** Shows the package at an address, or in a File. */
  async open(from) {
    this.loading?.abort();
    const loading = (this.loading = new AbortController()), { signal } = loading;
    try {
      this.notices.say(null, false, "asset");
      this.emit("loading");
      this.notices.say(null, true, "glass");
      const address = from instanceof Blob ? null : this.settings.glass, glass = address && this._readGlass(address);
      const progress = (got, all) => signal.aborted || this.emit("progress", { got, all });
      const source = from instanceof Blob
        ? new BlobSource(from, from.name)
        : await UrlSource.open(from, progress, signal, this.labels[nameOf(from)]);
      const opened = Object.assign(await Package.open(source), { glass });
      signal.throwIfAborted();
      const wanted = this.settings.tier, tier = this._known(opened, wanted), print = this.settings.variantName;
      opened.variant = this._knownVariant(opened, print);
      this.isWhole = false;
      const standing = this.standIn.show(opened);
      if (opened.environment && this._wantsLobes(opened)) this.lit.then(() => this.lighting.prepare());
      if (await this.begun) opened.prefetch(tier, this._wantsLobes(opened));
      await this._offerPoster(opened);
      if (!(await this.begun)) await standing.then(() => this.standIn.again(true));
      await this._show(opened, tier, true, signal);
      if (this.settings.tier !== wanted) await this._show(opened, this._known(opened, this.settings.tier), false, signal);
      if (this.settings.variantName !== print) await this.switchVariant(this.settings.variantName);
      await standing;
    } catch (error) {
      if (!signal.aborted) this.failed(error, "asset");
    } finally {
      if (this.loading === loading) {
        this.loading = null;
        this.emit("ended");
      }
    }
  }

  /** The glass at an address, of readGlass; null, with a line, where it cannot be read. */
  async _readGlass(address) {
    try {
      return readGlass(new Uint8Array(await fetched(address)), this.labels[nameOf(address)] ?? nameOf(address));
    } catch (error) {
      this.notices.say(`glass: ${error.message}`, true, "glass");
      return null;
    }
  }

  /** Lobes know nothing of glass. */
  _wantsLobes({ glass }) {
    return this.settings.firstLook !== "off" && !glass;
  }

  /** Another tier of the package that is open, or the same with what the settings want of it; null: the first. */
  async switchTier(name) {
    try {
      this.notices.say(null, false, "asset");
      await this._show(this.opened, this._known(this.opened, name), false);
    } catch (error) {
      this.failed(error, "asset");
    } finally {
      this.emit("ended");
    }
  }

  /** Another variant of the package that is shown; null: its own print. */
  async switchVariant(name) {
    const { opened, arrays } = this, chosen = (opened.variant = this._knownVariant(opened, name));
    const isWanted = () => opened === this.opened && opened.variant === chosen;
    try {
      const prints = await opened.prints(this.shown.parts);
      if (isWanted()) await finished(arrays.surfaces.reprint(prints));
      if (!isWanted()) return;
      arrays.maps = {};  // they are on the print before
      this._printed();
      await this.print();
      arrays.variant = chosen;
    } catch (error) {
      this.failed(error, "asset");
    }
  }

  /** The name of a variant that the package has, else null and a line. */
  _knownVariant({ variants }, name) {
    const isThere = name === null || variants.includes(name);
    const there = variants.map((one) => JSON.stringify(one)).join(" or ") || "none: it has no variants";
    this.notices.say(isThere ? null : `variant-name: expected ${there}, found ${JSON.stringify(name)}`, true, "variant-name");
    return isThere ? name : null;
  }

  /** The name of a tier that the package has, else null and a line. */
  _known({ manifest }, name) {
    const names = manifest.tiers.map((tier) => tier.name), isThere = name === null || names.includes(name);
    this.notices.say(isThere ? null : `tier: expected ${names.join(" or ")}, found ${JSON.stringify(name)}`, true, "tier");
    return isThere ? name : null;
  }

  /** Camera, lights and asset of a scene, as rna-view hands them over. The result tells whether it is still wanted. */
  async openScene(url) {
    const request = (this.requestedScene = {});
    try {
      const scene = readScene(await fetched(url), url);
      const { radiance, image } = scene.environment ?? {};
      const beside = (name) => new URL(fileAddress(name), new URL(url, document.baseURI)).href;
      if (scene.asset) scene.asset = beside(scene.asset);
      if (radiance) scene.environment.key = this.lighting.add("The scene's", evenImage(radiance));
      if (image) {
        const label = this.labels[image] ?? image;
        scene.environment.key = this.lighting.add(label, readImage(await fetched(beside(image)), image));
      }
      if (request !== this.requestedScene) return false;
      this.scene = scene;
      this.reset();
    } catch (error) {
      if (request !== this.requestedScene) return false;
      this.failed(error, "scene");
    }
    return true;
  }

  /** Another picture in place of the asset's images with that label; null: the package's own. Throws where there is none. */
  async setMap(label, source) {
    const { surfaces } = this.arrays ?? {}, labels = surfaces?.labels ?? [];
    if (!labels.includes(label)) {
      throw new Error(`expected ${labels.join(" or ") || "an asset with base colour"}, found ${JSON.stringify(label)}`);
    }
    await surfaces.setImage(label, source && (await pictureOf(source)));
    this._printed();
  }

  /** Images and tint as the attributes have them; those that are gone are the package's again. */
  async print() {
    const { arrays, settings: { maps, tint } } = this, wanted = maps ?? {};
    if (!arrays?.hasBaseColor) return this.notices.say(maps || tint ? "maps, tint: this asset has no base colour" : null, true, "maps");
    if (!maps && !tint && !arrays.maps) return;  // as it came
    arrays.surfaces.tint = tint ?? [1, 1, 1];
    this._printed();
    try {
      for (const label of Object.keys(arrays.maps ?? {}).filter((name) => !(name in wanted))) await this.setMap(label, null);
      for (const [label, address] of Object.entries(wanted)) {
        if (arrays.maps?.[label] !== address) await this.setMap(label, new Blob([await fetched(address)]));
      }
      this.notices.say(null, true, "maps");
    } catch (error) {
      this.notices.say(`maps: ${error.message}`, true, "maps");
    }
    arrays.maps = wanted;
  }

  _printed() {
    Object.assign(this.arrays, this.arrays.surfaces.arrays());
    this.engine?.setSurfaces(this.arrays);
    this.restart();
  }

  leaveScene() {
    this.requestedScene = this.scene = null;
    this.reset();
  }

  /** Lights the asset with an image; one that comes before the asset is waited for. */
  openImage(from, name) {
    return (this.lit = this._openImage(from, name));
  }

  async _openImage(from, name) {
    const request = (this.requestedImage = {});
    try {
      this.notices.say(null, false, "light");
      const buffer = from instanceof Blob ? await from.arrayBuffer() : await fetched(from);
      if (request !== this.requestedImage) return;
      this.setLight({ choice: this.lighting.add(this.labels[name] ?? name, readImage(buffer, name)) });
    } catch (error) {
      if (request === this.requestedImage) this.failed(error, "light");
    }
  }

  /** Lights the asset with an image that is there; one on its way is no longer wanted. */
  chooseImage(key) {
    this.requestedImage = null;
    this.setLight({ choice: key });
  }

  /** values: of Lighting's fields. moving: more will follow at once. */
  setLight(values, { moving = false, byUser = false } = {}) {
    Object.assign(this.lighting, values);
    this.emit("set");
    this.emit("light", { byUser });
    this.changed(moving);
  }

  /** Something about the light changed. moving, coarsest: see Viewer.restart. */
  changed(moving = false, coarsest = undefined) {
    if (!this.viewer) return this.standIn.draw();
    if (this.engine.hasLobes && !this.lighting.isPrepared) return void this.lighting.prepare().then(() => this.changed(moving, coarsest));
    const { lights, irradiance } = this.lighting.lights();
    if (lights.some(({ kind }) => kind === "environment") && this.uploaded !== this.lighting.tables()) {
      this.uploaded = this.lighting.tables();
      this.engine.setEnvironment(this.uploaded);
    }
    const sky = this.settings.skybox && lights.find(({ kind }) => kind === "environment");
    this.viewer.sky = sky ? { strength: sky.colour[0], angle: sky.angle } : null;
    this.viewer.lights = lights;
    this.viewer.firstLights = this.engine.hasLobes ? this.lighting.firstLights() : null;
    this.viewer.ground = this._ground(irradiance);
    this.restart(moving, coarsest);
  }

  /** Camera and lights as the scene and the attributes have them, which go before it. */
  reset() {
    const { ground, exposure, view } = this.scene ?? {}, { settings } = this;
    this.placeCamera();
    this.placeLights();
    this.ground = settings.ground ?? ground ?? this.ground;
    this.setExposure(settings.exposure ?? exposure ?? this.look.exposure);
    this.setView(settings.viewTransform ?? view ?? this.look.view);
  }

  placeCamera() {
    const { position, look_at, vertical_fov_deg } = this.scene?.camera ?? {}, { settings } = this;
    const views = [
      position ? viewFrom(position, look_at, vertical_fov_deg) : {}, settings.cameraOrbit ?? {},
      { target: settings.cameraTarget, fov: settings.fieldOfView },
    ];
    this.isTouched = false;
    this.glide.stop();
    this.orbit.limits = limitsOf(settings);
    const { width, height } = this.size;
    this.orbit.place(views, this.box, width / height);
    this.emit("camera", { byUser: false });
    this.restart();
  }

  /** Moves the camera by `place`; it glides there where it is seen. */
  glideTo(place) {
    if (!this.standIn.isShown && (!this.viewer?.hasShown || this.isNew)) return place();
    this.glide.to(place, this.isStill ? 0 : this.settings.interpolationDecay ?? DECAY_MS);
  }

  /** The view that the camera has, or glides to. */
  get view() {
    return this.glide.goal ?? this.orbit;
  }

  /** The camera where it is, if the settings still allow that. */
  limitCamera() {
    this.glide.stop();
    this.orbit.limits = limitsOf(this.settings);
    this.orbit.limit();
    this.emit("camera", { byUser: false });
    this.restart();
  }

  /** Where the asset is at a place of the picture, shares of its width and height: { position, normal }, or null. */
  hitAt(x, y) {
    const { shownCamera: camera, hitArrays } = this;
    return camera && hitArrays ? nearestHit(hitArrays, camera.position, rayThrough(camera, x, y)) : null;
  }

  /** Of the picture that is seen. */
  get shownCamera() {
    return this.standIn.isShown ? this.standIn.shownCamera : this.viewer?.shownCamera;
  }

  /** Of the asset that is seen; null while they are not there. */
  get hitArrays() {
    return this.standIn.isShown && this.standIn.opened !== this.opened ? null : this.arrays;
  }

  /** Whether the network's picture is still to come, at least as sharp as what is seen in its place; or a poster hides a plain stand-in. */
  get isWaited() {
    return (!!this.viewer || this.standIn.isPlain) && this.look.coarsestSeen() <= SHARP;
  }

  placeLights() {
    const { suns, environment } = this.scene ?? {}, { sun, lightRotation, environmentIntensity } = this.settings;
    const { lighting } = this;
    lighting.reset();
    if (suns) lighting.suns = suns;
    if (environment) {
      const { key, strength = 1, rotation_deg = 0 } = environment;
      const choice = (!this.settings.environment && key) || lighting.choice;
      Object.assign(lighting, { choice, strength, imageTurn: rotation_deg });
    }
    if (sun) Object.assign(lighting, sun, { suns: null });
    this.setLight({ rotation: wrappedDegrees(lightRotation ?? 0), strength: environmentIntensity ?? lighting.strength });
  }

  /** Turns the asset under the lights and the camera, which keep their places, in sharp pictures. Radians. */
  turnTable(angle, moving) {
    this.orbit.turntable = -angle;
    this.lighting.turntable = (-angle * 180) / Math.PI;
    this.changed(moving, SHARP);
  }

  /** relights: the ground, which has the colour of the page. */
  setExposure(stops, relights = true) {
    this._setLook({ exposure: stops }, relights && this.ground);
  }

  /** view: srgb or filmic, as in a scene file. */
  setView(view) {
    this._setLook({ view }, this.ground);
  }

  /** The background behind the asset: linearColour. */
  setBackdrop(backdrop) {
    this._setLook({ backdrop }, this.ground);
  }

  setDenoise(on) {
    this._setLook({ denoise: on });
  }

  /** values: rounds, jitter. */
  setSampling(values) {
    this._setLook(values);
    this.viewer?.restart();
  }

  setGround(on) {
    this.ground = on;
    this.changed();
  }

  _setLook(values, relights = false) {
    Object.assign(this.look, values);
    Object.assign(this.viewer ?? {}, values);
    this.emit("set");
    if (relights) this.changed();
    this.standIn.draw();
    this.viewer?.show();
  }

  async _show(opened, tier, isNew, signal) {
    if (!(await this.begun)) return;
    const shown = await opened.load(tier, { wantsLobes: this._wantsLobes(opened) });
    shown.glass = await opened.glass;
    opened.forget();
    performance.mark("package");
    await this.lit;
    if (!(await this.begun)) return;
    this.placing = this.placing.catch(() => {}).then(() => this._place(opened, shown, isNew, signal));
    await this.placing;
  }

  /** One at a time: an engine has one asset. */
  async _place(opened, shown, isNew, signal) {
    signal?.throwIfAborted();
    if (!this.viewer || (!isNew && this.opened !== opened)) return;
    if (isNew) this.viewer.hasShown = false;
    this.viewer.pause();
    const building = isNew ? sceneArrays(shown.parts, shown.glass) : this.arrays;
    if (!(await this._upload(building, shown))) return;
    const arrays = await building;
    if (this.engine.hasLobes) await this.lighting.prepare();
    signal?.throwIfAborted();
    performance.mark("asset");
    Object.assign(this, { opened, shown, arrays, isNew });
    if (isNew) await this.print();
    if (isNew) this.arrive(opened, arrays.box);
    const { warnings } = opened.manifest;
    if (warnings.length) this.notices.say(warnings.join("; "), true, "asset");
    this.emit("package", { opened, shown });
    this.viewer.stats.ms = 0;
    this.changed();
    this.viewer.start();
  }

  /** Camera and, of a scene, lights for a package's asset in its box, where nobody has seen it yet. */
  arrive(opened, box) {
    const isThere = this.arrived === opened;
    Object.assign(this, { arrived: opened, box });
    if (isThere) return;
    if (this.scene) this.reset();
    else this.placeCamera();
  }

  /** Hands the asset to the engine, and to the next one where that is lost meanwhile; false if there is none any more. */
  async _upload(building, shown) {
    while ((await this.begun) && this.engine) {
      const { engine } = this;
      try {
        await engine.setAsset(building, shown);
        if (engine === this.engine) return true;
      } catch (error) {
        if (engine === this.engine) throw error;
      }
    }
    return false;
  }

  /** Shows the former picture on a new engine. */
  async restore(engine) {
    this.uploaded = null;
    if (!this.shown) return;
    this.viewer.hasShown = true;
    await engine.setAsset(this.arrays, this.shown);
    this.changed();
    this.viewer?.start();
    const { tier } = this.settings;
    if (tier && tier !== this.shown.name && !this.loading) this.switchTier(tier);
  }

  resized() {
    if (this.box && !this.isTouched) this.placeCamera();
    this.standIn.resize();
  }

  pictured() {
    this.emit("shown");
    const { isSharp, scale } = this.viewer.stats;
    if (isSharp && scale === 1) this._whole();
    if (!this.isNew || !isSharp) return;
    this.isNew = false;
    this.emit("load");
  }

  /** The network's picture of this asset is there at full size. */
  _whole() {
    if (this.arrived !== this.opened || this.standIn.opened !== this.opened) return;
    this.isWhole = true;
    this.standIn.leave();
  }

  async _offerPoster(opened) {
    try {
      this.emit("poster", { blob: await opened.posterImage() });
    } catch {
      // A poster that is broken is a warning (spec, 10): the asset is shown without it.
    }
  }

  _ground(irradiance) {
    const { view, exposure, backdrop } = this.look;
    this.notices.say(this.ground && (!backdrop || this.settings.skybox) ? "ground: expected an opaque background-color, and no skybox" : null, true, "ground");
    if (!this.ground || !backdrop || this.settings.skybox || !this.box) return null;
    const colour = view === "filmic" ? beforeFilmic(backdrop) : backdrop;
    const { min, max } = this.box, size = Math.hypot(...max.map((high, k) => high - min[k]));
    return {
      height: min[1] - 1e-4 * size, x: (min[0] + max[0]) / 2, z: (min[2] + max[2]) / 2, size: 2 * size,
      colour: colour.map((value, c) => (irradiance[c] > 0 ? value / irradiance[c] / 2 ** exposure : 0)),
    };
  }
}

function readScene(buffer, url) {
  try {
    return JSON.parse(new TextDecoder().decode(buffer));
  } catch (error) {
    throw new NotSupported(`${url}: expected a scene.json, found ${otherFile(new Uint8Array(buffer)) ?? error.message}`);
  }
}

async function fetched(url) {
  const answer = await fetch(url).catch(() => null);
  if (!answer?.ok) throw new NotSupported(`cannot load ${url}${answer ? `: HTTP ${answer.status}` : ""}`);
  return answer.arrayBuffer();
}
