// node element_texts.mjs ELEMENT_FOLDER: what texts, attributes and lines for visitors come to, as JSON.
const { LANGUAGES, NAMES } = await import(`${process.argv[2]}/languages.js`);
const { readTexts, textOf } = await import(`${process.argv[2]}/texts.js`);
const { READERS } = await import(`${process.argv[2]}/attributes.js`);
const { linesOnNames } = await import(`${process.argv[2]}/model_viewer_names.js`);
const { VisitorNotices } = await import(`${process.argv[2]}/visitor_notices.js`);

const said = [], timers = [];
for (const name of ["warn", "error"]) console[name] = (text) => said.push([name, text]);
globalThis.document = { createElement: () => ({}) };
globalThis.setTimeout = (action) => timers.push(action);
globalThis.clearTimeout = () => {};

const place = { hidden: true, texts: [], classList: { toggle() {} }, replaceChildren(...spans) { this.texts = spans.map((span) => span.textContent); } };
const element = { settings: {}, isSeen: true, matches: (selector) => selector === ":lang(de)" };
const notices = new VisitorNotices(place, element), seen = () => (place.hidden ? null : place.texts);
const tried = (action) => { try { return action(); } catch (error) { return error.message; } };

const steps = [];
notices.say("ground: expected an opaque background-color", true, "ground");
notices.say("ground: expected an opaque background-color", true, "ground");
steps.push(seen());
notices.say("WebGPU has no adapter here", false, "engine");
steps.push(seen());
timers.at(-1)();
steps.push(seen());
element.isSeen = false;
notices.say(null, true, "engine");
notices.say("tiny.rna: HTTP 404", false, "asset");
timers.at(-1)();
steps.push(seen());
element.settings.messages = "whole";
notices.show();
steps.push(seen());

console.log(JSON.stringify({
  languages: Object.fromEntries(Object.entries(LANGUAGES).map(([code, texts]) => [code, Object.fromEntries(texts.map((text, k) => [NAMES[k] ?? k, text]))])),
  names: NAMES, steps, said,
  own: textOf({ settings: { texts: readTexts('{"shown": "Da: {name} {x}"}') }, matches: () => false }, "shown", { name: "Auto" }),
  refused: ["{", '{"promt": "x"}', '{"prompt": 1}', "null"].map((text) => tried(() => readTexts(text))),
  empty: ["src", "glass", "poster", "environment", "scene"].map((name) => READERS[name](" ")),
  strangers: linesOnNames(["src", "ar", "environment-image", "exposure"]), ours: linesOnNames(["src", "exposure", "data-labels"]),
}));
