// The page as a reader of the conformance kit (spec/conformance/README.md); bytes in and out, base64.
import { sceneArrays } from "./geometry/scene_arrays.js";
import { Package } from "./package/package.js";
import { BlobSource } from "./package/source.js";
import { baseColors, evaluate, ROW_WORDS, mappedNormals, visibility } from "./webgpu/answers.js";

const bytesOf = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));

function textOf(values) {
  const bytes = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
  let text = "";
  for (let k = 0; k < bytes.length; k += 8192) text += String.fromCharCode(...bytes.subarray(k, k + 8192));
  return btoa(text);
}

export class Reader {
  rowWords = ROW_WORDS;

  constructor(engine) {
    this.engine = engine;
  }

  /** Loads a package, base64; its tier, the first by default. */
  async load(text, tier) {
    const opened = await Package.open(new BlobSource(new Blob([bytesOf(text)]), "package"));
    this.shown = await opened.load(tier);
    this.arrays = await sceneArrays(this.shown.parts);
    await this.engine.setAsset(this.arrays, this.shown);
    this.engine.resize(1, 1);
  }

  /** columns: 16, 19 with nearby light, or 10 for emission, float32. */
  async evaluate(part, output, text, columns = 16) {
    const given = new Float32Array(bytesOf(text).buffer), count = given.length / columns, rows = new Float32Array(ROW_WORDS * count);
    for (let k = 0; k < count; k++) {
      const row = given.subarray(columns * k, columns * (k + 1)), wo = row.subarray(7, 10);
      const wi = columns > 10 ? row.subarray(10, 13) : wo, [red = 0, green = 0, blue = 0, ...nearby] = row.subarray(13);
      const more = nearby.length ? [...nearby, 1] : [];
      rows.set([...row.subarray(0, 3), row[6], ...row.subarray(3, 6), red, ...wo, green, ...wi, blue, ...more], ROW_WORDS * k);
    }
    return textOf(await this.answer(part, output, rows));
  }

  /** Numbers for rows of rowWords: webgpu/answers.js. */
  answer(...query) {
    return evaluate(this.engine, ...query);
  }

  async visibility(text) {
    return textOf(await visibility(this.engine, this._hits(text)));
  }

  async normals(text) {
    return textOf(await mappedNormals(this.engine, this._hits(text)));
  }

  async baseColor(text) {
    return textOf(await baseColors(this.engine, this._hits(text)));
  }

  _hits(text) {
    const { buffer } = bytesOf(text), words = new Uint32Array(buffer), floats = new Float32Array(buffer), hits = [];
    for (let at = 0; at < words.length; at += 8) {
      const part = words[at + 7], { first, fiber } = this.arrays.parts[part];
      const numbers = floats.subarray(at, at + 7), place = this.arrays.where[first + words[at]];
      hits.push(fiber
        ? { place, part, b1: 0, b2: 0, x: numbers.slice(1, 4), wi: numbers.slice(4, 7), level: 0 }
        : { place, part, b1: numbers[1], b2: numbers[2], x: [0, 0, 0], wi: numbers.slice(3, 6), level: numbers[3] });  // with base colours a level in place of wi
    }
    return hits;
  }
}
