// A canvas with an engine that draws on it, and a new one where that one is lost, fails or has no memory.
import { Reader } from "../conformance.js";
import { NotSupported, PackageError } from "../package/errors.js";
import { listen } from "../ui/pointer.js";
import { WebGPUEngine } from "../webgpu/engine.js";
import { compose, sharedFiles, rayKernels } from "../webgpu/sources.js";
import { actions, isForPicture } from "./gestures.js";
import { copyForPaper } from "./paper.js";
import { Viewer } from "./viewer.js";

const MOST_PIXELS = 2.2e6;  // of the picture, whatever the screen: memory of phones
const MOST_LOSSES = 4;      // of engines, one soon after the other, until the poster is shown instead
const LONG_MS = 60000;      // of an engine's life, after which a loss is the first

/** The contents are a subclass's: restore(engine) shows them again; resized() and pictured() hear of the canvas. */
export class LastingEngine extends EventTarget {
  /** place: what the canvas fills. notices: lines for people. settings: by property, the attributes' values. */
  constructor(place, notices, settings) {
    super();
    Object.assign(this, { place, notices, settings, losses: 0, lives: 0, isResting: false, canvas: null, size: { width: 1, height: 1 } });
    this.look = { backdrop: null, exposure: 0, view: "srgb", denoise: true, rounds: 256, jitter: 1, coarsestSeen: () => Infinity };
    new ResizeObserver(() => this.resize()).observe(place);
  }

  /** Until the end: a page that moves to a screen with other pixels, or is zoomed, keeps the sizes of its elements. */
  _followScreen() {
    this.following = new AbortController();
    const again = () => {
      this.following.abort();
      this.resize();
      this._followScreen();
    };
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", again, { signal: this.following.signal });
  }

  /** The engine and an empty picture; packages that load meanwhile wait for it. The result tells whether there is one. */
  begin() {
    return this.replace();
  }

  /** Lets the GPU go. */
  end() {
    this.lives += 1;
    this.begun = Promise.resolve(false);
    this.following?.abort();
    this.living?.abort();
    this.viewer?.stop();
    this.engine?.close();
    Object.assign(this, { viewer: null, engine: null });
  }

  /** Another engine in place of the one that is there, with what was shown. */
  replace() {
    this.end();
    this.since = performance.now();
    const begun = this._begin().then(() => (begun === this.begun ? !!this.engine : this.begun), (error) => {
      if (begun !== this.begun) return this.begun;
      this._giveUp(error);
      return false;
    });
    return (this.begun = begun);
  }

  async _begin() {
    const life = this.lives, canvas = document.createElement("canvas");
    const engine = await WebGPUEngine.open(canvas);
    if (life !== this.lives) return engine.close();
    this.engine = engine;
    this.resize();
    this.mount(canvas);
    engine.onlost = (reason) => this._lost(engine, reason);
    this.viewer = Object.assign(new Viewer(engine, canvas, this.orbit), this.look, { resting: this.isResting });
    this.viewer.addEventListener("shown", () => this.pictured());
    this.viewer.addEventListener("failed", ({ error }) => this._lost(engine, lineOf(error)));
    performance.mark("engine");
    copyForPaper(canvas, () => this.viewer.show(), this.living.signal);
    this.emit("engine");
    this._followScreen();
    await this.restore(engine);
  }

  /** A canvas in its place, which takes the gestures; the one that was there goes. */
  mount(canvas) {
    this.living?.abort();
    this.canvas?.remove();
    Object.assign(this, { canvas, living: new AbortController() });
    Object.assign(canvas, this.size);
    this.place.append(canvas);
    listen(canvas, actions(this), (event) => isForPicture(this, event), this.living.signal);
    this.emit("canvas");
  }

  /** Without an engine from now on. */
  _giveUp(error) {
    this.end();
    this.canvas?.remove();
    this.canvas = null;
    this.failed(error, "engine");
  }

  /** Holds samples back while nobody can see them. */
  rest(on) {
    this.isResting = on;
    this.viewer?.rest(on);
  }

  resize() {
    const { clientWidth: w, clientHeight: h } = this.place;
    const ratio = this.settings.pixelRatio ?? Math.min(devicePixelRatio, 2);
    const scale = Math.min(ratio, Math.sqrt(MOST_PIXELS / Math.max(1, w * h)));
    const width = Math.max(1, Math.round(w * scale)), height = Math.max(1, Math.round(h * scale));
    if (this.size.width === width && this.size.height === height) return;
    this.size = { width, height };
    if (this.canvas) Object.assign(this.canvas, this.size);
    this.resized();
    this.viewer?.restart();
  }

  /** The shaders, for the test that they are rna_gpu's. */
  get wgsl() {
    return { compose, sharedFiles, rayKernels };
  }

  /** Asks the engine without a picture: for the conformance kit, and to measure. */
  reader() {
    this.viewer.pause();
    return new Reader(this.engine);
  }

  /** The picture as it is now: a Blob. */
  async screenshot(type = "image/png", quality = undefined) {
    await this.viewer.pictured();
    this.viewer.show();
    return new Promise((resolve) => this.canvas.toBlob(resolve, type, quality));
  }

  /** Once more with a new engine; one that is lost, or has an error, again and again is no good. */
  async _lost(engine, why) {
    if (engine !== this.engine) return;
    this.losses = performance.now() - this.since > LONG_MS ? 1 : this.losses + 1;
    if (this.losses >= MOST_LOSSES) {
      return this._giveUp(new NotSupported(`${why}, ${this.losses} times`));
    }
    this.notices.say(`${why}; starting again`, true, "engine");
    if (await this.replace()) this.notices.say(null, false, "engine");
  }

  emit(name, more) {
    this.dispatchEvent(Object.assign(new Event(name), more));
  }

  /** about: what the line stands for until that works; see Notices. */
  failed(error, about) {
    if (!isKnown(error)) console.error(error);
    this.notices.say(lineOf(error), false, about);
    this.failures = (this.failures ?? 0) + 1;
    this.emit("failed", { error, about });
  }
}

const isKnown = (error) => error instanceof PackageError || error instanceof NotSupported;
const lineOf = (error) => (isKnown(error) ? error.message : `this did not work: ${error.message ?? error}`);
