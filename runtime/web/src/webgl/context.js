// What WebGL2 gives in one place: programs, tables in textures, targets, passes over a rectangle.
import { NotSupported } from "../package/errors.js";

const VERTEX = `#version 300 es
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}`;

/** A WebGL2 context that can draw into float textures. */
export function openContext(canvas) {
  const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, preserveDrawingBuffer: true });
  if (!gl) throw new NotSupported("this browser has no WebGL2");
  if (!gl.getExtension("EXT_color_buffer_float")) {
    throw new NotSupported("this device's WebGL2 cannot draw into float textures");
  }
  return gl;
}

export class Program {
  constructor(gl, source) {
    this.gl = gl;
    this.program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, `#version 300 es\n${source}`]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
      gl.deleteShader(shader);
    }
    gl.linkProgram(this.program);
    this.places = new Map();
  }

  check() {
    const { gl, program } = this;
    if (gl.getProgramParameter(program, gl.LINK_STATUS) || gl.isContextLost()) return;
    const logs = gl.getAttachedShaders(program).map((shader) => gl.getShaderInfoLog(shader));
    throw new Error(`a shader does not compile: ${[gl.getProgramInfoLog(program), ...logs].join(" ")}`);
  }

  _place(name) {
    if (!this.places.has(name)) this.places.set(name, this.gl.getUniformLocation(this.program, name));
    return this.places.get(name);
  }

  /** Values by name: [method, ...arguments], as ["1i", 3]. */
  set(uniforms) {
    for (const [name, [method, ...values]] of Object.entries(uniforms)) {
      this.gl[`uniform${method}`](this._place(name), ...values);
    }
  }

  textures(byName) {
    Object.entries(byName).forEach(([name, texture], unit) => {
      this.gl.activeTexture(this.gl.TEXTURE0 + unit);
      this.gl.bindTexture(texture.target, texture.texture);
      this.gl.uniform1i(this._place(name), unit);
    });
  }

  delete() {
    this.gl.deleteProgram(this.program);
  }
}

const WIDTH = 2048;

/** A table of RGBA texels: floats, words or bytes. */
export function table(gl, values, width = WIDTH) {
  const formats = new Map([
    [Float32Array, [gl.RGBA32F, gl.RGBA, gl.FLOAT]], [Uint32Array, [gl.RGBA32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT]],
    [Uint8Array, [gl.RGBA8UI, gl.RGBA_INTEGER, gl.UNSIGNED_BYTE]],
  ]);
  const height = Math.ceil(Math.max(1, values.length / 4) / width);
  checkSide(gl, height);
  const padded = new values.constructor(4 * width * height);
  padded.set(values);
  return texture2d(gl, width, height, ...formats.get(values.constructor), padded);
}

function checkSide(gl, side) {
  const most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  if (side > most) throw new NotSupported(`the asset needs textures of side ${side}; this device has ${most}`);
}

export function texture2d(gl, width, height, inner, format, type, data = null) {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  gl.texImage2D(gl.TEXTURE_2D, 0, inner, width, height, 0, format, type, data);
  plain(gl, gl.TEXTURE_2D);
  return { target: gl.TEXTURE_2D, texture, width, height };
}

export function plain(gl, target) {
  gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  gl.texParameteri(target, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(target, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
}

/** `count` float images of one size, to be drawn into together. */
export class Target {
  constructor(gl, width, height, count) {
    Object.assign(this, { gl, width, height });
    this.images = Array.from({ length: count }, () =>
      texture2d(gl, width, height, gl.RGBA32F, gl.RGBA, gl.FLOAT));
    this.frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    this.images.forEach(({ texture }, k) =>
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + k, gl.TEXTURE_2D, texture, 0));
    gl.drawBuffers(this.images.map((_, k) => gl.COLOR_ATTACHMENT0 + k));
    if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE && !gl.isContextLost()) {
      throw new NotSupported("this device cannot draw into float textures");
    }
  }

  /** RGBA of image k, rows from the bottom. */
  read(k) {
    const { gl, width, height } = this, values = new Float32Array(4 * width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    gl.readBuffer(gl.COLOR_ATTACHMENT0 + k);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, values);
    return values;
  }

  delete() {
    this.gl.deleteFramebuffer(this.frame);
    for (const { texture } of this.images) this.gl.deleteTexture(texture);
  }
}

/** Runs a program over the first `to` rows of a target, or of the canvas; all by default. */
export function pass(gl, program, target, { textures = {}, uniforms = {}, to } = {}) {
  const { width, height } = target ?? gl.canvas;
  gl.bindFramebuffer(gl.FRAMEBUFFER, target?.frame ?? null);
  gl.viewport(0, 0, width, height);
  gl.enable(gl.SCISSOR_TEST);
  gl.scissor(0, 0, width, to ?? height);
  gl.useProgram(program.program);
  program.set(uniforms);
  program.textures(textures);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
}

/** When all commands are done. */
export async function finished(gl) {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  for (;;) {
    if (gl.isContextLost()) return;
    const state = gl.clientWaitSync(fence, 0, 0);
    if (state === gl.ALREADY_SIGNALED || state === gl.CONDITION_SATISFIED) break;
    await new Promise((resolve) => setTimeout(resolve, 1));
  }
  gl.deleteSync(fence);
}
