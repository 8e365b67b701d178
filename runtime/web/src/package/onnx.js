// What is read of a decoder's ONNX model (spec, 6.2): nodes and constants out of the protobuf message.
import { typed } from "./tensors.js";

export const FLOAT = 1, UINT8 = 2, INT8 = 3, INT32 = 6;
const TYPES = { [FLOAT]: Float32Array, [UINT8]: Uint8Array, [INT8]: Int8Array, [INT32]: Int32Array };
const VALUES_ELSEWHERE = [3, 4, 5, 6, 7, 10, 11, 13];  // fields of a tensor that may have them in the place of raw_data
const MOST_FIELDS = 2 ** 18;

/**
 * { nodes, constants }: a node is { operator, inputs, output, axis or null }; a constant { name, type, dims, values }, values
 * null of a type or size that none of a decoder has.
 * `outside`: called with a text where the model is not a decoder's.
 */
export function readOnnx(bytes, { columns, outputs, output }, outside) {
  const reader = new Reader(outside);
  const model = reader.message(bytes, { 1: "number", 7: "bytes", 8: "many", 20: "many", 25: "many" });
  const sets = model[8].map((set) => reader.message(set, { 1: "text", 2: "number" }));
  const graph = reader.message(model[7], { 1: "many", 5: "many", 11: "many", 12: "many", 15: "many" });
  if (!(model[1] >= 7 && model[1] <= 10)) outside(`IR version ${model[1]}, expected 7 to 10`);
  if (sets.length !== 1 || !isDefault(sets[0][1]) || !(sets[0][2] >= 13 && sets[0][2] <= 21)) {
    outside("operators that are not those of ONNX, version 13 to 21");
  }
  if (model[20].length || model[25].length || graph[15].length) outside("functions, training or sparse tensors");
  checkInterface(reader, graph[11], "queries", columns);
  checkInterface(reader, graph[12], output, outputs);
  return {
    nodes: graph[1].map((message) => readNode(reader, message)),
    constants: graph[5].map((message) => readTensor(reader, message)),
  };
}

const isDefault = (domain) => domain === "" || domain === "ai.onnx";

function checkInterface(reader, list, name, width) {
  const [value] = list.map((message) => reader.message(message, { 1: "text", 2: "bytes" }));
  const tensor = value && reader.message(reader.message(value[2], { 1: "bytes" })[1], { 1: "number", 2: "bytes" });
  const dims = tensor && reader.message(tensor[2], { 1: "many" })[1].map(
    (dimension) => reader.message(dimension, { 1: "number?", 2: "text" })[1],
  );
  const right = list.length === 1 && value[1] === name && tensor[1] === FLOAT && dims.length === 2
    && dims[0] === undefined && dims[1] === width;
  if (!right) reader.outside(`not one ${name}, float32 [N, ${width}]`);
}

function readNode(reader, message) {
  const node = reader.message(message, { 1: "many", 2: "many", 4: "text", 5: "many", 7: "text" });
  if (!isDefault(node[7]) || node[2].length !== 1) reader.outside(`${node[4]} of another domain, or of several results`);
  const attributes = node[5].map((attribute) => reader.message(attribute, { 1: "text", 3: "number?" }));
  if (attributes.some(({ 1: name, 3: value }) => name !== "axis" || value === undefined) || attributes.length > 1) {
    reader.outside(`${node[4]} with another attribute than axis`);
  }
  return { operator: node[4], inputs: node[1].map(reader.text), output: reader.text(node[2][0]), axis: attributes[0]?.[3] ?? null };
}

function readTensor(reader, message) {
  const elsewhere = Object.fromEntries(VALUES_ELSEWHERE.map((field) => [field, "many"]));
  const tensor = reader.message(message, { 1: "numbers", 2: "number", 8: "text", 9: "bytes", 14: "number", ...elsewhere });
  if (tensor[14] || VALUES_ELSEWHERE.some((field) => tensor[field].length)) reader.outside("a constant not in raw_data");
  const { 1: dims, 2: type, 9: raw } = tensor, Type = TYPES[type], count = dims.reduce((product, side) => product * side, 1);
  const whole = Type && dims.length <= 2 && raw.length === count * Type.BYTES_PER_ELEMENT;
  return { name: tensor[8], type, dims, values: whole ? typed(Type, raw, 0, count) : null };
}

/**
 * Protobuf messages: fields by number, of which `wanted` says what they are: "number" (0 where it is absent), "number?",
 * "text", "bytes", "many" (byte strings), "numbers".
 */
class Reader {
  constructor(outside) {
    this.outside = outside;
    this.fields = 0;
    this.text = (bytes) => {
      try {
        return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
      } catch {
        return outside("a name that is no UTF-8");
      }
    };
  }

  message(bytes, wanted) {
    const lists = Object.fromEntries(Object.keys(wanted).map((field) => [field, []]));
    for (let at = 0; at < bytes.length;) {
      if (++this.fields > MOST_FIELDS) this.outside("too many fields");
      let key, value;
      [key, at] = this.varint(bytes, at);
      if (key < 8) this.outside("a field without a number");
      [value, at] = this.value(bytes, at, key % 8);
      lists[Math.floor(key / 8)]?.push(value);
    }
    return Object.fromEntries(Object.entries(wanted).map(([field, kind]) => [field, this.taken(lists[field], kind)]));
  }

  taken(list, kind) {
    if (kind === "numbers") return list.flatMap((value) => (typeof value === "number" ? value : this.packed(value)));
    const isNumber = kind.startsWith("number");
    if (list.some((value) => (typeof value === "number") !== isNumber)) this.outside("a field of another type");
    if (kind === "many") return list;
    if (list.length > 1) this.outside("a field twice");
    if (isNumber) return list[0] ?? (kind === "number" ? 0 : undefined);
    return kind === "text" ? this.text(list[0] ?? new Uint8Array()) : list[0] ?? new Uint8Array();
  }

  packed(bytes) {
    const numbers = [];
    for (let at = 0, number; at < bytes.length;) {
      if (++this.fields > MOST_FIELDS) this.outside("too many numbers");
      [number, at] = this.varint(bytes, at);
      numbers.push(number);
    }
    return numbers;
  }

  value(bytes, at, type) {
    if (type === 0) return this.varint(bytes, at);
    let length = { 1: 8, 5: 4 }[type];
    if (type === 2) [length, at] = this.varint(bytes, at);
    if (length === undefined || at + length > bytes.length) this.outside("a field that is cut short");
    return [bytes.subarray(at, at + length), at + length];
  }

  /** A number up to 2^64, as float64: what a decoder has is far below 2^53. */
  varint(bytes, at) {
    for (let value = 0, unit = 1, k = 0; k < 10 && at < bytes.length; k++, unit *= 128) {
      const byte = bytes[at++];
      value += (byte & 127) * unit;
      if (byte < 128) return [value, at];
    }
    return this.outside("a number that is cut short");
  }
}
