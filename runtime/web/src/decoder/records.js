// Records of buffers by the names of their members: rna_gpu/records declares them, records.json has their places.
import layouts from "../../../rna_gpu/wgsl/records.json";

export const { constants, records, usualLobes, viewerLights } = layouts;

/** Takes the structs of a WGSL text, of numbers and vectors, to the records. */
export function declare(wgsl) {
  for (const [, name, body] of wgsl.matchAll(/struct (\w+) \{([^}]*)\}/g)) {
    const members = {};
    let end = 0;  // words
    for (const [, member, type] of body.matchAll(/^\s*(\w+): ([\w<>]+)/gm)) {
      const count = Number(/vec(\d)/.exec(type)?.[1] ?? 1), align = count === 3 ? 4 : count;
      const at = Math.ceil(end / align) * align;
      members[member] = { at, type: type.includes("u32") ? "u32" : "f32", count };
      end = at + count;
    }
    records[name] = { words: 4 * Math.ceil(end / 4), members };
  }
}

/** Words of a record, (n,) Uint32Array; members that `values` leaves out are 0. */
export function packed(name, values) {
  const words = new Uint32Array(records[name].words);
  write(words, new Float32Array(words.buffer), 0, name, values);
  return words;
}

/** Declarations of the kinds of light of a pass in WGSL: LIGHT_SUN and so on. */
export const lightKinds = Object.entries(viewerLights)
  .map(([kind, number]) => `const LIGHT_${kind.replace(/[A-Z]/g, "_$&").toUpperCase()}: u32 = ${number}u;`).join("\n");

export const bytesOf = (name) => 4 * records[name].words;

/** The numbers of a light of that kind. */
export function lightNumbers(kind, values) {
  const numbers = [];
  for (const [key, value] of Object.entries(values)) [value].flat().forEach((one, k) => { numbers[layouts.lights[kind][key] + k] = one; });
  return Float32Array.from(numbers, (value) => value ?? 0);
}

function write(words, floats, start, name, values) {
  for (const [key, value] of Object.entries(values)) {
    const { at, type, record } = records[name].members[key], place = start + at;
    const list = typeof value === "number" ? [value] : value;
    if (!record) (type === "f32" ? floats : words).set(list, place);
    else [list].flat().forEach((one, k) => write(words, floats, place + k * records[record].words, record, one));
  }
}
