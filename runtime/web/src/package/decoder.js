// A decoder in the profile of the spec (6.4), as layers that a shader can run.
import { fail, NotSupported } from "./errors.js";
import { readOnnx } from "./onnx.js";

const FLOAT = 1, UINT8 = 2, INT8 = 3, INT32 = 6;
// Limits of the spec (6.2): values of constants, values and multiply-adds of a query.
const MOST_CONSTANTS = 2 ** 24, MOST_VALUES = 2 ** 16, MOST_WORK = 2 ** 24;

/**
 * { low, high, gain, offset, layers, top, unit or matrix, int8, columns, outputs }: gain and offset of
 * int8 alone; a layer is { weight, bias, rows, columns }, int8 with { step, scales }.
 */
export function readDecoder(bytes, { columns, outputs, output, precision }, where) {
  const model = readOnnx(bytes, where);
  checkInterface(model, columns, outputs, output, where);
  const quantised = model.nodes.some(({ operator }) => /^(De)?[qQ]uantizeLinear$/.test(operator));
  if (quantised !== (precision === "int8")) {
    fail("DECODER_PRECISION", where, `arithmetic that is not ${precision}`);
  }
  checkOrder(model, where);
  return new Walk(model, columns, outputs, quantised, where).decoder();
}

function checkInterface({ inputs, outputs: results }, columns, outputs, output, where) {
  const fits = (list, name, width) => list.length === 1 && list[0].name === name && list[0].type === FLOAT
    && list[0].dims.length === 2 && list[0].dims[0] === null && list[0].dims[1] === width;
  if (!fits(inputs, "queries", columns)) fail("DECODER_INPUT", where, `not one input queries [N, ${columns}]`);
  if (!fits(results, output, outputs)) fail("DECODER_OUTPUT", where, `not one output ${output} [N, ${outputs}]`);
}

const ALLOWED = new Set(`Abs Add And Atan Cast Ceil Clip Concat Constant Cos DequantizeLinear Div Elu Equal Erf Exp
Floor Gelu Gemm Greater GreaterOrEqual HardSigmoid HardSwish Identity IsInf IsNaN LayerNormalization LeakyRelu Less
LessOrEqual Log MatMul Max Min Mish Mul Neg Not Or PRelu Pow QuantizeLinear Reciprocal Relu Selu Sigmoid Sign Sin Slice
Softplus Softsign Split Sqrt Sub Sum Tanh ThresholdedRelu Where Xor`.split(/\s+/));

function checkOrder({ nodes, constants }, where) {
  const other = nodes.find(({ operator }) => !ALLOWED.has(operator));
  if (other) fail("DECODER_OPERATOR", where, `the operator ${other.operator}`);
  const made = new Set(["queries", ...constants.keys()]);
  for (const node of nodes) {
    if (node.inputs.some((name) => name && !made.has(name)) || node.outputs.some((name) => made.has(name))) {
      fail("DECODER_GRAPH", where, "nodes out of order, or a value made twice");
    }
    node.outputs.forEach((name) => made.add(name));
  }
}

/** Follows the one chain from queries to the output. */
class Walk {
  constructor({ nodes, constants }, columns, outputs, int8, where) {
    Object.assign(this, { constants, columns, outputs, int8, where, width: columns, at: 0, value: "queries" });
    const isConstant = ({ operator, inputs }) => operator === "DequantizeLinear" && constants.has(inputs[0]);
    this.dequantizers = new Map(nodes.filter(isConstant).map((node) => [node.outputs[0], node]));
    this.chain = nodes.filter((node) => !isConstant(node));
    this.values = this.work = 0;
    const sizes = [...constants.values(), ...[...this.dequantizers.values()].map(({ inputs }) => constants.get(inputs[0]))];
    const count = sizes.reduce((sum, { dims }) => sum + dims.reduce((product, side) => product * side, 1), 0);
    if (count > MOST_CONSTANTS) fail("DECODER_COST", where, `${count} values of constants; at most ${MOST_CONSTANTS}`);
    this.readers = new Map();
    for (const name of nodes.flatMap((node) => node.inputs)) this.readers.set(name, (this.readers.get(name) ?? 0) + 1);
  }

  outside(text) {
    throw new NotSupported(
      `${this.where}: this viewer runs decoders of the profile (spec, 6.4) alone: ${text} [DECODER_PROFILE]`,
    );
  }

  get operator() {
    return this.chain[this.at]?.operator;
  }

  next(operator) {
    const node = this.chain[this.at];
    if (node?.operator !== operator || node.inputs[0] !== this.value || node.outputs.length !== 1) {
      this.outside(`${node?.operator ?? "nothing"} where ${operator} must be`);
    }
    if (this.readers.get(this.value) !== 1 || Object.keys(node.attributes).length) {
      this.outside(`${operator} with attributes, or a value that is read twice`);
    }
    this.at += 1;
    this.value = node.outputs[0];
    return node.inputs.slice(1);
  }

