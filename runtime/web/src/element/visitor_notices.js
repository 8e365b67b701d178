// Lines for those who make the page, whole in the console; visitors are told calmly, and not for long, of what they miss.
import { Notices } from "../ui/elements.js";
import { textOf } from "./texts.js";

const SHOWN_MS = 6000;
const MISSED = { engine: "unavailable", asset: "failed", scene: "failed" };  // by what a failure is about: the text

export class VisitorNotices extends Notices {
  #element;

  /** element: has the words, and knows whether anything is seen of the asset. */
  constructor(place, element) {
    super(place);
    this.#element = element;
    this.missed = null;
  }

  say(text, calm = false, about = "page") {
    if (text && this.lines.get(about)?.text !== text) console[calm ? "warn" : "error"](`rna-viewer: ${text}`);
    super.say(text, calm, about);
  }

  show() {
    if (this.#element.settings.messages === "whole") return this._showWhole();
    const isMissed = (one) => this.lines.get(one)?.calm === false && !(one === "engine" && this.#element.isStoodFor);
    const about = Object.keys(MISSED).find(isMissed), missed = about ? MISSED[about] : null;
    if (missed === this.missed) return;
    this.missed = missed;
    clearTimeout(this.timer);
    this.put(missed ? [textOf(this.#element, missed)] : [], true);
    // What stands in an empty place stays.
    if (missed) this.timer = setTimeout(() => { this.place.hidden = this.#element.isSeen; }, SHOWN_MS);
  }

  _showWhole() {
    clearTimeout(this.timer);
    this.missed = undefined;
    super.show();
  }
}
