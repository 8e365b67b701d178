// The asset in WebGPU: kernels over a band of the picture, one for hits, and for each light one for rays; the
// decoder of rna_gpu over the queries of each part; the sum in a buffer.
import { bind, buffer, compiled, dispatch, openDevice, read } from "./gpu_device.js";
import { planeWords } from "./pack_decoder.js";
import { PartEvaluator, Pipelines } from "./part_evaluator.js";
import { rayKernels, sources } from "./sources.js";

const BAND_PIXELS = 1 << 17;
const KINDS = { sun: 0, environment: 1, given: 2, aroundPoint: 3 };

export class WebGPUEngine {
  static label = "WebGPU";

  static async open(canvas) {
    const engine = new WebGPUEngine(), device = await openDevice();
    Object.assign(engine, { canvas, device, parts: [], lost: false, bandPixels: BAND_PIXELS });
    device.lost.then(({ reason, message }) => {
      engine.lost = true;
      if (!engine.closed) engine.onlost?.(`the GPU was lost (${message || reason})`);
    });
    device.addEventListener("uncapturederror", ({ error }) => { engine.error ??= error; });
    engine.context = canvas.getContext("webgpu");
    const format = navigator.gpu.getPreferredCanvasFormat();
    engine.context.configure({ device, format, alphaMode: "opaque", usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC });
    engine.pipelines = new Pipelines(device);
    engine.compiled = engine._compile(format);
    engine.compiled.catch(() => {});  // setAsset tells
    return engine;
  }

  async _compile(format) {
    const { device } = this, show = await compiled(device, sources.show);
    const [gather, scatter, shown] = await Promise.all([
      ...await this._queuePipelines(),
      device.createRenderPipelineAsync({
        layout: "auto", vertex: { module: show, entryPoint: "corner" },
        fragment: { module: show, entryPoint: "colour", targets: [{ format }] },
      }),
    ]);
    Object.assign(this, { queueKernels: { gather, scatter }, shown });
    this._makeBand();
  }

  /** Both kernels share one layout, and so one group of bindings. */
  async _queuePipelines() {
    const { device } = this, module = await compiled(device, sources.queue), visibility = GPUShaderStage.COMPUTE;
    const entries = Array.from({ length: 8 }, (_, binding) =>
      ({ binding, visibility, buffer: { type: binding ? "storage" : "uniform" } }));
    this.queueLayout = device.createBindGroupLayout({ entries });
    const layout = device.createPipelineLayout({ bindGroupLayouts: [this.queueLayout] });
    return ["gather", "scatter"].map((entryPoint) =>
      device.createComputePipelineAsync({ layout, compute: { module, entryPoint } }));
  }

  _makeBand() {
    const { device } = this, { UNIFORM } = GPUBufferUsage;
    this.view = buffer(device, 176, UNIFORM);
    this.lightRecord = buffer(device, 96, UNIFORM);
    this.queueRecord = buffer(device, 32, UNIFORM);
    this.showRecord = buffer(device, 48, UNIFORM);
    this.band = {
      rows: buffer(device, 64 * BAND_PIXELS), through: buffer(device, 16 * BAND_PIXELS), lit: buffer(device, 32 * BAND_PIXELS),
    };
    this.queue = {
      rows: buffer(device, 64 * BAND_PIXELS), answers: buffer(device, 32 * BAND_PIXELS), count: buffer(device, 4 * (BAND_PIXELS + 4)),
    };
    if (!this.images) this.setEnvironment({ values: new Float32Array(4), marginal: new Float32Array(1), width: 1, height: 1 });
  }

