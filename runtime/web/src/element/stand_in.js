// An asset's stand-in: a material of glTF in WebGL 2, below the network's picture, which fades in over it at full size. Where
// there is no WebGPU it stays; there an asset without colours by place has one, too, below its poster until somebody moves it.
import { readStandIn } from "../stand_in/content.js";
import { StandInRenderer } from "../stand_in/renderer.js";

const FADE_MS = 400;  // of shadow.js, and some more
const OTHERWISE = ["glass", "maps", "tint", "skybox"];  // settings that it does not show

/** The stage's events "stand-in" tell that `isShown` changed. */
export class StandIn {
  #stage;

  constructor(stage) {
    this.#stage = stage;
    Object.assign(this, { opened: null, isShown: false, isPlain: false, renderer: null, shownCamera: null });
  }

  /** Of a package that is open, once its entries are read and its lights known; nothing of one without colours for it. takesPlain: as of readStandIn. */
  async show(opened, takesPlain = false) {
    const stage = this.#stage, request = (this.request = {}), isWanted = () => request === this.request && !stage.isWhole;
    this.opened = opened;
    try {
      const content = OTHERWISE.some((name) => stage.settings[name]) ? null : await readStandIn(opened, takesPlain);
      if (!content && isWanted()) this.end();
      if (!content) return;
      await stage.lit;
      await stage.lighting.prepare();
      if (isWanted()) this._begin(content);
    } catch (error) {
      console.warn(`rna-viewer: no stand-in: ${error.message}`);  // the package's own reading tells what is wrong with it
    }
  }

  /** Shows the former picture again. */
  again(takesPlain = false) {
    if (this.opened && !this.isShown) return this.show(this.opened, takesPlain);
  }

  _begin(content) {
    const stage = this.#stage, canvas = Object.assign(document.createElement("canvas"), stage.size);
    this.end();
    this.renderer = StandInRenderer.open(canvas, content);
    if (!this.renderer) return;
    this.canvas = canvas;
    canvas.addEventListener("webglcontextlost", () => canvas === this.canvas && this.end());
    canvas.setAttribute("aria-hidden", "true");
    stage.place.prepend(canvas);
    stage.place.classList.add("standing");
    if (!stage.canvas) stage.mount(document.createElement("canvas"));
    stage.arrive(this.opened, content.box);
    Object.assign(this, { isShown: true, isPlain: content.isPlain });
    this._draw();
    performance.mark("stand-in");
    stage.emit("stand-in");
  }

  resize() {
    if (!this.renderer) return;
    Object.assign(this.canvas, this.#stage.size);
    this._draw();  // at once: a canvas of another size is empty
  }

  /** With the next picture of the screen. */
  draw() {
    if (!this.renderer || this.isRequested || this.#stage.isResting) return;
    this.isRequested = true;
    requestAnimationFrame(() => {
      this.isRequested = false;
      this._draw();
    });
  }

  _draw() {
    const { renderer, canvas } = this, stage = this.#stage, { lighting, look } = stage;
    if (!renderer) return;
    if (!lighting.isPrepared) return void lighting.prepare().then(() => this.draw());
    const camera = stage.orbit.camera(canvas.width, canvas.height), lights = lighting.firstLights() ?? lighting.lights().lights;
    renderer.draw({ camera, lights, exposure: 2 ** look.exposure, isFilmic: look.view === "filmic" });
    this.shownCamera = { ...camera, width: canvas.width, height: canvas.height };
    if (this.isShown) stage.emit("shown");
  }

  /** The network's picture is at full size. */
  leave() {
    if (!this.isShown) return;
    this._hide();
    this.leaving = setTimeout(() => this.end(), FADE_MS);
  }

  _hide() {
    this.isShown = false;
    this.#stage.place.classList.remove("standing");
    this.#stage.emit("stand-in");
  }

  /** Lets go of WebGL. */
  end() {
    clearTimeout(this.leaving);
    const { canvas, renderer, isShown } = this;
    Object.assign(this, { canvas: null, renderer: null, isPlain: false, shownCamera: null });
    canvas?.remove();
    renderer?.close();
    if (isShown) this._hide();
  }

  forget() {
    Object.assign(this, { opened: null, request: null });
    this.end();
  }
}
