// What stands beside the picture: the scene, how far it is, the lights, the exposure.
import { element, on, showValue, signed } from "../ui/elements.js";

export class Panel {
  constructor(preview) {
    on("lighting", "change", ({ value }) => preview.ask({ lighting: value }));
    on("rotation", "input", ({ valueAsNumber }) => preview.setRotation(valueAsNumber));
    on("exposure", "input", ({ valueAsNumber }) => {
      this.showExposure(valueAsNumber);
      preview.ask({ exposure: valueAsNumber });
    });
    on("denoise", "change", ({ checked }) => preview.ask({ denoise: checked }));
    on("reset", "click", () => preview.reset());
    on("copy", "click", (button) => copy(button, preview.state?.camera ?? {}));
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

  showControls({ lighting, exposure, denoise }) {
    element("lighting").value = lighting;
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

  showLabel({ samples, sample_ms }, total) {
    element("samples").textContent = samples ? `${samples} / ${total}` : "first look";
    element("progress").value = samples / total;
    if (samples) element("time").textContent = `${Math.round(sample_ms)} ms`;
  }
}

/** The camera as the scene file has it, on the clipboard. */
async function copy(button, camera) {
  const lines = Object.entries(camera).map(([name, value]) => {
    const numbers = [value].flat().map((x) => (typeof x === "number" ? Number(x.toFixed(4)) : x));
    return `  ${name}: ${Array.isArray(value) ? `[${numbers.join(", ")}]` : numbers[0]}`;
  });
  try {
    await navigator.clipboard.writeText(["camera:", ...lines, ""].join("\n"));
    button.textContent = "Copied";
  } catch {
    button.textContent = "Not allowed";
  }
  setTimeout(() => { button.textContent = "Copy camera"; }, 1500);
}
