// ONNX models (spec, 6.2): nodes and constants out of the protobuf message.
import { fail } from "./errors.js";
import { typed } from "./tensors.js";

const TYPES = { 1: Float32Array, 2: Uint8Array, 3: Int8Array, 6: Int32Array };
const LARGEST = 64 * 2 ** 20, MOST_NODES = 4096, MOST_FIELDS = 2 ** 18;

/** { nodes, constants, inputs, outputs }: what the graph holds. `where`: the entry. */
export function readOnnx(bytes, where) {
  if (bytes.length > LARGEST) fail("DECODER_TOO_LARGE", where, `${bytes.length} bytes`);
  const wrong = (text) => fail("DECODER_NOT_ONNX", where, text);
  const reader = new Reader(wrong);
  const model = reader.message(bytes, { 1: "one", 7: "one", 8: "many", 20: "many", 25: "many" });
  if (!model[7] || !model[1]) wrong("no graph, or no IR version");
  if (model[20].length || model[25].length) fail("DECODER_NESTED", where, "functions or training information");
  checkVersions(model, reader, where);
  const graph = reader.message(model[7], { 1: "many", 5: "many", 11: "many", 12: "many", 15: "many" });
  if (graph[15].length) fail("DECODER_NESTED", where, "sparse tensors");
  if (graph[1].length > MOST_NODES) fail("DECODER_GRAPH", where, `${graph[1].length} nodes`);
  const nodes = graph[1].map((message) => readNode(reader, message, where));
  const constants = new Map();
  for (const message of graph[5]) {
    const tensor = readTensor(reader, message, where);
    if (constants.has(tensor.name)) fail("DECODER_GRAPH", where, `${tensor.name} is there twice`);
    constants.set(tensor.name, tensor);
  }
  return {
    nodes, constants,
    inputs: graph[11].map((message) => readValue(reader, message)),
    outputs: graph[12].map((message) => readValue(reader, message)),
  };
}

function checkVersions(model, reader, where) {
  const version = Number(model[1]);
  if (!(version >= 7 && version <= 10)) fail("DECODER_VERSION", where, `IR version ${version}`);
  const sets = model[8].map((message) => reader.message(message, { 1: "one", 2: "one" }));
  const domains = sets.map((set) => reader.text(set[1]));
  if (domains.some((domain) => domain !== "" && domain !== "ai.onnx")) {
    fail("DECODER_DOMAIN", where, `operators of ${domains.join(", ")}`);
  }
  const opset = Number(sets[0]?.[2] ?? 0);
  if (sets.length !== 1 || opset < 13 || opset > 21) fail("DECODER_VERSION", where, `operator set ${opset}`);
}

function readNode(reader, message, where) {
  const node = reader.message(message, { 1: "many", 2: "many", 4: "one", 5: "many", 7: "one" });
  const domain = reader.text(node[7]);
  if (domain !== "" && domain !== "ai.onnx") fail("DECODER_DOMAIN", where, `an operator of ${domain}`);
  const attributes = {};
  for (const attribute of node[5]) {
    const { 1: name, 3: integer, 5: tensor, 6: graph, 11: graphs } = reader.message(
      attribute, { 1: "one", 3: "one", 5: "one", 6: "one", 11: "many" },
    );
    if (graph || graphs.length) fail("DECODER_NESTED", where, "a graph within a node");
    if (tensor) readTensor(reader, tensor, where);
    attributes[reader.text(name)] = integer === undefined ? null : Number(BigInt.asIntN(64, integer));
  }
  return { operator: reader.text(node[4]), inputs: node[1].map(reader.text), outputs: node[2].map(reader.text), attributes };
}

function readTensor(reader, message, where) {
  const tensor = reader.message(message, { 1: "numbers", 2: "one", 8: "one", 9: "one", 13: "many", 14: "one" });
  if (tensor[13].length || tensor[14]) fail("DECODER_EXTERNAL", where, "data outside the file");
  const dims = tensor[1].map(Number), type = Number(tensor[2] ?? 0);
  if (dims.length > 2 || dims.some((side) => side > 8192) || ![1, 2, 3, 6, 7, 9, 10].includes(type)) {
    fail("DECODER_TENSOR", where, `a tensor of type ${type} and shape [${dims}]`);
  }
  const count = dims.reduce((product, side) => product * side, 1), Type = TYPES[type];
  const whole = Type && tensor[9] instanceof Uint8Array && tensor[9].length === count * Type.BYTES_PER_ELEMENT;
  return { name: reader.text(tensor[8]), type, dims, values: whole ? typed(Type, tensor[9], 0, count) : null };
}

function readValue(reader, message) {
  const value = reader.message(message, { 1: "one", 2: "one" });
  const type = reader.message(value[2] ?? new Uint8Array(), { 1: "one" });
  const tensor = reader.message(type[1] ?? new Uint8Array(), { 1: "one", 2: "one" });
  const shape = reader.message(tensor[2] ?? new Uint8Array(), { 1: "many" });
  const dims = shape[1].map((dimension) => {
    const { 1: number, 2: name } = reader.message(dimension, { 1: "one", 2: "one" });
    if (name !== undefined) reader.text(name);
    return number === undefined ? null : Number(number);
  });
  return { name: reader.text(value[1]), type: Number(tensor[1] ?? 0), dims };
}

/** Protobuf messages: fields by number, of which `wanted` says "one", "many" or "numbers". */
class Reader {
  constructor(wrong) {
    this.wrong = wrong;
    this.fields = 0;
    this.text = (value = new Uint8Array()) => {
      if (!(value instanceof Uint8Array)) return wrong("a name that is no text");
      try {
        return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(value);
      } catch {
        return wrong("a name that is no UTF-8");
      }
    };
  }

  message(bytes, wanted) {
    if (!(bytes instanceof Uint8Array)) this.wrong("a message that is a number");
    const found = {};
    for (const [field, how] of Object.entries(wanted)) if (how !== "one") found[field] = [];
    for (let at = 0; at < bytes.length;) {
      if (++this.fields > MOST_FIELDS) this.wrong("too many fields");
      let key, value;
      [key, at] = this.varint(bytes, at);
      [value, at] = this.value(bytes, at, Number(key & 7n));
      this.keep(found, Number(key >> 3n), value, wanted);
    }
    return found;
  }

  keep(found, field, value, wanted) {
    const how = wanted[field];
    if (how === "many") found[field].push(value);
    else if (how === "one") {
      if (found[field] !== undefined) this.wrong(`the field ${field} twice`);
      found[field] = value;
    } else if (how === "numbers" && value instanceof Uint8Array) {  // packed
      for (let at = 0, number; at < value.length;) {
        [number, at] = this.varint(value, at);
        found[field].push(number);
      }
    } else if (how === "numbers") found[field].push(value);
  }

  value(bytes, at, type) {
    if (type === 0) return this.varint(bytes, at);
    let length = { 1: 8, 5: 4 }[type];
    if (type === 2) {
      [length, at] = this.varint(bytes, at);
      length = Number(length);
    }
    if (length === undefined || at + length > bytes.length) this.wrong("a field that is cut short");
    return [bytes.subarray(at, at + length), at + length];
  }

  varint(bytes, at) {
    let value = 0n;
    for (let shift = 0n; shift < 70n; shift += 7n) {
      if (at >= bytes.length) break;
      const byte = bytes[at++];
      value |= BigInt(byte & 127) << shift;
      if (byte < 128) return [BigInt.asUintN(64, value), at];
    }
    return this.wrong("a number that is cut short");
  }
}
