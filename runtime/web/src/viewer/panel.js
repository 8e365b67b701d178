// The panel's controls and figures, progress, poster, messages.
import { element, on, readableBytes, readableTime, say, showValue, signed } from "../ui/elements.js";

const FLUENT_MS = 100;  // a sample, while something moves
const CHEAPER = 0.7;    // of the cost: what makes another tier worth a word

export class Panel {
  constructor(app) {
    this.app = app;
    on("tier", "change", ({ value }) => app.switchTier(value));
    const light = (id, name) => {
      on(id, "input", ({ valueAsNumber }) => this._setLight(name, valueAsNumber, true));
      on(id, "change", ({ valueAsNumber }) => this._setLight(name, valueAsNumber, false));
    };
    light("environment-intensity", "strength");
    light("sun-intensity", "sun");
    light("sun-height", "sunHeight");
    light("rotation", "rotation");
    on("environment", "change", ({ value }) => this._setLight("choice", value, false));
    on("exposure", "input", ({ valueAsNumber }) => app.setExposure(valueAsNumber));
    on("exposure", "change", () => this.hasGround && app.changed());  // the ground has the colour of the page
    on("view-transform", "change", ({ value }) => app.setView(value));
    on("denoise", "change", ({ checked }) => app.setDenoise(checked));
    on("ground", "change", () => app.changed());
    on("faster", "click", () => app.switchTier(this.faster));
    on("reset", "click", () => app.resetView());
    on("screenshot", "click", () => this._save());
    on("fullscreen", "click", () => this._fullScreen());
    this.showLighting(app.lighting);
    this.showExposure(0);
  }

  _setLight(name, value, moving) {
    // The first touch of the sun puts the page's sun in place of a scene's.
    if (name === "sun" || name === "sunHeight") this.app.lighting.suns = null;
    this.app.lighting[name] = value;
    this.showLighting(this.app.lighting);
    this.app.changed(moving);
  }

  get hasGround() {
    return element("ground").checked;
  }

  setGround(on) {
    element("ground").checked = on;
  }

  showLighting({ images, choice, strength, sun, suns, sunHeight, rotation }) {
    const options = [...images].map(([key, { label }]) => new Option(label, key, false, key === choice));
    element("environment").replaceChildren(...options);
    showValue("environment-intensity", strength, strength.toFixed(2));
    // The suns of a scene are no sun of the panel's.
    showValue("sun-intensity", sun, suns ? "the scene's" : sun.toFixed(1));
    showValue("sun-height", sunHeight, suns ? "the scene's" : `${signed(Math.round(sunHeight), 0)}\u00b0`);
    showValue("rotation", rotation, `${signed(Math.round(rotation), 0)}\u00b0`);
  }

  showExposure(stops) {
    showValue("exposure", stops, `${signed(stops, 1)} stops`);
  }

  showView(view) {
    element("view-transform").value = view;
  }

  showEngine(label, reasons) {
    element("api").textContent = [label, ...reasons].join(": ");
  }

  showPackage({ manifest, warnings = manifest.warnings, bytesOf, ...opened }, { tier }) {
    const own = this.app.opened;
    document.title = `${manifest.name} – RNA viewer`;
    element("name").textContent = manifest.name;
    element("tier").replaceChildren(
      ...manifest.tiers.map(({ name }) => new Option(name, name, false, name === tier.name)),
    );
    const { validation, cost } = tier;
    element("error").textContent = validation ? `${validation.psnr.toFixed(1)} dB, FLIP ${validation.flip.toFixed(3)}` : "not recorded";
    element("cost").textContent = cost ? `${cost.multiplyAdds.toLocaleString("en")} multiply-adds` : "not recorded";
    element("size").textContent = readableBytes(own.bytesOf(tier.name));
    if (warnings.length) say(warnings.join("; "), true, "asset");
  }

  showStats({ ms, rounds, scale }) {
    element("time").textContent = ms ? readableTime(ms) : "–";
    element("rounds").textContent = scale === 1 ? String(rounds) : `first look, 1/${scale} of the size`;
    this._suggestTier(ms);
  }

  /** A cheaper tier, where this one is not fluent: the best that may be, else the cheapest. */
  _suggestTier(ms) {
    const { opened, shown } = this.app, own = shown?.tier.cost?.multiplyAdds;
    const time = ({ cost }) => (ms * cost.multiplyAdds) / own;  // the decoder's part of it, which is most
    const cheaper = own && ms > FLUENT_MS
      ? opened.manifest.tiers.filter(({ cost }) => cost && cost.multiplyAdds < CHEAPER * own).sort((a, b) => time(b) - time(a))
      : [];
    const found = cheaper.find((tier) => time(tier) <= FLUENT_MS) ?? cheaper.at(-1);
    this.faster = found?.name;
    element("faster").hidden = !found;
    if (found) element("faster").textContent = `Switch to tier ${found.name}: about ${readableTime(time(found))} a sample`;
  }

  /** got: bytes so far, null when there is nothing more to wait for. */
  showProgress(got, all) {
    element("loading").hidden = got === null;
    if (got === null) return;
    const bar = element("bar");
    if (all) Object.assign(bar, { max: Math.max(all, got), value: got });
    else bar.removeAttribute("value");
    element("bytes").textContent = all ? `${readableBytes(got)} of ${readableBytes(Math.max(all, got))}` : readableBytes(got);
  }

  showPoster(blob) {
    const image = element("poster");
    if (image.src) URL.revokeObjectURL(image.src);
    image.hidden = !blob;
    if (blob) image.src = URL.createObjectURL(blob);
    else image.removeAttribute("src");
  }

  /** Saves the picture once it has all samples; pressed again, as it is. */
  async _save() {
    const { viewer } = this.app, button = element("screenshot");
    if (!viewer) return;
    if (this.saving) return this.saving.abort();
    const saving = (this.saving = new AbortController());
    const tell = () => {
      const { rounds, scale } = viewer.stats;
      button.textContent = `Save now (${scale === 1 ? rounds : 0} of ${viewer.rounds})`;
    };
    tell();
    viewer.addEventListener("shown", tell);
    await Promise.race([viewer.converged(), new Promise((resolve) => saving.signal.addEventListener("abort", resolve))]);
    viewer.removeEventListener("shown", tell);
    this.saving = null;
    button.textContent = "Save picture";
    const link = document.createElement("a");
    link.href = URL.createObjectURL(await this.app.screenshot());
    link.download = `${this.app.opened?.manifest.name ?? "rna"}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  _fullScreen() {
    if (document.fullscreenElement) document.exitFullscreen();
    else document.documentElement.requestFullscreen?.();
  }
}
