// <rna-viewer src="toy.rna" auto-rotate camera-controls>: an asset on any page. Its attributes, properties and events.
import { nameOf } from "../package/source.js";
import { readableBytes } from "../ui/elements.js";
import { nearName } from "../ui/near_name.js";
import { cameraText, flag, lightText, propertyOf, READERS } from "./attributes.js";
import { linearColour } from "./backdrop.js";
import { Hotspots } from "./hotspots.js";
import { isModelViewers, linesOnNames } from "./model_viewer_names.js";
import { attach, dress } from "./shadow.js";
import { spokenView } from "./spoken.js";
import { Stage } from "./stage.js";
import { textOf } from "./texts.js";
import { Turntable } from "./turntable.js";
import { SHARP } from "./viewer.js";
import { VisitorNotices } from "./visitor_notices.js";

const BUILT_IN = ["studio", "white"];  // environments
const NEAR = "50% 0px";  // of the window, around it: where an element is loaded and draws
const SPEAK_MS = 500;    // after the last movement
const PROMPT_MS = 3000;  // after the picture is there
const NOT_OURS = /^(data-|aria-|on|dir$)|[^a-z-]/;  // attributes, of HTML and of frameworks
const ADDRESSES = { src: "asset", environment: "light", scene: "scene" };  // and what a failure is about

/** By name of a file in the page's folder what people call it, of pages that rna-view writes. */
function labelsOf({ dataset: { rnaLabels } }) {
  try {
    return JSON.parse(rnaLabels ?? "{}") ?? {};
  } catch {
    return {};
  }
}

/** A place or a direction; as text, what data-position and data-normal take. */
class Vector {
  constructor(x, y, z) {
    Object.assign(this, { x, y, z });
  }

  toString() {
    return [this.x, this.y, this.z].map((value) => `${value}m`).join(" ");
  }
}

// In node and in workers, where there are no elements, the class can be imported and no more.
export class RnaViewer extends (globalThis.HTMLElement ?? Object) {
  static observedAttributes = [...Object.keys(READERS), "lang"];

  constructor() {
    super();
    const root = attach(this), part = (id) => root.getElementById(id);
    this.parts = { view: part("view"), poster: part("poster"), image: root.querySelector("img"), loading: part("loading"), prompt: part("prompt"), bar: part("bar"), bytes: part("bytes"), keys: part("keys"), status: part("status"), tint: part("tint") };
    this.settings = Object.fromEntries(Object.keys(READERS).map((name) => [propertyOf(name), null]));
    this.notices = new VisitorNotices(part("notice"), this);
    this.stage = new Stage(this.parts.view, this.notices, this.settings);
    this.stage.look.coarsestSeen = () => ((this.stage.standIn.isShown && !this.stage.standIn.isPlain) || this._isCovered ? SHARP : Infinity);
    this.turntable = new Turntable(this.stage);
    new Hotspots(this, part("hotspots"), this.stage);
    this.stillness = matchMedia("(prefers-reduced-motion: reduce)");
    Object.assign(this, { loaded: false, observer: null, isNear: false, hasMoved: false, isDismissed: false, isBegun: false, requestedSrc: null, failures: new Set() });
    this._listen();
  }

  connectedCallback() {
    this.stage.labels = labelsOf(this);
    this.observer = new IntersectionObserver((entries) => this._seen(entries.at(-1).isIntersecting), { rootMargin: NEAR });
    this.observer.observe(this);
    this.stillness.addEventListener("change", this.onstillness = () => this._still());
    this._takeOver();
    this._still();
    this._tint();
    this._begin();
  }

  /** It has come to another document, such as an iframe's. */
  adoptedCallback() {
    dress(this.shadowRoot);
  }

  /** An element that only moves within its page keeps its GPU. */
  disconnectedCallback() {
    this.observer.disconnect();
    this.stillness.removeEventListener("change", this.onstillness);
    queueMicrotask(() => {
      if (this.isConnected || !this.isBegun) return;
      if (this.stage.loading) this.requestedSrc = null;
      this.isBegun = false;
      this.turntable.switch(false);
      this.stage.close();
    });
  }