  /** Shows these parts; what was there before is let go. */
  async setAsset(arrays, parts) {
    const { device } = this;
    this._deleteAsset();
    const vertices = new Float32Array(arrays.places.length + arrays.normals.length);
    vertices.set(arrays.places);
    vertices.set(arrays.normals, arrays.places.length);
    const textures = new Uint32Array(arrays.records.length + Math.ceil(arrays.texels.length / 4));
    textures.set(arrays.records);
    new Uint8Array(textures.buffer).set(arrays.texels, 4 * arrays.records.length);
    this.geometry = [
      buffer(device, arrays.nodes, undefined, "the asset's hierarchy"), buffer(device, arrays.primitives, undefined, "the asset's geometry"),
      buffer(device, vertices, undefined, "the asset's geometry"), buffer(device, textures, undefined, "the asset's textures"),
    ];
    this.where = arrays.where;
    this.sceneWords = [
      arrays.places.length / 4, arrays.recordCount, arrays.records.length, parts.length,
    ];
    this.epsilon = arrays.epsilon;
    this.firsts = arrays.parts.map(({ first }) => first);
    this.raySources = rayKernels({ hasSegments: arrays.strands > 0, hasTextures: arrays.recordCount > 0 });
    const { hit, light } = this.raySources;
    const [traced, lit, , ...made] = await Promise.all([
      this.pipelines.get(hit, "trace_pixels"), this.pipelines.get(light, "light_pixels"), this.compiled,
      ...parts.map((part) => this._makePart(part)),
    ]);
    this.parts = made;
    this.kernels = { hit: traced, light: lit, ...this.queueKernels };
    this._bind();
  }

  async _makePart(part) {
    const { device, pipelines } = this;
    const planes = [0, 1, 2].map((k) => buffer(device, planeWords(part.planes, k), undefined, "a plane of features"));
    const make = (decoder, inputs) => PartEvaluator.make(device, pipelines, part, decoder, inputs, planes);
    const transport = await make(part.transport, part.inputs);
    return { planes, transport, emission: part.emission && await make(part.emission, part.emission.inputs) };
  }

  get emits() {
    return this.parts.some(({ emission }) => emission);
  }

  setEnvironment({ values, marginal, width, height }) {
    const { device } = this;
    const image = (w, h, format, data, bytes) => {
      const texture = device.createTexture({ size: [w, h], format, usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST });
      device.queue.writeTexture({ texture }, data, { bytesPerRow: bytes * w, rowsPerImage: h }, [w, h]);
      return texture;
    };
    this.images?.forEach((texture) => texture.destroy());
    this.images = [image(width, height, "rgba32float", values, 16), image(marginal.length, 1, "r32float", marginal, 4)];
    this._bind();
  }

  /** A picture of this size, empty. */
  resize(width, height) {
    if (this.target?.width === width && this.target.height === height) return;
    const capacity = width * height;
    if (!this.sums || capacity > this.capacity || capacity * 8 < this.capacity) {
      this.sums?.destroy();
      this.sums = buffer(this.device, 16 * capacity, undefined, "the picture");
      this.capacity = capacity;
      this._bind();
    }
    this.target = { width, height };
  }

  _bind() {
    if (!this.geometry || !this.sums || !this.images || !this.kernels) return;
    const { device, kernels, band, queue } = this, { rows, through, lit } = band;
    const scene = [this.view, ...this.geometry];
    // Pipelines of automatic layouts bind what their entry point uses alone.
    const group = (pipeline, k, resources) => device.createBindGroup({
      layout: pipeline.getBindGroupLayout(k),
      entries: resources.map(([binding, resource]) => ({ binding, resource: resource instanceof GPUBuffer ? { buffer: resource } : resource })),
    });
    const all = scene.map((resource, binding) => [binding, resource]);
    this.groups = {
      hit: [group(kernels.hit, 0, all), group(kernels.hit, 1, [[0, rows], [1, through]])],
      light: [
        group(kernels.light, 0, all), group(kernels.light, 1, [[0, rows], [1, through], [2, lit], [3, this.sums]]),
        group(kernels.light, 2, [[0, this.lightRecord], [1, this.images[0].createView()], [2, this.images[1].createView()]]),
      ],
      queue: [device.createBindGroup({
        layout: this.queueLayout,
        entries: [this.queueRecord, rows, through, lit, this.sums, queue.rows, queue.answers, queue.count]
          .map((own, binding) => ({ binding, resource: { buffer: own } })),
      })],
      show: bind(device, this.shown, 0, [this.showRecord, this.sums]),
    };
  }

  /** The first hits of rows `from` to `to`, the band that what follows is about. */
  trace(camera, sample, from, to) {
    this.span = { from, rows: to - from, pixels: (to - from) * this.target.width };
    this._writeView(camera, sample);
    this._run((pass) => dispatch(pass, this.kernels.hit, this.groups.hit, this.span.pixels));
  }

