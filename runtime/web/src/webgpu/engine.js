// The asset in WebGPU: kernels over a band of the picture, one for hits, and for each light one for rays; the
// decoder of rna_gpu over the queries of each part; the sum in a buffer.
import { planeWords } from "../decoder/pack_decoder.js";
import { bytesOf, constants, lightNumbers, packed, viewerLights } from "../decoder/records.js";
import { bind, bindGroup, buffer, compiled, dispatch, groupLayout, openDevice, read } from "./gpu_device.js";
import { PartEvaluator, Pipelines } from "./part_evaluator.js";
import { LobeLight, PartLobes } from "./part_lobes.js";
import { rayKernels, sources } from "./sources.js";

const BAND_PIXELS = 1 << 17;
const FORMS = ["transport", "visible", "shadowed", "emission", "environment"];  // FORM_TRANSPORT and so on of band.wgsl
const LIT = ["transport", "visible", "shadowed"];

export class WebGPUEngine {
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
    engine.context.configure({ device, format, alphaMode: "premultiplied", usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC });
    engine.pipelines = new Pipelines(device);
    engine.compiled = engine._compile(format);
    engine.compiled.catch(() => {});  // setAsset tells
    return engine;
  }

  async _compile(format) {
    const { device } = this, show = await compiled(device, sources.show);
    const [uniform, storage, readOnly] = ["uniform", "storage", "read-only-storage"];
    const band = groupLayout(device, { 0: storage, 1: uniform });
    // Eight storage buffers, which every device has.
    this.rayLayout = [
      groupLayout(device, { 0: uniform, 4: readOnly, 5: readOnly }), band,
      groupLayout(device, { 0: readOnly, 1: readOnly, 2: readOnly, 3: readOnly, 4: readOnly }),
    ];
    this.queueLayout = [groupLayout(device, { 0: uniform, 2: storage }), band, groupLayout(device, { 0: storage, 1: storage, 2: storage })];
    this.lookLayout = [...this.queueLayout.slice(0, 2), groupLayout(device, { 0: storage, 1: storage })];
    const [begin, gather, scatter, shown] = await Promise.all([
      ...["begin", "gather", "scatter"].map((name) => this.pipelines.get(sources.queue, name, this.queueLayout)),
      device.createRenderPipelineAsync({
        layout: "auto", vertex: { module: show, entryPoint: "corner" },
        fragment: { module: show, entryPoint: "colour", targets: [{ format }] },
      }),
    ]);
    Object.assign(this, { queueKernels: { begin, gather, scatter }, shown });
    this._makeBand();
  }

  _makeBand() {
    const { device } = this, { UNIFORM } = GPUBufferUsage;
    this.frameRecord = buffer(device, packed("Frame", {}), UNIFORM);
    this.viewRecord = buffer(device, bytesOf("View"), UNIFORM);
    this.showRecord = buffer(device, bytesOf("Show"), UNIFORM);
    this.band = buffer(device, bytesOf("Pixel") * BAND_PIXELS);
    this.queue = {
      rows: buffer(device, bytesOf("RnaRow") * BAND_PIXELS), answers: buffer(device, 32 * BAND_PIXELS), count: buffer(device, 4 * (BAND_PIXELS + 4)),
    };
    this._bind();
  }

  /** Shows these parts, with glass if there is some; what was there before is let go. building: sceneArrays of them; shaders compile meanwhile. */
  async setAsset(building, { parts, glass }) {
    this._deleteAsset();
    await this.compiled;
    const hasLobes = !glass && parts.every(({ environment }) => environment);  // lobes know nothing of glass in the way
    this.lobeLight = hasLobes ? new LobeLight(this) : null;
    const making = Promise.all(parts.map((part) => this._makePart(part)));
    const ready = Promise.all([making, this._compileKernels(parts, !!glass, hasLobes), this._storeGeometry(building, parts)]);
    ready.catch(() => making.then((made) => made.forEach(deletePart)).catch(() => {}));
    const [made] = await ready;
    Object.assign(this, { parts: made, hasLobes, texel: hasLobes ? Math.max(...parts.map(texelOf)) : 0 });
    this._makeSums();
  }

  async _storeGeometry(building, parts) {
    const arrays = await building;
    performance.mark("hierarchy");
    const { device } = this, store = (content, what) => buffer(device, content, undefined, `the asset's ${what}`);
    this.geometry = [
      store(arrays.nodes, "hierarchy"), store(arrays.primitives, "geometry"), store(arrays.points, "geometry"),
      store(instances(arrays), "geometry"), store(arrays.normals, "geometry"),
    ];
    this._storeSurfaces(arrays);
    await this.lobeLight?.begin(arrays, parts);
  }

  /** Those of rays, and with lobes those of the first look. */
  async _compileKernels(parts, hasGlass, hasLobes) {
    const { pipelines } = this, isThere = (kind) => parts.some(kind);
    this.raySources = rayKernels({ hasSegments: isThere(({ kind }) => kind === "fiber"), hasTextures: isThere(hasTextures), hasBaseColor: isThere(hasBaseColor), hasGlass });
    const look = hasLobes ? ["remember", "smooth_edges"] : [], countsNearby = isThere(({ lengths }) => lengths);
    const [hit, light, nearby, remember, smooth] = await Promise.all([
      pipelines.get(this.raySources.hit, "trace_pixels", this.rayLayout), pipelines.get(this.raySources.light, "light_pixels", this.rayLayout),
      countsNearby && pipelines.get(this.raySources.nearby, "find_nearby", this.rayLayout),
      ...look.map((name) => pipelines.get(sources.look, name, this.lookLayout)),
    ]);
    this.kernels = { hit, light, nearby, remember, smooth, ...this.queueKernels };
  }

  async _makePart(part) {
    const { device, pipelines } = this;
    const upload = (stored) => [0, 1, 2].map((k) => buffer(device, planeWords(stored, k), undefined, "a plane of features"));
    const planes = upload(part.planes), lobes = part.environment;
    const ofLobes = this.lobeLight && lobes.planes !== part.planes ? upload(lobes.planes) : null;
    const forms = Object.keys(part.decoders);
    const [environment, ...made] = await Promise.all([
      this.lobeLight && PartLobes.make(device, pipelines, part, ofLobes ?? planes, this.lobeLight),
      ...forms.map((form) => PartEvaluator.make(device, pipelines, part, form, planes)),
    ]);
    return { lengths: part.lengths, planes: [...planes, ...(ofLobes ?? [])], environment, ...Object.fromEntries(forms.map((form, k) => [form, made[k]])) };
  }

  get emits() {
    return this.parts.some(({ emission }) => emission);
  }

  /** Other images or a tint in the arrays of the asset that is shown. */
  setSurfaces(arrays) {
    if (!this.geometry) return;
    this._storeSurfaces(arrays);
    this._bind();
  }

  _storeSurfaces(arrays) {
    const { device } = this, { table } = arrays;
    this.table?.destroy();
    this.table = buffer(device, 4 * table.length + bytesOf("Light"));
    device.queue.writeBuffer(this.table, 0, table);
    Object.assign(this, { arrays, lightsAt: table.length / 4 });
    this._storeImages();
  }

  setEnvironment(environment) {
    this.environment = environment;
    this._storeImages();
    this._bind();
  }

  /** Texels of the asset's textures, and the environment behind them. */
  _storeImages() {
    if (!this.geometry) return;
    const { images } = this.arrays, floats = this.environment?.floats ?? new Float32Array(0);
    this.images?.destroy();
    this.images = buffer(this.device, 4 * (images.length + floats.length), undefined, "the store of images");
    this.device.queue.writeBuffer(this.images, 0, images);
    this.device.queue.writeBuffer(this.images, 4 * images.length, floats);
  }

  /** A picture of this size, empty; its first look may be as large as the canvas. */
  resize(width, height) {
    this.target = { width, height };
    const capacity = Math.max(width * height, this.hasLobes ? this.canvas.width * this.canvas.height : 0);
    if (this.sums && capacity <= this.capacity && capacity * 8 >= this.capacity) return;
    this.capacity = capacity;
    this._makeSums();
  }

  /** The sum of the samples; and the first look and what its rays met, where the asset has lobes. */
  _makeSums() {
    if (!this.capacity) return;
    for (const one of [this.sums, this.firstLook, this.seen]) one?.destroy();
    const make = (pixels) => buffer(this.device, 16 * pixels, undefined, "the picture");
    const more = this.hasLobes ? this.capacity : 1;
    Object.assign(this, { sums: make(this.capacity), firstLook: make(more), seen: make(more) });
    this._bind();
  }

  _bind() {
    if (!this.geometry || !this.sums || !this.band || !this.kernels) return;
    const { device, rayLayout, queueLayout, queue } = this;
    const band = bindGroup(device, rayLayout[1], { 0: this.band, 1: this.viewRecord });
    const queries = bindGroup(device, queueLayout[2], [queue.rows, queue.answers, queue.count]);
    const sums = bindGroup(device, queueLayout[0], { 0: this.frameRecord, 2: this.sums });
    this.groups = {
      rays: [
        bindGroup(device, rayLayout[0], { 0: this.frameRecord, 4: this.table, 5: this.images }), band,
        bindGroup(device, rayLayout[2], this.geometry),
      ],
      queue: [sums, band, queries], look: [sums, band, bindGroup(device, this.lookLayout[2], [this.seen, this.firstLook])],
      show: bind(device, this.shown, 0, [this.showRecord, this.sums, this.firstLook, this.images]),
    };
  }

  /** The first hits of rows `from` to `to` of a picture so wide, the band that what follows is about. */
  trace(camera, sample, from, to, width = this.target.width) {
    this.span = { first: from * width, pixels: (to - from) * width, jitter: camera.jitter ?? 1, shift: camera.shift ?? [0, 0] };
    this._writeFrame(camera, sample, width);
    this._writeView({});
    this._run((pass) => dispatch(pass, this.kernels.hit, this.groups.rays, this.span.pixels));
  }

  /** Adds one light to the band. */
  light(light, { isFirst, countsCoverage, number }) {
    this._writeLight(light);
    this.view = { ...light, isFirst, countsCoverage, number };
    this._writeView(this.view);
    this._run((pass) => {
      dispatch(pass, this.kernels.light, this.groups.rays, this.span.pixels);
      dispatch(pass, this.kernels.begin, this.groups.queue, this.span.pixels);
    });
    if (light.kind === "mirror") this.lobeLight.set(light);
    else this._findNearby();
    for (const form of light.kind === "mirror" ? ["environment"] : LIT) this._decode(form);
  }

  emission() {
    this._decode("emission");
  }

  /** Keeps what the band's rays met: those of the first look, whose light is in the sums. */
  remember() {
    this._run((pass) => dispatch(pass, this.kernels.remember, this.groups.look, this.span.pixels));
  }

  /** Adds one of `shares` rays a pixel, those of the band, to the first look. size: of its picture; its light is the target's. */
  smoothEdges(shares, isFirst, size) {
    this._writeView({ shares, isFirst, size });
    this._run((pass) => dispatch(pass, this.kernels.smooth, this.groups.look, this.span.pixels));
  }

  /** firstLook: its share in what is shown, 1 where there are no samples. rowsAhead: from the top, with one sample more. */
  show({ rounds, firstLook, rowsAhead, exposure, backdrop, filmic, spread, camera, sky }) {
    const { width, height } = camera, { canvas, device } = this;
    device.queue.writeBuffer(this.showRecord, 0, packed("Show", {
      size: [canvas.width, canvas.height], picture: [width, height], backdrop, rounds, rows_ahead: rowsAhead, exposure, filmic: Number(filmic), spread, first_look: firstLook,
      ...(sky && this._sky(camera, sky)),
    }));
    const encoder = device.createCommandEncoder();
    const view = this.context.getCurrentTexture().createView();
    const pass = encoder.beginRenderPass({ colorAttachments: [{ view, loadOp: "clear", storeOp: "store" }] });
    pass.setPipeline(this.shown);
    pass.setBindGroup(0, this.groups.show);
    pass.draw(3);
    pass.end();
    device.queue.submit([encoder.finish()]);
  }

  /** The environment behind the asset. strength: of its radiance; angle: of its turn, radians. */
  _sky({ corner, stepX, stepY, width, height }, { strength, angle }) {
    const { environment, arrays } = this, { places } = environment;
    return {
      corner, across: stepX.map((value) => value * width), down: stepY.map((value) => value * height), sky: strength,
      sky_size: [environment.width, environment.height], sky_turn: [Math.cos(angle), Math.sin(angle)], sky_texels: arrays.images.length + places[0],
    };
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

  _findNearby() {
    for (const [k, { lengths }] of this.parts.entries()) {
      if (!lengths) continue;
      this._writeView({ ...this.view, part: k + 1, lengths });
      this._run((pass) => dispatch(pass, this.kernels.nearby, this.groups.rays, this.span.pixels));
    }
  }

  _decode(form) {
    for (const [k, part] of this.parts.entries()) {
      const decoder = part[form];
      if (!decoder) continue;
      this._writeView({ ...this.view, part: k + 1, form: FORMS.indexOf(form) });
      this.device.queue.writeBuffer(this.queue.count, 0, Uint32Array.of(0));
      this._run((pass) => {
        dispatch(pass, this.kernels.gather, this.groups.queue, this.span.pixels);
        decoder.run(pass, this.queue, this.span.pixels);
        dispatch(pass, this.kernels.scatter, this.groups.queue, this.span.pixels);
      });
    }
  }

  _run(work) {
    const encoder = this.device.createCommandEncoder(), pass = encoder.beginComputePass();
    work(pass);
    pass.end();
    this.device.queue.submit([encoder.finish()]);
  }

  /** rna_gpu's Frame: render/frame.wgsl. Images are averaged over what a sample stands for, so that print becomes sharper. */
  _writeFrame({ position, corner, stepX, stepY }, sample, width) {
    const { lightsAt, arrays, span } = this;
    this.device.queue.writeBuffer(this.frameRecord, 0, packed("Frame", {
      camera: position, corner, step_x: stepX, step_y: stepY, width, paths: span.pixels, sample, branches: 1, depth: 1, rays: constants.CAMERA_RAY,
      flags: arrays.transmits ? constants.TRANSMITS : 0, textures: arrays.texturesAt, lights: lightsAt, spread: Math.hypot(...stepY) / Math.sqrt(span.jitter > 0 ? sample + 1 : 1),
    }));
  }

  _writeView({ kind = "sun", direction = [0, 0, 0], colour = [0, 0, 0], ground, isFirst = false, countsCoverage = false, part = 0, form = 0, shares = 1, size = this.target, lengths = [0, 0, 0], number = 0 }) {
    const { first, jitter, shift = [0, 0] } = this.span, { width, height } = this.target;
    const under = ground && { ground: ground.height, ground_colour: ground.colour, ground_size: ground.size, middle: [ground.x, ground.z] };
    this.device.queue.writeBuffer(this.viewRecord, 0, packed("View", {
      first, jitter, kind: viewerLights[kind], is_first: Number(isFirst), direction, counts_coverage: Number(countsCoverage), colour, part,
      form, shift, shares, texel: this.texel ?? 0,
      light_width: width, light_height: height, light_scale: [width / size.width, height / size.height], lengths, number, ...under,
    }));
  }

  /** The environment as light 0 of the table. */
  _writeLight({ angle, colour }) {
    if (angle === undefined) return;
    const { width, height, total, places } = this.environment, turn = { turn_cosine: Math.cos(angle), turn_sine: Math.sin(angle) };
    const numbers = lightNumbers("image", { colour, ...turn, total, rows: height, columns: width });
    this.device.queue.writeBuffer(this.table, 16 * this.lightsAt, packed("Light", {
      kind: constants.IMAGE, group: constants.NONE, numbers, places: places.map((place) => place + this.arrays.images.length),
    }));
  }

  _deleteAsset() {
    for (const one of [...(this.geometry ?? []), this.table, this.images]) one?.destroy();
    this.lobeLight?.delete();
    this.parts.forEach(deletePart);
    this.parts = [];
    this.geometry = this.images = this.table = null;
  }

  close() {
    this.closed = true;
    this._deleteAsset();
    this.device.destroy();
  }
}

function deletePart({ lengths, planes, ...decoders }) {
  planes.forEach((plane) => plane.destroy());
  for (const one of Object.values(decoders)) one?.delete();
}

const hasTextures = ({ transmittance, normalMaps }) => transmittance.length + normalMaps.length > 0;
/** Width of a texel of the planes of a part's lobes. */
const texelOf = ({ bounds: { min, max }, environment }) => Math.max(...max.map((high, k) => high - min[k])) / environment.planes.resolution;
const hasBaseColor = ({ baseColor }) => baseColor.length > 0;

/** The asset and the glass, where they stand in the world; node 0 is above them. */
function instances({ glassRoot, extent }) {
  const stands = { to_object: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], rotation: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], scale: 1 };
  const rays = constants.CAMERA_RAY | constants.INDIRECT_RAY, rows = [1, glassRoot ?? 1].map((root) => packed("RnaInstance", { ...stands, root, rays, extent }));
  return Uint32Array.from(rows.flatMap((row) => [...row]));
}
