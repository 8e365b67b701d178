// A decoder (spec, 6.2): the one chain of layers that it may be, as numbers that a shader can run.
import { checkResults } from "./decoder_results.js";
import { fail } from "./errors.js";
import { FLOAT, INT32, INT8, readOnnx, UINT8 } from "./onnx.js";

const LARGEST = 64 * 2 ** 20;
// Limits of the spec (11): nodes, outputs of a layer, values and multiply-adds of a query.
const MOST_NODES = 4096, MOST_WIDTH = 8192, MOST_VALUES = 2 ** 16, MOST_WORK = 2 ** 24;
const SCALAR = [FLOAT, []], ZERO_POINT = [UINT8, []];

/**
 * { low, high, gain, offset, layers, top, unit or matrix, int8, columns, outputs }: gain and offset of
 * int8 alone; a layer is { weight, bias, rows, columns }, int8 with { step, scales }.
 */
export function readDecoder(bytes, { columns, outputs, output, precision }, where) {
  if (bytes.length > LARGEST) fail("DECODER_TOO_LARGE", where, `${bytes.length} bytes; at most ${LARGEST}`);
  const outside = (text) => fail("DECODER_PROFILE", where, `not a decoder as the format has it: ${text}`);
  const model = readOnnx(bytes, { columns, outputs, output }, outside);
  const decoder = new Chain(model, { columns, outputs, output, int8: precision === "int8" }, where, outside).decoder();
  checkResults(decoder, where);
  return decoder;
}

/** Follows the one chain from queries to the output. */
class Chain {
  constructor({ nodes, constants }, form, where, outside) {
    Object.assign(this, form, { where, outside, width: form.columns, value: "queries", values: form.outputs, work: 0 });
    if (nodes.length > MOST_NODES) outside(`${nodes.length} nodes; at most ${MOST_NODES}`);
    const names = ["queries", ...constants.map(({ name }) => name), ...nodes.map(({ output }) => output)];
    if (new Set(names).size !== names.length || names.includes("")) outside("a value made twice, or without a name");
    this.constants = new Map(constants.map((tensor) => [tensor.name, tensor]));
    this.unread = new Set(this.constants.keys());
    this.dequantizers = new Map();  // those of constants, up to the chain's next node
    this.nodes = nodes.values();
    this.advance();
  }

  /** Goes on to the chain's next node. */
  advance() {
    for (;;) {
      this.node = this.nodes.next().value;
      if (this.node?.operator !== "DequantizeLinear" || !this.constants.has(this.node.inputs[0])) return;
      this.dequantizers.set(this.node.output, this.node);
    }
  }

  get operator() {
    return this.node?.operator ?? "nothing";
  }

  /** Names of the operands of the next node, which is this operator of the value and so many constants. */
  next(operator, count) {
    const { node } = this;
    if (this.operator !== operator) this.outside(`${this.operator} where ${operator} must be`);
    if (node.inputs[0] !== this.value || node.inputs.length !== count + 1 || node.axis !== null) {
      this.outside(`${operator} of ${node.inputs.join(", ")}, not of ${this.value} and ${count} constants`);
    }
    this.value = node.output;
    this.advance();
    return node.inputs.slice(1);
  }

  /** The constants of these names, each of such a type and shape. */
  read(names, operands) {
    if (names.length !== operands.length) this.outside(`${names.length} constants where ${operands.length} must be`);
    return operands.map(([type, dims], k) => {
      const { values, ...tensor } = this.constants.get(names[k]) ?? {};
      if (!values || tensor.type !== type || tensor.dims.join() !== dims.join()) {
        this.outside(`${names[k]} is no constant of type ${type} and shape [${dims}]`);
      }
      if (type === FLOAT && !values.every(Number.isFinite)) {
        fail("DECODER_RESULT", this.where, `${names[k]} has values that are NaN or infinite`);
      }
      this.unread.delete(names[k]);
      return values;
    });
  }

  take(operator, ...operands) {
    return this.read(this.next(operator, operands.length), operands);
  }

