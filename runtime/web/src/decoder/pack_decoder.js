// A decoder as vec4f, and its record: the layouts of rna_gpu/wgsl/README.md.
import { BLOCKS, blockNamed, widthOf } from "../package/blocks.js";
import { NotSupported } from "../package/errors.js";
import { constants, packed } from "./records.js";

const { RNA_NONE: NONE, MAX_LAYERS, MAX_EXACT_INPUTS, RNA_CHANNEL_GROUPS } = constants;
const groupsOf = (width) => Math.ceil(width / 4);

/**
 * { weights, record, groups }: binding 1, binding 0 and RNA_GROUPS. inputs: blocks; `more` columns, a multiple of 4, come
 * behind them.
 */
export function packDecoder(part, decoder, inputs, more = 0) {
  checkSize(decoder);
  const { places, slots, queryGroups } = spread(inputs, part.planes.channels, more);
  const pieces = new Pieces();
  let gain = NONE;
  if (decoder.int8) {
    gain = pieces.add(placed(decoder.gain, places, queryGroups));
    pieces.add(placed(decoder.offset, places, queryGroups));
  }
  const layers = decoder.layers.map((layer, k) => packLayer(pieces, layer, k ? null : places, k ? 0 : queryGroups));
  let matrix = null;
  if (decoder.matrix) {
    const rows = decoder.matrix.length / decoder.outputs, bias = new Float32Array(decoder.outputs);
    matrix = packLayer(pieces, { weight: decoder.matrix, bias, rows, columns: decoder.outputs, relu: false }, null, 0);
  }
  const all = [...layers, ...(matrix ? [matrix] : [])];
  const widest = Math.max(...all.flatMap(({ inputs: i, outputs: o }) => [i, o]));
  const record = partRecord(part, decoder, { queryGroups, gain, slots, layers, matrix });
  return { weights: pieces.all(), record, groups: Math.max(4, 2 ** Math.ceil(Math.log2(widest))) };
}

function checkSize({ layers, int8 }) {
  if (layers.length > MAX_LAYERS) throw new NotSupported(`a decoder of ${layers.length} layers; at most ${MAX_LAYERS}`);
  const wide = int8 ? Math.max(...layers.map(({ rows }) => rows)) : 0;
  if (wide > MAX_EXACT_INPUTS) throw new NotSupported(`an int8 layer of ${wide} inputs; at most ${MAX_EXACT_INPUTS}`);
}

/** Each block starts at a group of four columns. */
function spread(inputs, channels, more) {
  const places = [], slots = BLOCKS.map(() => NONE);
  let group = 0;
  for (const name of inputs) {
    const width = widthOf(name, channels);
    slots[BLOCKS.indexOf(blockNamed(name))] = group;
    for (let k = 0; k < width; k++) places.push(4 * group + k);
    group += groupsOf(width);
  }
  for (let k = 0; k < more; k++) places.push(4 * group + k);
  group += groupsOf(more);
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

function packLayer(pieces, { weight, bias, rows, columns, step: int8_step = 0, scales, relu }, places, given) {
  const inputs = given || groupsOf(rows), outputs = groupsOf(columns);
  const blocks = new Float32Array(16 * inputs * outputs);
  for (let i = 0; i < rows; i++) {
    const row = places ? places[i] : i, k = row >> 2;
    for (let o = 0; o < columns; o++) {
      blocks[16 * ((o >> 2) * inputs + k) + 4 * (row & 3) + (o & 3)] = weight[i * columns + o];
    }
  }
  const weights = pieces.add(blocks), biasAt = pieces.add(placed(bias, null, outputs));
  const units = scales ? pieces.add(placed(Float32Array.from(scales, (scale) => scale * int8_step), null, outputs)) : 0;
  return { inputs, outputs, weights, bias: biasAt, units, relu: Number(relu), int8_step };
}

function partRecord(part, decoder, { queryGroups, gain, slots, layers, matrix }) {
  const { resolution, channels, precision, scales } = part.planes, { low, high, top, unit, factors = 0, nearbyColumns = 0, means = [] } = decoder;
  const spreadScales = new Float32Array(3 * 4 * RNA_CHANNEL_GROUPS);
  for (let k = 0; scales && k < 3; k++) {
    spreadScales.set(scales.subarray(k * channels, (k + 1) * channels), 4 * RNA_CHANNEL_GROUPS * k);
  }
  return packed("RnaPart", {
    low: part.bounds.min, high: part.bounds.max, resolution, channel_groups: groupsOf(channels), query_groups: queryGroups,
    layer_count: layers.length, plane_precision: constants[`RNA_${precision.toUpperCase()}`], gain, query_low: low,
    query_high: high, top, unit, matrix: matrix ?? {}, scales: spreadScales, layers, slots, factors,
    nearby_columns: nearbyColumns, means,
  });
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