  /** Counts a node whose result has `columns`, of products with one of `rows`. */
  spend(columns, rows = 1) {
    this.values += columns;
    this.work += rows * columns;
    if (this.values > MOST_VALUES || this.work > MOST_WORK) {
      fail("DECODER_COST", this.where, `a query takes ${this.values} values and ${this.work} multiply-adds, or more; at most ${MOST_VALUES} and ${MOST_WORK}`);
    }
  }

  constant(name, type, dims) {
    const tensor = this.constants.get(name);
    if (!tensor?.values || tensor.type !== type || tensor.dims.join() !== dims.join()) {
      this.outside(`${name ?? "nothing"} is not of type ${type} and shape [${dims}]`);
    }
    return tensor.values;
  }

  take(operator, ...operands) {
    const names = this.next(operator);
    if (operator === "MatMul") this.spend(this.outputs, this.width);
    else this.spend(this.width);
    if (names.length !== operands.length) this.outside(`${operator} of ${names.length + 1} operands`);
    return operands.map(([type, dims], k) => this.constant(names[k], type, dims));
  }

  decoder() {
    const scalar = [FLOAT, []], row = [FLOAT, [this.columns]];
    const [[low], [high]] = this.take("Clip", scalar, scalar);
    const gain = this.int8 ? this.take("Mul", row)[0] : null;
    const offset = this.int8 ? this.take("Add", row)[0] : null;
    const layers = this.layers();
    const [[zero], [top]] = this.take("Clip", scalar, scalar);
    this.take("Exp");
    const [[one]] = this.take("Sub", scalar);
    if (zero !== 0 || one !== 1) this.outside(`Clip from ${zero}, Sub of ${one}`);
    const [last] = this.operator === "MatMul"
      ? this.take("MatMul", [FLOAT, [this.width, this.outputs]])
      : this.take("Mul", scalar);
    if (this.operator || this.dequantizers.size) this.outside("nodes behind the last one");
    if (last.length === 1 && this.width !== this.outputs) {
      fail("DECODER_LOAD", this.where, `${this.width} values for ${this.outputs} outputs`);
    }
    const result = last.length === 1 ? { unit: last[0], matrix: null } : { unit: 1, matrix: last };
    return { low, high, gain, offset, layers, top, ...result, int8: this.int8, columns: this.columns, outputs: this.outputs };
  }

  layers() {
    const layers = [];
    for (;;) {
      const step = this.int8 ? this.quantized() : null;
      layers.push(this.gemm(step));
      if (this.operator === "Clip") return layers;
      if (!this.int8) this.take("Relu");
    }
  }

  quantized() {
    const operands = [[FLOAT, []], [UINT8, []]];
    const [[step], [zero]] = this.take("QuantizeLinear", ...operands);
    const [[again], [zeroAgain]] = this.take("DequantizeLinear", ...operands);
    if (zero || zeroAgain || step !== again) this.outside("two scales, or a zero point");
    return step;
  }

  gemm(step) {
    const names = this.next("Gemm");
    if (names.length !== 2) this.outside(`Gemm of ${names.length + 1} operands`);
    const columnsOf = (name) => this.constants.get(name)?.dims.at(-1) ?? 0;
    const rows = this.width;
    if (!this.int8) {
      const columns = columnsOf(names[0]);
      this.spend(columns, rows);
      this.width = columns;
      return {
        weight: this.fitting(names[0], FLOAT, rows, columns), bias: this.constant(names[1], FLOAT, [columns]), rows, columns,
      };
    }
    const [weightName, scaleName] = this.dequantized(names[0], 1), [biasName, biasScale] = this.dequantized(names[1], 0);
    const columns = columnsOf(weightName);
    this.spend(columns, rows);
    const scales = this.constant(scaleName, FLOAT, [columns]), products = this.constant(biasScale, FLOAT, [columns]);
    if (products.some((value, k) => value !== Math.fround(step * scales[k]))) this.outside("a bias with a scale of its own");
    this.width = columns;
    return {
      weight: this.fitting(weightName, INT8, rows, columns), bias: this.constant(biasName, INT32, [columns]), rows, columns, step, scales,
    };
  }

  fitting(name, type, rows, columns) {
    const dims = this.constants.get(name)?.dims ?? [];
    if (dims.length === 2 && dims[0] !== rows) {
      fail("DECODER_LOAD", this.where, `weights for ${dims[0]} values, of which there are ${rows}`);
    }
    return this.constant(name, type, [rows, columns]);
  }

  dequantized(name, axis) {
    const maker = this.dequantizers.get(name);
    this.dequantizers.delete(name);
    if (maker?.attributes.axis !== axis || maker.inputs.length !== 2 || this.readers.get(name) !== 1) {
      this.outside(`${name} is no DequantizeLinear of constants along axis ${axis}`);
    }
    return maker.inputs;
  }
}
