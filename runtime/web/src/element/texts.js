// What the element says to people: in the page's language, or as its attribute `texts` has it.
import { LANGUAGES, NAMES } from "./languages.js";

/** Texts of the attribute, by name. Throws for what it is not. */
export function readTexts(value) {
  let texts = null;
  try {
    texts = JSON.parse(value);
  } catch {
    // Named below.
  }
  const isRight = texts !== null && typeof texts === "object" && Object.entries(texts).every(([name, text]) => NAMES.includes(name) && typeof text === "string");
  if (!isRight) throw new Error(`expected a JSON object of texts called ${NAMES.join(", ")}, found ${JSON.stringify(value)}`);
  return texts;
}

/** A text of an element; values: of what is in braces. */
export function textOf(element, name, values = {}) {
  const own = element.settings.texts ?? {}, language = Object.keys(LANGUAGES).find((code) => element.matches(`:lang(${code})`)) ?? "en";
  const text = own[name] ?? LANGUAGES[language][NAMES.indexOf(name)];
  return text.replace(/\{(\w+)\}/g, (whole, key) => values[key] ?? whole);
}
