// A decoder as vec4f, and its record: the layouts of rna_gpu/wgsl/README.md.
import { NotSupported } from "../package/errors.js";

const NONE = 0xffffffff, MOST_LAYERS = 32, EXACT_INPUTS = 512;
export const UNIFORM_WEIGHTS = 4096;  // vec4f in 64 KiB
const BLOCKS = [
  "features", "position", "normal", "tangent", "h", "wo", "wi", "half_vector", "highlight", "learned_normal",
  "fiber_angles", "fiber_lobes",
];
const WIDTHS = {
  position: 3, normal: 3, tangent: 3, h: 1, wo: 3, wi: 3, half_vector: 5, highlight: 1, learned_normal: 2,
  fiber_angles: 6, fiber_lobes: 3,
};
const PRECISIONS = { float32: 0, float16: 1, int8: 2 };
const groupsOf = (width) => Math.ceil(width / 4);

/** { weights, record, groups }: binding 1, binding 0 and RNA_GROUPS. */
export function packDecoder(part, decoder, inputs) {
  checkSize(decoder);
  const { places, slots, queryGroups } = spread(inputs, part.planes.channels);
  const pieces = new Pieces();
  let gain = NONE;
  if (decoder.int8) {
    gain = pieces.add(placed(decoder.gain, places, queryGroups));
    pieces.add(placed(decoder.offset, places, queryGroups));
  }
  const layers = decoder.layers.map((layer, k) => {
    const relu = Number(!decoder.int8 && k + 1 < decoder.layers.length);
    return packLayer(pieces, { ...layer, relu }, k ? null : places, k ? 0 : queryGroups);
  });
  let matrix = null;
  if (decoder.matrix) {
    const rows = decoder.matrix.length / decoder.outputs, bias = new Float32Array(decoder.outputs);
    matrix = packLayer(pieces, { weight: decoder.matrix, bias, rows, columns: decoder.outputs, relu: 0 }, null, 0);
  }
  const all = [...layers, ...(matrix ? [matrix] : [])];
  const widest = Math.max(...all.flatMap(({ inputs: i, outputs: o }) => [i, o]));
  const record = partRecord(part, decoder, { queryGroups, gain, slots, layers, matrix });
  return { weights: pieces.all(), record, groups: Math.max(4, 2 ** Math.ceil(Math.log2(widest))) };
}

function checkSize({ layers, int8 }) {
  if (layers.length > MOST_LAYERS) throw new NotSupported(`a decoder of ${layers.length} layers; at most ${MOST_LAYERS}`);
  const wide = int8 ? Math.max(...layers.map(({ rows }) => rows)) : 0;
  if (wide > EXACT_INPUTS) throw new NotSupported(`an int8 layer of ${wide} inputs; at most ${EXACT_INPUTS}`);
}

/** Each block starts at a group of four columns. */
function spread(inputs, channels) {
  const places = [], slots = BLOCKS.map(() => NONE);
  let group = 0;
  for (const name of inputs) {
    const width = WIDTHS[name] ?? channels;
    slots[BLOCKS.indexOf(name)] = group;
    for (let k = 0; k < width; k++) places.push(4 * group + k);
    group += groupsOf(width);
  }
  return { places, slots, queryGroups: group };
}

class Pieces {
  constructor() {
    this.list = [];
    this.length = 0;
  }

  /** Place of values, whose number is a multiple of 4. */
  add(values) {
    const place = this.length;
    this.list.push(values);
    this.length += values.length / 4;
    return place;
  }

  all() {
    const result = new Float32Array(4 * this.length);
    let at = 0;
    for (const values of this.list) {
      result.set(values, at);
      at += values.length;
    }
    return result;
  }
}

function placed(values, places, groups) {
  const result = new Float32Array(4 * groups);
  values.forEach((value, k) => { result[places ? places[k] : k] = value; });
  return result;
}

function packLayer(pieces, { weight, bias, rows, columns, step = 0, scales, relu }, places, given) {
  const inputs = given || groupsOf(rows), outputs = groupsOf(columns);
  const blocks = new Float32Array(16 * inputs * outputs);
  for (let i = 0; i < rows; i++) {
    const row = places ? places[i] : i, k = row >> 2;
    for (let o = 0; o < columns; o++) {
      blocks[16 * ((o >> 2) * inputs + k) + 4 * (row & 3) + (o & 3)] = weight[i * columns + o];
    }
  }
  const weights = pieces.add(blocks), biasAt = pieces.add(placed(bias, null, outputs));
  const units = scales ? pieces.add(placed(Float32Array.from(scales, (scale) => scale * step), null, outputs)) : 0;
  return { inputs, outputs, weights, bias: biasAt, units, relu, step };
}

/** RnaPart, 1,936 bytes. */
function partRecord(part, decoder, { queryGroups, gain, slots, layers, matrix }) {
  const bytes = new ArrayBuffer(1936), words = new Uint32Array(bytes), floats = new Float32Array(bytes);
  const { resolution, channels, precision, scales } = part.planes;
  floats.set(part.bounds.min, 0);
  words[3] = resolution;
  floats.set(part.bounds.max, 4);
  words.set([groupsOf(channels), queryGroups, layers.length, PRECISIONS[precision], gain], 7);
  floats.set([decoder.low, decoder.high, decoder.top, decoder.unit], 12);
  const layer = (at, { inputs, outputs, weights, bias, units, relu, step }) => {
    words.set([inputs, outputs, weights, bias, units, relu], at);
    floats[at + 6] = step;
  };
  if (matrix) layer(16, matrix);
  words.set(slots, 24);
  for (let k = 0; scales && k < 3; k++) {
    for (let c = 0; c < channels; c++) floats[36 + 64 * k + c] = scales[k * channels + c];
  }
  layers.forEach((own, k) => layer(228 + 8 * k, own));
  return words;
}

/** One plane as stored, channels filled up to a multiple of 4. */
export function planeWords({ values, resolution, channels }, k) {
  const area = resolution * resolution, one = values.subarray(k * area * channels, (k + 1) * area * channels);
  const wide = 4 * groupsOf(channels);
  if (wide === channels) return one;
  const result = new values.constructor(area * wide);
  for (let texel = 0; texel < area; texel++) {
    result.set(one.subarray(texel * channels, (texel + 1) * channels), texel * wide);
  }
  return result;
}
