// What the pages and the element share: elements by id, their events, numbers as text, the line of a message.

export const element = (id) => document.getElementById(id);

export function on(id, event, action) {
  element(id).addEventListener(event, ({ target }) => action(target));
}

/** A line over the picture. */
export class Notices {
  constructor(place) {
    Object.assign(this, { place, lines: new Map() });
  }

  /** null takes the line away. calm: it is no error. about: lines about other subjects stay. */
  say(text, calm = false, about = "page") {
    if (text) this.lines.set(about, { text, calm });
    else this.lines.delete(about);
    this.show();
  }

  show() {
    const lines = [...this.lines.values()];
    this.put(new Set(lines.map(({ text }) => text)), lines.every(({ calm }) => calm));
  }

  /** All lines, as a page's maker reads them; null if there is none. */
  get whole() {
    return [...this.lines.values()].map(({ text }) => text).join("\n") || null;
  }

  /** These texts, one below the other. */
  put(texts, calm) {
    const spans = [...texts].map((textContent) => Object.assign(document.createElement("span"), { textContent }));
    this.place.hidden = !spans.length;
    this.place.replaceChildren(...spans);
    this.place.classList.toggle("calm", calm);
  }
}

export const clamp = (x, low, high) => Math.min(Math.max(x, low), high);

/** An equal angle in [-180, 180). */
export const wrappedDegrees = (degrees) => ((((degrees + 180) % 360) + 360) % 360) - 180;

/** With a sign, except for zero. */
export function signed(x, digits) {
  const text = Math.abs(x).toFixed(digits);
  return Number(text) === 0 ? text : (x < 0 ? "\u2212" : "+") + text;
}

/** The text of a slider's <output> for its value. */
export function showValue(id, value, text) {
  element(id).value = value;
  element(`${id}-value`).textContent = text;
}

export function readableBytes(count) {
  return count < 1e6 ? `${Math.round(count / 1e3)} kB` : `${(count / 1e6).toFixed(count < 1e7 ? 2 : 1)} MB`;
}

export function readableTime(ms) {
  return ms < 10 ? `${ms.toFixed(1)} ms` : ms < 1e3 ? `${Math.round(ms)} ms` : `${(ms / 1e3).toFixed(1)} s`;
}