  /** What one light brings to the band. */
  light(light, { isFirst, countsCoverage }) {
    this._writeLight(light, isFirst, countsCoverage);
    this._run((pass) => dispatch(pass, this.kernels.light, this.groups.light, this.span.pixels));
    this._decode("transport");
  }

  emission() {
    this._decode("emission");
  }

  show({ rounds, exposure, backdrop, filmic, spread }) {
    const { width, height } = this.target, { canvas, device } = this;
    const words = Float32Array.of(
      canvas.width, canvas.height, width, height, ...backdrop, rounds, exposure, Number(filmic), spread, 0,
    );
    device.queue.writeBuffer(this.showRecord, 0, words);
    const encoder = device.createCommandEncoder();
    const view = this.context.getCurrentTexture().createView();
    const pass = encoder.beginRenderPass({ colorAttachments: [{ view, loadOp: "clear", storeOp: "store" }] });
    pass.setPipeline(this.shown);
    pass.setBindGroup(0, this.groups.show);
    pass.draw(3);
    pass.end();
    device.queue.submit([encoder.finish()]);
  }

  async done() {
    await this.device.queue.onSubmittedWorkDone();
    if (this.error) throw this.error;
  }

  /** The sum of all samples, rows from the top, RGBA. */
  async picture() {
    const { width, height } = this.target;
    return new Float32Array(await read(this.device, this.sums, 16 * width * height));
  }

  _decode(output) {
    const { device, span, target } = this;
    for (const [k, part] of this.parts.entries()) {
      const own = part[output];
      if (!own) continue;
      const words = Uint32Array.of(target.width, span.from, span.rows, k + 1, Number(output === "emission"), 0, 0, 0);
      device.queue.writeBuffer(this.queueRecord, 0, words);
      device.queue.writeBuffer(this.queue.count, 0, Uint32Array.of(0));
      this._run((pass) => {
        dispatch(pass, this.kernels.gather, this.groups.queue, span.pixels);
        own.run(pass, this.queue, span.pixels);
        dispatch(pass, this.kernels.scatter, this.groups.queue, span.pixels);
      });
    }
  }

  _run(work) {
    const encoder = this.device.createCommandEncoder(), pass = encoder.beginComputePass();
    work(pass);
    pass.end();
    this.device.queue.submit([encoder.finish()]);
  }

  _writeView({ position, corner, stepX, stepY, jitter = 1 }, sample) {
    const bytes = new ArrayBuffer(176), floats = new Float32Array(bytes), words = new Uint32Array(bytes);
    floats.set([...position, this.epsilon], 0);
    floats.set(corner, 4);
    words[7] = this.target.width;
    floats.set(stepX, 8);
    words[11] = this.span.from;
    floats.set(stepY, 12);
    words[15] = this.span.rows;
    const [normalsAt, recordCount, texelsAt, partCount] = this.sceneWords;
    words.set([sample, normalsAt, recordCount, texelsAt, partCount], 16);
    floats[21] = jitter;
    words.set(this.firsts, 24);
    this.device.queue.writeBuffer(this.view, 0, bytes);
  }

  _writeLight({ kind, direction = [0, 1, 0], colour, angle = 0, ground }, isFirst, countsCoverage) {
    const bytes = new ArrayBuffer(96), floats = new Float32Array(bytes), words = new Uint32Array(bytes);
    floats.set(direction, 0);
    words[3] = KINDS[kind];
    floats.set([...colour, ground?.height ?? 0, Math.cos(angle), Math.sin(angle), ground?.x ?? 0, ground?.z ?? 0], 4);
    floats.set([...(ground?.colour ?? [0, 0, 0]), ground?.size ?? 0], 12);
    words.set([Number(isFirst), Number(countsCoverage)], 16);
    this.device.queue.writeBuffer(this.lightRecord, 0, bytes);
  }

  _deleteAsset() {
    this.geometry?.forEach((own) => own.destroy());
    for (const { planes, transport, emission } of this.parts) {
      planes.forEach((own) => own.destroy());
      transport.delete();
      emission?.delete();
    }
    this.parts = [];
    this.geometry = null;
  }

  close() {
    this.closed = true;
    this._deleteAsset();
    this.device.destroy();
  }
}