  /** Size of the matrix of this name, which multiplies what the chain has; counts what a query takes. */
  multiply(name, { isLayer }) {
    const columns = this.constants.get(name)?.dims[1] ?? 0, rows = this.width;
    if (!(columns >= 1 && columns <= MOST_WIDTH)) this.outside(`${name} has ${columns} columns; from 1 to ${MOST_WIDTH}`);
    if (isLayer) this.values += columns;
    this.work += rows * columns;
    if (this.values > MOST_VALUES || this.work > MOST_WORK) {
      fail("DECODER_COST", this.where, `${this.values} values and ${this.work} multiply-adds of a query, or more; at most ${MOST_VALUES} and ${MOST_WORK}`);
    }
    this.width = columns;
    return { rows, columns };
  }

  decoder() {
    const row = [FLOAT, [this.columns]], { int8, columns, outputs } = this;
    const [[low], [high]] = this.take("Clip", SCALAR, SCALAR);
    const [gain] = int8 ? this.take("Mul", row) : [null];
    const [offset] = int8 ? this.take("Add", row) : [null];
    const layers = [];
    do layers.push(int8 ? this.int8Layer() : this.layer()); while (int8 ? this.operator !== "Clip" : layers.at(-1).relu);
    const [[zero], [top]] = this.take("Clip", SCALAR, SCALAR);
    this.take("Exp");
    const [[one]] = this.take("Sub", SCALAR);
    if (zero !== 0 || one !== 1) this.outside(`Clip from ${zero}, Sub of ${one}`);
    const end = this.operator === "MatMul" ? this.mixing() : { unit: this.take("Mul", SCALAR)[0][0], matrix: null };
    if (this.node || this.dequantizers.size || this.unread.size) this.outside("a node or a constant that the chain does not have");
    if (this.value !== this.output || this.width !== outputs) this.outside(`${this.width} columns of ${this.value} in the end`);
    return { low, high, gain, offset, layers, top, ...end, int8, columns, outputs };
  }

  mixing() {
    const names = this.next("MatMul", 1), { rows, columns } = this.multiply(names[0], { isLayer: false });
    return { unit: 1, matrix: this.read(names, [[FLOAT, [rows, columns]]])[0] };
  }

  layer() {
    const names = this.next("Gemm", 2), { rows, columns } = this.multiply(names[0], { isLayer: true });
    const [weight, bias] = this.read(names, [[FLOAT, [rows, columns]], [FLOAT, [columns]]]);
    const relu = this.operator === "Relu";
    if (relu) this.take("Relu");
    return { weight, bias, rows, columns, relu };
  }

  int8Layer() {
    const [[step], [zero]] = this.take("QuantizeLinear", SCALAR, ZERO_POINT);
    const [[again], [zeroAgain]] = this.take("DequantizeLinear", SCALAR, ZERO_POINT);
    if (zero || zeroAgain || step !== again) this.outside("two scales, or a zero point");
    const makers = new Map(this.dequantizers);  // those before the Gemm
    const [weights, biases] = this.next("Gemm", 2).map((name, k) => this.dequantized(makers, name, 1 - k));
    const { rows, columns } = this.multiply(weights[0], { isLayer: true });
    const [weight, scales] = this.read(weights, [[INT8, [rows, columns]], [FLOAT, [columns]]]);
    const [bias, products] = this.read(biases, [[INT32, [columns]], [FLOAT, [columns]]]);
    if (products.some((value, k) => value !== Math.fround(step * scales[k]))) this.outside("a bias with a scale of its own");
    return { weight, bias, rows, columns, step, scales, relu: false };
  }

  /** Constants of the DequantizeLinear that makes an operand of a Gemm. */
  dequantized(makers, name, axis) {
    const maker = makers.get(name);
    if (maker?.axis !== axis || !this.dequantizers.delete(name)) {
      this.outside(`${name} is no DequantizeLinear of constants along axis ${axis}`);
    }
    return maker.inputs;
  }
}
