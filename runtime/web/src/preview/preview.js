// The page's state: what the renderer last told, which picture is shown, what is asked for next.
import { element, Notices, wrappedDegrees } from "../ui/elements.js";
import { listen } from "../ui/pointer.js";
import { Changes } from "./changes.js";
import { Panel } from "./panel.js";

const DEGREES = 180 / Math.PI;

export class Preview {
  constructor() {
    this.canvas = element("picture");
    this.context = this.canvas.getContext("2d");
    this.notices = new Notices(element("notice"));
    // rotation: of the lights, degrees; ahead of the state while changes wait. shown: revision of the picture.
    Object.assign(this, { state: null, shown: 0, rotation: 0, panel: new Panel(this) });
    this.changes = new Changes({
      isSeen: () => this.state && this.shown >= this.state.revision,
      onstate: (state) => this._take(state),
      onerror: (text) => this.notices.say(text),
    });
    listen(this.canvas, {
      orbit: (x, y) => this.request({ orbit_deg: [x * DEGREES, y * DEGREES] }),
      light: (x) => this.setRotation(wrappedDegrees(this.rotation + x * DEGREES)),
      pan: (x, y) => this.request({ pan: [x, y] }),
      zoom: (factor) => this.request({ dolly: factor }),
      settle: () => {},
      reset: () => this.reset(),
    });
  }

  request(change) {
    this.changes.request(change);
  }

  setRotation(degrees) {
    this._showRotation(degrees);
    this.request({ light_rotation_deg: degrees });
  }

  reset() {
    this._showRotation(0);
    this.request({ reset: true, light_rotation_deg: 0 });
  }

  /** Pictures, for as long as the server is there. */
  async run() {
    let after = 0;
    for (;;) {
      try {
        if (!this.state) await this._load();
        after = await this._nextPicture(after);
      } catch {
        this.notices.say(`The preview has ended. Started again with --port ${location.port}, it goes on here.`);
        Object.assign(this, { state: null, shown: 0 });
        this.changes.pending = null;
        after = 0;
        await new Promise((resolve) => setTimeout(resolve, 1000));
      }
    }
  }

  async _load() {
    const answer = await fetch("/state");
    if (!answer.ok) throw new Error("no state");
    this._take(await answer.json());
  }

  _take(newer) {
    if (this.state && newer.revision < this.state.revision) return;
    const isFirst = !this.state;
    this.state = newer;
    if (isFirst) {
      [this.canvas.width, this.canvas.height] = newer.resolution;
      this.panel.showScene(newer);
    }
    if (this.changes.pending) return;
    this.panel.showControls(newer);
    this._showRotation(newer.light_rotation_deg);
  }

  _showRotation(degrees) {
    this.rotation = degrees;
    this.panel.showRotation(degrees);
  }

  async _nextPicture(after) {
    const answer = await fetch(`/picture?after=${after}`);
    if (answer.status === 204) return after;
    if (!answer.ok) throw new Error("no picture");
    const label = JSON.parse(answer.headers.get("Rna-Label"));
    if (label.revision > this.state.revision) await this._load();  // another page changed the view
    if (label.revision < this.state.revision) return label.serial;
    if (!label.error) {
      const bitmap = await createImageBitmap(await answer.blob());
      if (label.revision < this.state.revision) return label.serial;
      this._draw(bitmap);
      this.panel.showLabel(label, this.state.samples);
    }
    this.notices.say(label.error);
    this.shown = label.revision;
    // For whoever measures or tests.
    Object.assign(this.canvas.dataset, { revision: label.revision, samples: label.samples });
    this.canvas.dispatchEvent(new Event("shown"));
    this.changes.send();
    return label.serial;
  }

  _draw(bitmap) {
    this.context.imageSmoothingQuality = "high";
    this.context.drawImage(bitmap, 0, 0, this.canvas.width, this.canvas.height);
    bitmap.close();
  }
}