  attributeChangedCallback(name, before, text) {
    if (name === "lang") return this._describe();
    const isTriedAgain = this.failures.delete(ADDRESSES[name]);
    if (before === text && !isTriedAgain) return;
    if (["src", "glass"].includes(name)) this.requestedSrc = null;
    const property = propertyOf(name);
    try {
      this.settings[property] = text === null ? null : READERS[name](text);
      this.notices.say(null, true, name);
    } catch (error) {
      this.settings[property] = null;
      this.notices.say(`${name}: ${error.message}`, true, name);
    }
    this._apply(name);
  }

  /** Names of the package's tiers, once it is open. */
  get availableTiers() {
    return this.stage.opened?.manifest.tiers.map(({ name }) => name) ?? [];
  }

  /** Names of the package's variants, once it is open. */
  get availableVariants() {
    return this.stage.opened?.variants ?? [];
  }

  /** The names of the package's images of base colour, once it is shown. */
  get availableMaps() {
    return this.stage.arrays?.surfaces.labels ?? [];
  }

  /** Another picture, a Blob, ImageBitmap, canvas or image, for those with that label; null: the package's own. */
  setMap(label, picture) {
    return this.stage.setMap(label, picture);
  }

  /** Angle of auto-rotate so far, radians. */
  get turntableRotation() {
    return this.turntable.angle;
  }

  resetTurntableRotation(angle = 0) {
    this.turntable.set(angle);
  }

  /** Camera and lights as the attributes have them. */
  resetView() {
    this.stage.glideTo(() => this.stage.reset());
  }

  showPoster() {
    this.isDismissed = false;
    this.parts.poster.hidden = false;
  }

  /** Loads the asset if `reveal` waits for that, and shows it. */
  dismissPoster() {
    this.isDismissed = true;
    this._begin();
    if (this.loaded || this.stage.standIn.isShown) this._hidePoster();
  }

  /** Where the asset is at a place of the window, in pixels of CSS: { position, normal }, each x, y, z; null beside it. */
  positionAndNormalFromPoint(clientX, clientY) {
    const { left, top, width, height } = this.parts.view.getBoundingClientRect();
    const hit = this.stage.hitAt((clientX - left) / width, (clientY - top) / height);
    return hit && { position: new Vector(...hit.position), normal: new Vector(...hit.normal) };
  }

  /** The picture as it is now: a Blob; null while there is none. */
  async toBlob({ mimeType = "image/png", qualityArgument, converged = false } = {}) {
    const { stage } = this;
    if (!stage.viewer || !this.loaded) return null;
    if (converged) await stage.viewer.converged();
    return stage.screenshot(mimeType, qualityArgument);
  }

  _seen(isNear) {
    this.isNear = isNear;
    this.stage.rest(!isNear);
    this._tint();  // where it was not displayed, no transition fired
    this._begin();
  }

  /** Properties that the page set before there was a class, which hide those of the class; and a word on misspelt attributes. */
  _takeOver() {
    for (const property of Object.keys(READERS).map(propertyOf).filter((name) => Object.hasOwn(this, name))) {
      const value = this[property];
      delete this[property];
      this[property] = value;
    }
    const names = this.getAttributeNames();
    for (const line of linesOnNames(names)) console.warn(`rna-viewer: ${line}`);
    for (const name of names.filter((one) => !(one in READERS) && !isModelViewers(one) && !NOT_OURS.test(one))) {
      const near = nearName(name, Object.keys(READERS));
      if (near) console.warn(`rna-viewer has no attribute ${name}: did you mean ${near}?`);
    }
  }

