// The panel: the scene, how far it is, the lights, the exposure.
import { element, on, showValue, signed } from "../ui/elements.js";

export class Panel {
  constructor(preview) {
    on("lighting", "change", ({ value }) => preview.request({ lighting: value }));
    on("rotation", "input", ({ valueAsNumber }) => preview.setRotation(valueAsNumber));
    on("exposure", "input", ({ valueAsNumber }) => {
      this.showExposure(valueAsNumber);
      preview.request({ exposure: valueAsNumber });
    });
    on("denoise", "change", ({ checked }) => preview.request({ denoise: checked }));
    on("reset", "click", () => preview.reset());
    on("view-transform", "change", ({ value }) => preview.request({ view: value }));
    on("copy", "click", (button) => copy(button, preview.state?.text ?? ""));
    on("save", "click", () => this._save(preview));
  }

  showScene({ scene, resolution: [width, height], choices, exposure }) {
    document.title = `${scene} \u2013 preview`;
    element("scene").textContent = scene;
    element("resolution").textContent = `${width} \u00d7 ${height} pixels`;
    element("stage").style.setProperty("--ratio", width / height);
    element("lighting").replaceChildren(...choices.map(({ label, key }) => new Option(label, key)));
    const slider = element("exposure");
    slider.min = Math.min(slider.min, Math.floor(exposure));
    slider.max = Math.max(slider.max, Math.ceil(exposure));
  }

  showControls({ lighting, exposure, view, denoise }) {
    element("lighting").value = lighting;
    element("view-transform").value = view;
    element("denoise-row").hidden = denoise === null;  // no denoiser is installed
    element("denoise").checked = denoise;
    this.showExposure(exposure);
  }

  showRotation(degrees) {
    showValue("rotation", degrees, `${signed(Math.round(degrees), 0)}\u00b0`);
  }

  showExposure(stops) {
    showValue("exposure", stops, `${signed(stops, 1)} stops`);
  }

  /** Saves the picture once it has all samples; pressed again, as it is. */
  _save(preview) {
    const button = element("save"), { canvas } = preview;
    const take = () => {
      canvas.removeEventListener("shown", look);
      this.saving = false;
      button.textContent = "Save picture";
      const name = `${(preview.state?.scene ?? "scene").replace(/\.\w+$/, "")}.png`;
      Object.assign(document.createElement("a"), { href: "/picture.png", download: name }).click();
    };
    const look = () => {
      const { samples } = canvas.dataset, all = preview.state?.samples;
      if (Number(samples) >= all && preview.shown === preview.state.revision) return take();
      button.textContent = `Save now (${samples} of ${all})`;
    };
    if (this.saving) return take();
    this.saving = true;
    canvas.addEventListener("shown", look);
    look();
  }

  showLabel({ samples, sample_ms }, total) {
    element("samples").textContent = samples ? `${samples} / ${total}` : "first look";
    element("progress").value = samples / total;
    if (samples) element("time").textContent = `${Math.round(sample_ms)} ms`;
  }
}

/** Copies the present state to the clipboard, as the scene file has it. */
async function copy(button, text) {
  const label = button.textContent;
  try {
    await navigator.clipboard.writeText(text);
    button.textContent = "Copied";
  } catch {
    button.textContent = "Not allowed";
  }
  setTimeout(() => { button.textContent = label; }, 1500);
}
