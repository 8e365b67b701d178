// Light from whole environments by a part's lobes: one query and one look-up a lobe in a prefiltered environment.
import { packDecoder } from "../decoder/pack_decoder.js";
import { bytesOf, packed } from "../decoder/records.js";
import { LEAST_KAPPA, LEVELS_AN_OCTAVE } from "../light/prefilter.js";
import { VISIBILITY_COLUMNS } from "../package/environment_form.js";
import { bindGroup, buffer, dispatch, groupLayout } from "./gpu_device.js";
import { PartEvaluator } from "./part_evaluator.js";
import { sources } from "./sources.js";

const [uniform, storage, readOnly] = ["uniform", "storage", "read-only-storage"];

/** Data that the lobes of all parts share: harmonics of the visibility, and the environment. */
export class LobeLight {
  constructor(engine) {
    const { device, bandPixels } = engine;
    Object.assign(this, { device, engine, rest: null });
    this.columns = buffer(device, 4 * VISIBILITY_COLUMNS * bandPixels);
    this.record = buffer(device, bytesOf("LobeLight"), GPUBufferUsage.UNIFORM);
    this.layouts = [
      groupLayout(device, { 0: uniform }), groupLayout(device, { 0: storage, 1: uniform }),
      groupLayout(device, { 0: readOnly, 1: readOnly, 2: readOnly, 3: storage }),
    ];
    this.sampler = device.createSampler({ addressModeU: "repeat", magFilter: "linear", minFilter: "linear" });
  }

  /** The visibility at the points of all parts. */
  async begin(arrays, parts) {
    const harmonics = new Int8Array(4 * arrays.points.length);  // 16 a point
    parts.forEach(({ environment }, k) => harmonics.set(environment.harmonics ?? [], 16 * arrays.parts[k].point));
    this.harmonics = buffer(this.device, harmonics, undefined, "the asset's visibility");
    this.columnKernel = await this.engine.pipelines.get(sources.columns, "write_visibility", this.layouts);
  }

  /** rest: of firstLight. turn: of the image about +y, radians. radiance: of what is 1 in it. */
  set({ rest, turn, radiance }) {
    const { device } = this, { texels, width, height, levels, unit } = rest;
    if (this.rest !== rest) {
      this.texture?.destroy();
      this.texture = device.createTexture({
        size: [width, height, levels], format: "rgba16float", usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST,
      });
      device.queue.writeTexture({ texture: this.texture }, texels, { bytesPerRow: 8 * width, rowsPerImage: height }, [width, height, levels]);
      this.rest = rest;
    }
    device.queue.writeBuffer(this.record, 0, packed("LobeLight", {
      colour: radiance.map((value) => value * unit), levels, turn: [Math.cos(turn), Math.sin(turn)],
      least_kappa: LEAST_KAPPA, an_octave: LEVELS_AN_OCTAVE,
    }));
  }

  /** The columns of at most `most` rows. */
  run(pass, { count }, most) {
    const { engine: { frameRecord, band, viewRecord, geometry }, device, layouts } = this;
    this.groups ??= [
      [frameRecord], [band, viewRecord], [count, geometry[1], this.harmonics, this.columns],
    ].map((buffers, k) => bindGroup(device, layouts[k], buffers));
    dispatch(pass, this.columnKernel, this.groups, most);
  }

  delete() {
    for (const one of [this.harmonics, this.columns, this.record, this.texture]) one?.destroy();
  }
}

export class PartLobes extends PartEvaluator {
  static async make(device, pipelines, part, planes, shared) {
    const { environment: form } = part, more = form.harmonics ? VISIBILITY_COLUMNS : 0;
    const made = await super.of(device, pipelines, packDecoder({ ...part, planes: form.planes }, form, form.inputs, more), planes, {
      constants: { RNA_LOBES: form.lobes, RNA_IS_FIBER: Number(part.kind === "fiber"), RNA_VISIBILITY_GROUPS: more / 4 },
      parts: [part.kind], kernel: sources.lobes, entryPoint: "light_by_lobes",
    });
    return Object.assign(made, { shared });
  }

  run(pass, queue, most) {
    const { shared, device, pipeline } = this;
    shared.run(pass, queue, most);
    if (this.texture !== shared.texture) {
      this.texture = shared.texture;
      const resources = [{ buffer: shared.record }, shared.texture.createView({ dimension: "2d-array" }), shared.sampler];
      this.lit = device.createBindGroup({
        layout: pipeline.getBindGroupLayout(2), entries: resources.map((resource, binding) => ({ binding, resource })),
      });
    }
    this.dispatch(pass, [queue.rows, queue.answers, queue.count, shared.columns], most, [this.lit]);
  }
}
