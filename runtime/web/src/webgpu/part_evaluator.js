// A decoder of a part by rna_evaluate.
import { packDecoder } from "../decoder/pack_decoder.js";
import { constants as limits } from "../decoder/records.js";
import { bind, buffer, compiled, dispatch } from "./gpu_device.js";
import { compose } from "./sources.js";

/** Pipelines by their source: parts and tiers that are alike share them. */
export class Pipelines {
  constructor(device) {
    this.device = device;
    this.made = new Map();
  }

  /** groups: layouts of the bindings; automatic by default. */
  get(code, entryPoint, groups) {
    const key = `${entryPoint}\n${code}`;
    if (!this.made.has(key)) this.made.set(key, this._make(code, entryPoint, groups));
    return this.made.get(key);
  }

  async _make(code, entryPoint, groups) {
    const module = await compiled(this.device, code);
    const layout = groups ? this.device.createPipelineLayout({ bindGroupLayouts: groups }) : "auto";
    return this.device.createComputePipelineAsync({ layout, compute: { module, entryPoint } });
  }
}

export class PartEvaluator {
  static make(device, pipelines, part, form, planes) {
    const decoder = part.decoders[form];
    const constants = { RNA_COLOURS: decoder.colours, RNA_STRIDE: form === "emission" ? 1 : 2, RNA_FIRST: 0 };  // visible and shadowed light share a pipeline
    const what = { constants, parts: [part.kind, "evaluate"], kernel: "", entryPoint: "rna_evaluate" };
    return this.of(device, pipelines, packDecoder(part, decoder, decoder.inputs), planes, what);
  }

  /** A kernel over rows: what packDecoder gives, and constants and parts of the module, with more WGSL behind them. */
  static async of(device, pipelines, { weights, record, groups }, planes, { constants, parts, kernel, entryPoint }) {
    const evaluator = new this(), { UNIFORM_WEIGHTS } = limits, fits = weights.length / 4 <= UNIFORM_WEIGHTS;
    const file = fits ? "weights_uniform.wgsl" : "weights_storage.wgsl";
    evaluator.pipeline = await pipelines.get(compose({ RNA_GROUPS: groups, ...constants }, file, ...parts) + kernel, entryPoint);
    const { UNIFORM, STORAGE } = GPUBufferUsage;
    const padded = fits ? new Float32Array(4 * UNIFORM_WEIGHTS) : weights;
    if (fits) padded.set(weights);
    evaluator.buffers = [
      buffer(device, record, UNIFORM, "a decoder"), buffer(device, padded, fits ? UNIFORM : STORAGE, "a decoder"),
    ];
    evaluator.part = bind(device, evaluator.pipeline, 0, [...evaluator.buffers, ...planes]);
    evaluator.device = device;
    return evaluator;
  }

  /** Answers of at most `most` rows, of which the first word of `count` says how many there are. */
  run(pass, { rows, answers, count }, most) {
    this.dispatch(pass, [rows, answers, count], most);
  }

  dispatch(pass, buffers, most, more = []) {
    this.bound ??= bind(this.device, this.pipeline, 1, buffers);
    dispatch(pass, this.pipeline, [this.part, this.bound, ...more], most);
  }

  delete() {
    for (const one of this.buffers) one.destroy();
  }
}
