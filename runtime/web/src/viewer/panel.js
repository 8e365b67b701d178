// The panel's controls and figures.
import { element, on, readableBytes, readableTime, showValue, signed } from "../ui/elements.js";

const FLUENT_MS = 100;  // a sample, while something moves
const CHEAPER = 0.7;    // of the cost: what makes another tier worth a word

export class Panel {
  constructor(stage) {
    this.stage = stage;
    on("tier", "change", ({ value }) => stage.switchTier(value));
    const light = (id, name) => {
      on(id, "input", ({ valueAsNumber }) => this._setLight(name, valueAsNumber, true));
      on(id, "change", ({ valueAsNumber }) => this._setLight(name, valueAsNumber, false));
    };
    light("environment-intensity", "strength");
    light("sun-intensity", "sun");
    light("sun-height", "sunHeight");
    light("rotation", "rotation");
    on("environment", "change", ({ value }) => this._setLight("choice", value, false));
    on("exposure", "input", ({ valueAsNumber }) => stage.setExposure(valueAsNumber, false));
    on("exposure", "change", ({ valueAsNumber }) => stage.setExposure(valueAsNumber));
    on("view-transform", "change", ({ value }) => stage.setView(value));
    on("denoise", "change", ({ checked }) => stage.setDenoise(checked));
    on("ground", "change", ({ checked }) => stage.setGround(checked));
    on("faster", "click", () => stage.switchTier(this.faster));
    on("reset", "click", () => stage.glideTo(() => stage.reset()));
    on("screenshot", "click", () => this._save());
    on("fullscreen", "click", () => this._fullScreen());
    const hear = (name, action) => stage.addEventListener(name, action);
    hear("set", () => this._showControls());
    hear("package", ({ opened, shown }) => this._showPackage(opened, shown));
    hear("shown", () => stage.viewer && this._showStats(stage.viewer.stats));
    this._showControls();
  }

  _setLight(name, value, moving) {
    // The first touch of the sun puts the page's sun in place of a scene's.
    const suns = name === "sun" || name === "sunHeight" ? null : this.stage.lighting.suns;
    this.stage.setLight({ [name]: value, suns }, { moving, byUser: true });
  }

  _showControls() {
    const { images, choice, strength, sun, suns, sunHeight, rotation } = this.stage.lighting;
    const options = [...images].map(([key, { label }]) => new Option(label, key, false, key === choice));
    element("environment").replaceChildren(...options);
    showValue("environment-intensity", strength, strength.toFixed(2));
    // The suns of a scene are no sun of the panel's.
    showValue("sun-intensity", sun, suns ? "the scene's" : sun.toFixed(1));
    showValue("sun-height", sunHeight, suns ? "the scene's" : `${signed(Math.round(sunHeight), 0)}\u00b0`);
    showValue("rotation", rotation, `${signed(Math.round(rotation), 0)}\u00b0`);
    const { exposure, view } = this.stage.look;
    showValue("exposure", exposure, `${signed(exposure, 1)} stops`);
    element("view-transform").value = view;
    element("ground").checked = this.stage.ground;
  }

  _showPackage(opened, { tier }) {
    const { name, tiers } = opened.manifest, { validation, cost } = tier;
    document.title = `${name} – RNA viewer`;
    element("name").textContent = name;
    element("tier").replaceChildren(...tiers.map((one) => new Option(one.name, one.name, false, one.name === tier.name)));
    element("error").textContent = validation ? `FLIP ${validation.flip.toFixed(3)}, ${validation.psnr.toFixed(1)} dB` : "not recorded";
    element("cost").textContent = cost ? `${cost.multiplyAdds.toLocaleString("en")} multiply-adds` : "not recorded";
    element("size").textContent = readableBytes(opened.bytesOf(tier.name));
  }

  _showStats({ ms, rounds, scale }) {
    element("time").textContent = ms ? readableTime(ms) : "–";
    element("rounds").textContent = scale === 1 ? String(rounds) : `first look, 1/${scale} of the size`;
    this._suggestTier(ms);
  }

  /** A cheaper tier, where this one is not fluent: the best that may be, else the cheapest. */
  _suggestTier(ms) {
    const { opened, shown } = this.stage, operations = shown?.tier.cost?.multiplyAdds;
    const time = ({ cost }) => (ms * cost.multiplyAdds) / operations;  // the decoder's part of it, which is most
    const cheaper = operations && ms > FLUENT_MS
      ? opened.manifest.tiers.filter(({ cost }) => cost && cost.multiplyAdds < CHEAPER * operations).sort((a, b) => time(b) - time(a))
      : [];
    const faster = cheaper.find((tier) => time(tier) <= FLUENT_MS) ?? cheaper.at(-1);
    this.faster = faster?.name;
    element("faster").hidden = !faster;
    if (faster) element("faster").textContent = `Switch to tier ${faster.name}: about ${readableTime(time(faster))} a sample`;
  }

  /** Saves the picture once it has all samples; pressed again, as it is. */
  async _save() {
    const { viewer } = this.stage, button = element("screenshot");
    if (!viewer) return;
    if (this.saving) return this.saving.abort();
    const saving = (this.saving = new AbortController());
    const check = () => {
      const { rounds, scale } = viewer.stats;
      button.textContent = `Save now (${scale === 1 ? rounds : 0} of ${viewer.rounds})`;
    };
    check();
    viewer.addEventListener("shown", check);
    await Promise.race([viewer.converged(), new Promise((resolve) => saving.signal.addEventListener("abort", resolve))]);
    viewer.removeEventListener("shown", check);
    this.saving = null;
    button.textContent = "Save picture";
    const link = document.createElement("a");
    link.href = URL.createObjectURL(await this.stage.screenshot());
    link.download = `${this.stage.opened?.manifest.name ?? "rna"}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  _fullScreen() {
    if (document.fullscreenElement) document.exitFullscreen();
    else document.documentElement.requestFullscreen?.();
  }
}
