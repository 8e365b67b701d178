// The asset in WebGL2: passes over float images, one for hits, and for each light one for rays, one a part for its
// decoder, one for the sum.
import { viewerLights } from "../decoder/records.js";
import { finished, openContext, pass, Program, table, Target } from "./context.js";
import { PartProgram, uploadPlanes } from "./part_program.js";
import { sources } from "./sources.js";

const BAND_PIXELS = 1 << 17;

export class WebGLEngine {
  static label = "WebGL2";

  static async open(canvas) {
    const gl = openContext(canvas), engine = new WebGLEngine();
    Object.assign(engine, { gl, canvas, parts: [], target: null, lost: false, bandPixels: BAND_PIXELS });
    engine.programs = Object.fromEntries(
      ["hit", "light", "normals", "clear", "combine", "show"].map((name) => [name, new Program(gl, sources[name])]),
    );
    for (const program of Object.values(engine.programs)) program.check();
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      engine.lost = true;
      if (!engine.closed) engine.onlost?.("the WebGL context was lost");
    });
    return engine;
  }

  /** Shows these parts; what was there before is let go. */
  setAsset(arrays, parts) {
    const { gl } = this;
    this._deleteAsset();
    this.asset = {
      nodes: table(gl, arrays.nodes), primitives: table(gl, arrays.primitives),
      points: table(gl, arrays.points), normals: table(gl, arrays.normals),
      surfaces: table(gl, arrays.table), texels: table(gl, new Uint8Array(arrays.images.buffer)),
    };
    this.geometry = { texturesAt: ["1i", arrays.texturesAt], epsilon: ["1f", arrays.extent * 2 ** -18] };
    this.parts = parts.map((part, k) => {
      const planes = uploadPlanes(gl, part.planes);
      const transport = new PartProgram(gl, k, part, part.transport, part.inputs, planes);
      const emission = part.emission && new PartProgram(gl, k, part, part.emission, part.emission.inputs, planes);
      return { planes, transport, emission };
    });
    for (const { transport, emission } of this.parts) {
      transport.program.check();
      emission?.program.check();
    }
  }

  get emits() {
    return this.parts.some(({ emission }) => emission);
  }

  setEnvironment({ floats, places, total, width, height }) {
    if (this.sky) this.gl.deleteTexture(this.sky.texture);
    this.sky = table(this.gl, floats);
    this.skyNumbers = { skyPlaces: ["4i", ...places], skySize: ["2i", width, height], skyTotal: ["1f", total] };
  }

  /** A picture of this size, empty. */
  resize(width, height) {
    if (this.target?.width === width && this.target.height === height) return;
    const { gl } = this, rows = Math.max(1, Math.min(height, Math.floor(this.bandPixels / width)));
    this._deleteImages();
    this.target = { width, height };
    this.rows = new Target(gl, width, rows, 4);
    this.lit = new Target(gl, width, rows, 3);
    this.answers = new Target(gl, width, rows, 2);
    this.added = new Target(gl, width, rows, 1);
    this.sum = new Target(gl, width, height, 1);
  }

  /** The first hits of rows `from` to `to` from the top, the band that what follows is about. */
  trace(camera, sample, from, to) {
    const { height } = this.target;
    this.span = { rows: to - from, firstRow: height - to };  // from the bottom, as images are
    const { position, corner, stepX, stepY, jitter = 1 } = camera;
    this.frame = {
      cameraAt: ["3fv", position], height: ["1i", height], firstRow: ["1i", this.span.firstRow], sampleNumber: ["1ui", sample],
    };
    this._pass("hit", this.rows, this.asset, {
      ...this.geometry, ...this.frame, jitter: ["1f", jitter], corner: ["3fv", corner], stepX: ["3fv", stepX], stepY: ["3fv", stepY],
    });
  }

  /** What one light brings to the band. */
  light(light, { isFirst, countsCoverage }) {
    this._light(light);
    this._decode("transport");
    this._combine({ isFirst, countsCoverage, isEmission: false });
  }

  /** given: a texture of directions, for lights of that kind. */
  _light(light, given = null) {
    const [rows0, rows1, rows2, rows3] = this.rows.images;
    this._pass("light", this.lit, {
      ...this.asset, rows0, rows1, rows2, rows3, given: given ?? rows0, sky: this.sky ?? rows0,
    }, { ...this.geometry, ...this.frame, ...this.skyNumbers, ...lightUniforms(light) });
  }

  emission() {
    this._pass("clear", this.answers, {}, {});  // parts that do not emit leave what was there
    this._decode("emission");
    this._combine({ isFirst: false, countsCoverage: false, isEmission: true });
  }

  /** Adds what was found to the picture. */
  _combine({ isEmission, countsCoverage, isFirst }) {
    const { gl } = this, { width } = this.target, { rows, firstRow } = this.span;
    const [rows0, , , rows3] = this.rows.images, [lit0, lit1, lit2] = this.lit.images;
    const [first, second] = this.answers.images, flag = (value) => ["1i", Number(value)];
    this._pass("combine", this.added, { before: this.sum.images[0], rows0, rows3, lit0, lit1, lit2, first, second }, {
      isEmission: flag(isEmission), countsCoverage: flag(countsCoverage), isFirst: flag(isFirst), firstRow: ["1i", firstRow],
    });
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.added.frame);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, this.sum.frame);
    gl.disable(gl.SCISSOR_TEST);
    gl.blitFramebuffer(0, 0, width, rows, 0, firstRow, width, firstRow + rows, gl.COLOR_BUFFER_BIT, gl.NEAREST);
  }

  _pass(name, target, textures, uniforms) {
    pass(this.gl, this.programs[name], target, { to: this.span.rows, textures, uniforms });
  }

  show({ rounds, exposure, backdrop, filmic, spread }) {
    const { width, height } = this.canvas;
    pass(this.gl, this.programs.show, null, {
      textures: { picture: this.sum.images[0] },
      uniforms: {
        rounds: ["1f", rounds], exposure: ["1f", exposure], backdrop: ["3fv", backdrop], size: ["2f", width, height],
        filmicView: ["1f", Number(filmic)], spread: ["1f", spread],
      },
    });
  }

  done() {
    return finished(this.gl);
  }

  /** The sum of all samples, rows from the top, RGBA. */
  async picture() {
    const { width, height } = this.target, values = this.sum.read(0), result = new Float32Array(values.length);
    for (let row = 0; row < height; row++) {
      result.set(values.subarray(4 * width * row, 4 * width * (row + 1)), 4 * width * (height - 1 - row));
    }
    return result;
  }

  _decode(output) {
    const [rows0, rows1, rows2] = this.rows.images, lit0 = this.lit.images[0];
    for (const part of this.parts) {
      const own = part[output];
      if (!own) continue;
      this.gl.bindBufferBase(this.gl.UNIFORM_BUFFER, 0, own.record);
      pass(this.gl, own.program, this.answers, {
        to: this.span.rows, textures: { ...own.textures, rows0, rows1, rows2, lit0 }, uniforms: own.uniforms,
      });
    }
  }

  _deleteAsset() {
    for (const { texture } of Object.values(this.asset ?? {})) this.gl.deleteTexture(texture);
    for (const { planes, transport, emission } of this.parts) {
      this.gl.deleteTexture(planes.texture);
      transport.delete(this.gl);
      emission?.delete(this.gl);
    }
    this.parts = [];
  }

  _deleteImages() {
    for (const target of [this.rows, this.lit, this.answers, this.added, this.sum]) target?.delete();
    this.target = null;
  }

  close() {
    this.closed = true;
    this._deleteAsset();
    this._deleteImages();
    for (const program of Object.values(this.programs)) program.delete();
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();  // browsers allow few contexts at a time
  }
}

function lightUniforms({ kind, direction = [0, 1, 0], colour, angle = 0, ground }) {
  return {
    lightKind: ["1i", viewerLights[kind]], lightDirection: ["3fv", direction], lightColour: ["3fv", colour],
    turn: ["2f", Math.cos(angle), Math.sin(angle)],
    ground: ["4f", ground?.height ?? 0, ground ? 1 : 0, ground?.x ?? 0, ground?.z ?? 0],
    groundColour: ["3fv", ground?.colour ?? [0, 0, 0]], groundSize: ["1f", ground?.size ?? 1],
  };
}