  /** Applies an attribute to the shown asset. */
  _apply(name) {
    const { stage, settings } = this;
    if (name === "src" && settings.src === null && !stage.scene?.asset) this._clear();
    if (["src", "glass"].includes(name)) this._begin();
    if (name === "poster") this._showImage(settings.poster);
    if (name === "scene") this._openScene();
    if (name === "environment" && this.isBegun) this._light();
    if (name === "tier" && stage.opened && !stage.loading) stage.switchTier(settings.tier);
    if (name === "variant-name" && stage.shown && !stage.loading) stage.switchVariant(settings.variantName);
    if (name === "first-look" && stage.shown) stage.switchTier(stage.shown.name);
    if (name === "samples") stage.setSampling({ rounds: settings.samples ?? 256 });
    if (name === "jitter") stage.setSampling({ jitter: settings.jitter ?? 1 });
    if (["camera-orbit", "camera-target", "field-of-view"].includes(name)) stage.glideTo(() => stage.placeCamera());
    if (/^(min|max)-/.test(name)) stage.limitCamera();
    if (["sun", "light-rotation", "environment-intensity"].includes(name)) stage.placeLights();
    if (name === "ground") stage.setGround(settings.ground ?? stage.scene?.ground ?? false);
    if (name === "skybox") stage.changed();
    if (name === "exposure") stage.setExposure(settings.exposure ?? stage.scene?.exposure ?? 0);
    if (name === "view-transform") stage.setView(settings.viewTransform ?? stage.scene?.view ?? "srgb");
    if (name === "pixel-ratio") stage.resize();
    if (["maps", "tint"].includes(name) && stage.shown) stage.print();
    if (["loading", "reveal"].includes(name)) this._begin();
    if (name === "messages") this.notices.show();
    if (["camera-controls", "interaction-prompt"].includes(name)) this._prompt();
    if (name.startsWith("auto-rotate") || name === "rotation-per-second") this._turn();
    this._describe();
  }

  /** Loads what `src` names, once it is wanted and all attributes of a new element are read. */
  _begin() {
    const { stage, settings } = this, isShown = settings.reveal !== "manual" || this.isDismissed;
    this.parts.image.loading = settings.loading === "eager" ? "eager" : "lazy";
    if (!this.isConnected || !this.observer || !(settings.loading === "eager" || (this.isNear && isShown))) return;
    if (!this.isBegun) {
      this.isBegun = true;
      stage.begin();
      this._turn();
      if (settings.environment && !this.isLit) this._light();
      if (settings.scene && !stage.scene) return void this._openScene();
    }
    const src = settings.src ?? stage.scene?.asset ?? null;
    if (src !== this.requestedSrc) this._open(src);
  }

  _open(src) {
    this.requestedSrc = src;
    if (src === null) return;
    this.loaded = false;
    this.stage.open(this.requestedSrc);
  }

  /** Nothing is shown any more, except a poster. */
  _clear() {
    Object.assign(this, { loaded: false, isBegun: false });
    this.turntable.switch(false);
    this.stage.clear();
    this._showImage(this.settings.poster);
  }

  async _openScene() {
    const { stage, settings } = this;
    if (settings.scene === null) return stage.leaveScene();
    if (!this.isBegun) stage.scene = null;  // it is opened where the element begins
    else if (await stage.openScene(settings.scene)) this._begin();
  }

  _light() {
    const { environment } = this.settings;
    this.isLit = true;
    if (environment !== null && !BUILT_IN.includes(environment)) this.stage.openImage(environment, nameOf(environment));
    else this.stage.chooseImage(environment ?? "studio");
  }

  /** The present background colour: it may follow the page's theme. */
  _tint() {
    this.stage.setBackdrop(linearColour(getComputedStyle(this.parts.tint).backgroundColor));
  }

  /** People want stillness, or no longer. The query is read here alone: reading it between a change and its event
   * takes the event away. */
  _still() {
    this.stage.isStill = this.stillness.matches;
    this._turn();
    this._prompt();
  }

  _turn() {
    const { autoRotate, autoRotateDelay, rotationPerSecond } = this.settings;
    Object.assign(this.turntable, { delay: autoRotateDelay ?? 3000, speed: rotationPerSecond ?? 30 });
    this.turntable.switch(!!autoRotate && this.isBegun && !this.stage.isStill);
  }

