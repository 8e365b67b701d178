// Changes of the picture. They wait, and add up, until a picture of the last one is there: so every picture is seen, and
// none is begun that would not be.
import { clamp } from "../ui/elements.js";

/** The change that does what `before` does, and then `more`. */
export function added(before, more) {
  const sum = { ...before };
  for (const [name, value] of Object.entries(more)) {
    if (name === "orbit_deg" || name === "pan") sum[name] = value.map((x, axis) => x + (before?.[name]?.[axis] ?? 0));
    else if (name === "dolly") sum.dolly = clamp((before?.dolly ?? 1) * value, 0.01, 100);
    else sum[name] = value;
  }
  if (more.reset) for (const name of ["orbit_deg", "pan", "dolly"]) delete sum[name];
  return sum;
}

export class Changes {
  /** isSeen(): whether the last change has been. onstate(state), onerror(text): what the renderer answers. */
  constructor({ isSeen, onstate, onerror }) {
    Object.assign(this, { isSeen, onstate, onerror, pending: null, sending: false });
  }

  request(change) {
    this.pending = added(this.pending, change);
    this.send();
  }

  async send() {
    if (!this.pending || this.sending || !this.isSeen()) return;
    const body = JSON.stringify(this.pending);
    this.pending = null;
    this.sending = true;
    try {
      const headers = { "Content-Type": "application/json" };
      const answer = await fetch("/change", { method: "POST", headers, body }), content = await answer.json();
      if (answer.ok) this.onstate(content);
      else this.onerror(content.error);
    } catch {
      // The loop of pictures tells that the server is gone.
    } finally {
      this.sending = false;
    }
    this.send();
  }
}
