// JSON as packages have it (spec, 3): no key twice, finite numbers, at most 64 levels.
import { fail } from "./errors.js";

const DEEPEST = 64;
const NUMBER = /-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y;
const SPACE = /[ \t\n\r]*/y;
const PLAIN = /[^"\\\u0000-\u001f]*/y;
const ESCAPES = { '"': '"', "\\": "\\", "/": "/", b: "\b", f: "\f", n: "\n", r: "\r", t: "\t" };

/** The object that `bytes` are. `code`: of what is malformed. */
export function parseJson(bytes, where, code) {
  let text;
  try {
    text = new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    fail(code, where, "no UTF-8");
  }
  const parser = new Parser(text, where, code);
  parser.space();
  if (text[parser.at] !== "{") fail(code, where, "not a JSON object");
  const value = parser.value(1);
  parser.space();
  if (parser.at !== text.length) parser.bad();
  return value;
}

/** Of an object; "__proto__" is a key like any other. Objects without a prototype take ten times the memory. */
function Members() {}
Members.prototype = Object.create(null);

class Parser {
  constructor(text, where, code) {
    Object.assign(this, { text, where, code, at: 0 });
  }

  bad(what = "malformed JSON") {
    fail(this.code, this.where, `${what} at character ${this.at}`);
  }

  match(pattern) {
    pattern.lastIndex = this.at;
    const match = pattern.exec(this.text);
    if (match) this.at = pattern.lastIndex;
    return match;
  }

  space() {
    this.match(SPACE);
  }

  take(text) {
    if (!this.text.startsWith(text, this.at)) return false;
    this.at += text.length;
    return true;
  }

  value(depth) {
    const first = this.text[this.at];
    if ((first === "{" || first === "[") && depth > DEEPEST) this.bad("nested too deep");
    if (first === "{") return this.object(depth);
    if (first === "[") return this.array(depth);
    if (first === '"') return this.string();
    for (const [word, value] of [["true", true], ["false", false], ["null", null]]) {
      if (this.take(word)) return value;
    }
    if (/NaN|-?Infinity/y.test(this.text.slice(this.at, this.at + 9))) this.notFinite();
    const number = this.match(NUMBER);
    if (!number) this.bad();
    const value = Number(number[0]);
    if (!Number.isFinite(value)) this.notFinite();
    return value === 0 ? 0 : value;
  }

  notFinite() {
    fail("JSON_NOT_FINITE", this.where, `no finite number at character ${this.at}`);
  }

  list(end, each) {
    this.at += 1;
    this.space();
    if (this.take(end)) return;
    do {
      this.space();
      each();
      this.space();
    } while (this.take(","));
    if (!this.take(end)) this.bad();
  }

  array(depth) {
    const values = [];
    this.list("]", () => values.push(this.value(depth + 1)));
    return values;
  }

  object(depth) {
    const result = new Members();
    this.list("}", () => {
      if (this.text[this.at] !== '"') this.bad();
      const key = this.string();
      if (key in result) fail("JSON_DUPLICATE_KEY", this.where, `the key "${key}" twice`);
      this.space();
      if (!this.take(":")) this.bad();
      this.space();
      result[key] = this.value(depth + 1);
    });
    return result;
  }

  string() {
    let result = "";
    this.at += 1;
    for (;;) {
      result += this.match(PLAIN)[0];
      if (this.take('"')) break;
      if (!this.take("\\")) this.bad();
      const escape = this.text[this.at++];
      if (escape === "u") {
        const digits = this.match(/[0-9a-fA-F]{4}/y);
        if (!digits) this.bad();
        result += String.fromCharCode(parseInt(digits[0], 16));
      } else if (escape in ESCAPES) result += ESCAPES[escape];
      else this.bad();
    }
    if (!result.isWellFormed()) this.bad("half of a surrogate pair");
    return result;
  }
}