  _listen() {
    const { stage, parts } = this, on = (name, action) => stage.addEventListener(name, action);
    parts.tint.addEventListener("transitionend", () => this._tint());
    on("canvas", () => this._describe());
    on("progress", ({ got, all }) => this._showProgress(got, all));
    on("poster", ({ blob }) => this.settings.poster || stage.standIn.isShown || this._showImage(blob && URL.createObjectURL(blob)));
    on("package", () => this._describe());
    on("loading", () => this.failures.delete("asset"));
    on("shown", () => this._reveal(stage.isTouched));
    on("load", () => {
      this.loaded = true;
      this._reveal(stage.isTouched);
      parts.status.textContent = textOf(this, "shown", { name: this._name() });
      this._fire("progress", { totalProgress: 1 });
      this._fire("load", { url: this.requestedSrc });
      this._prompt();
    });
    on("stand-in", () => this._stand());
    on("ended", () => {
      parts.loading.hidden = true;
      this.notices.show();
    });
    on("failed", ({ error, about }) => {
      this.failures.add(about);
      if (about === "engine") parts.poster.hidden = stage.standIn.isShown;
      this._fire("error", { type: about, message: error.message, code: error.code ?? null, sourceError: error });
    });
    for (const name of ["camera", "light"]) on(name, () => this._reveal(true));
    on("camera", ({ byUser }) => {
      this._fire("camera-change", { ...cameraText(stage.orbit), source: byUser ? "user-interaction" : "none" });
      if (!byUser) return;
      this._moved();
      this._speak();
    });
    on("light", ({ byUser }) => this._fire("light-change", { ...lightText(stage.lighting), source: byUser ? "user-interaction" : "none" }));
  }

  /** The stand-in is there, or gone: with the network's picture in its place, or none. */
  _stand() {
    const { parts, stage } = this;
    this.notices.show();
    if (!stage.standIn.isShown) return void (parts.poster.hidden &&= this.loaded || stage.isWhole);
    parts.loading.hidden = true;
    if (!stage.standIn.isPlain || !this._isCovered) this._hidePoster();
    parts.status.textContent = textOf(this, "shown", { name: this._name() });
    this._fire("stand-in");
    this._prompt();
  }

  /** Says that the asset can be turned, to those who have not moved it for a while and do not mind motion. */
  _prompt() {
    clearTimeout(this.prompting);
    const { cameraControls, interactionPrompt } = this.settings;
    const isWanted = () => cameraControls && interactionPrompt !== "none" && !this.hasMoved && !this.stage.isStill;
    this.parts.prompt.hidden = true;
    if ((this.loaded || this.stage.standIn.isShown) && isWanted()) this.prompting = setTimeout(() => { this.parts.prompt.hidden = !isWanted(); }, PROMPT_MS);
  }

  /** People have moved it: the prompt is no longer wanted. */
  _moved() {
    this.hasMoved = true;
    this._prompt();
  }

  _speak() {
    clearTimeout(this.speaking);
    this.speaking = setTimeout(() => { this.parts.status.textContent = spokenView(this.stage.orbit, (name) => textOf(this, name)); }, SPEAK_MS);
  }

  _showProgress(got, all) {
    const { loading, bar, bytes } = this.parts;
    loading.hidden = this.stage.standIn.isShown;
    if (all) Object.assign(bar, { max: Math.max(all, got), value: got });
    else bar.removeAttribute("value");
    bytes.textContent = all ? `${readableBytes(got)} / ${readableBytes(Math.max(all, got))}` : readableBytes(got);
    this._fire("progress", { totalProgress: all ? Math.min(0.99, got / all) : 0 });
  }

  /** The poster in its place; null takes it away. */
  _showImage(address) {
    const { image, poster } = this.parts;
    if (image.src.startsWith("blob:")) URL.revokeObjectURL(image.src);
    image.hidden = !address;
    if (address) image.src = address;
    else image.removeAttribute("src");
    if (address) poster.hidden = false;
  }

  /** Whether a poster is seen in place of the picture. */
  get _isCovered() {
    const { poster, image } = this.parts;
    return !poster.hidden && (!image.hidden || poster.firstChild.assignedElements().length > 0);
  }

  /** The picture in place of the poster, once it is as sharp, or shows another view or light, as a plain stand-in does, too. */
  _reveal(isOther = false) {
    const isWanted = this.settings.reveal !== "manual" || this.isDismissed;
    if ((this.loaded || this.stage.standIn.isPlain) && isWanted && (isOther || this._isAsSharp())) this._hidePoster();
  }

  /** The size of a poster in a slot is not known: it takes the canvas'. */
  _isAsSharp() {
    const { viewer, canvas } = this.stage, { image } = this.parts, { isSharp, scale } = viewer?.stats ?? {};
    if (!isSharp) return false;
    const share = image.hidden ? 1 : Math.max(image.naturalWidth / canvas.width, image.naturalHeight / canvas.height);
    return 1 / scale >= Math.min(1, share);
  }

  /** Whether there is anything to see of the asset. */
  get isSeen() {
    const { image } = this.parts, isPoster = this._isCovered && (image.hidden || image.naturalWidth > 0);
    return isPoster || this.stage.standIn.isShown || (this.loaded && !!this.stage.viewer);
  }

  /** Whether the asset is seen, or may be soon, in whatever way; or none is wanted. */
  get isStoodFor() {
    return this.stage.standIn.isShown || !!this.stage.loading || !(this.settings.src ?? this.stage.scene?.asset);
  }

  _hidePoster() {
    const { poster } = this.parts;
    if (poster.hidden) return;
    poster.hidden = true;
    this.turntable.wait();
    this._fire("poster-dismissed");
  }

  _name() {
    return this.settings.alt ?? this.stage.opened?.manifest.name ?? textOf(this, "asset");
  }

  /** Names and roles for those who do not see the picture. */
  _describe() {
    const { canvas } = this.stage, { parts } = this, { cameraControls } = this.settings;
    parts.image.alt = this._name();
    parts.bar.setAttribute("aria-label", textOf(this, "loading"));
    for (const name of ["prompt", "keys"]) parts[name].textContent = textOf(this, name);
    if (!canvas) return;
    canvas.style.touchAction = this._touchAction();
    const wanted = cameraControls ? { role: "application", tabindex: 0, "aria-describedby": "keys" } : { role: "img" };
    canvas.setAttribute("aria-label", this._name());
    for (const name of ["role", "tabindex", "aria-describedby"]) {
      if (name in wanted) canvas.setAttribute(name, wanted[name]);
      else canvas.removeAttribute(name);
    }
  }

  /** The effect of a finger on the page; two zoom it where they do not zoom the asset. */
  _touchAction() {
    const { cameraControls, touchAction, disableZoom } = this.settings;
    if (!cameraControls) return "auto";
    const action = touchAction ?? "pan-y";
    return disableZoom ? `${action === "none" ? "" : action} pinch-zoom`.trim() : action;
  }

  _fire(name, detail = null) {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}

/** The present view, in the words of the attributes, which stay as they were written. */
const LIVE = {
  cameraOrbit: ({ stage }) => cameraText(stage.view).cameraOrbit,
  cameraTarget: ({ stage }) => cameraText(stage.view).cameraTarget,
  fieldOfView: ({ stage }) => cameraText(stage.view).fieldOfView,
  sun: ({ stage }) => lightText(stage.lighting).sun,
  lightRotation: ({ stage }) => lightText(stage.lighting).lightRotation,
  environmentIntensity: ({ stage }) => stage.lighting.strength,
  exposure: ({ stage }) => stage.look.exposure,
  viewTransform: ({ stage }) => stage.look.view,
  tier: ({ stage, settings }) => stage.shown?.name ?? settings.tier,
};

/** The value of an attribute as its property takes it again: a number, or the text; null where it counts as missing. */
function written(viewer, name) {
  const value = viewer.settings[propertyOf(name)], text = viewer.getAttribute(name);
  return value === null || Number(text) === value ? value : text;
}

for (const [name, read] of Object.entries(READERS)) {
  const property = propertyOf(name), isFlag = read === flag;
  Object.defineProperty(RnaViewer.prototype, property, {
    get() {
      return LIVE[property]?.(this) ?? (isFlag ? this.settings[property] === true : written(this, name));
    },
    set(value) {
      const text = isFlag ? (value ? "" : null) : value;
      if (text === null || text === undefined) this.removeAttribute(name);
      else this.setAttribute(name, text);
    },
    enumerable: true, configurable: true,
  });
}

if (globalThis.customElements && !customElements.get("rna-viewer")) customElements.define("rna-viewer", RnaViewer);
