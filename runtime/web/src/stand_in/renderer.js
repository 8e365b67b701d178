// Stand-ins in WebGL 2: one draw for each range of triangles, in the light of a first look.
import { LEAST_KAPPA } from "../light/prefilter.js";
import { dot } from "../vectors.js";
import shade from "./shade.glsl";

const MOST_SUNS = 16;  // of shade.glsl
const UNITS = { image: 0, metallic_roughness: 1, normals: 2, environment: 3, holes: 4 };
const VERTEX = `#version 300 es
uniform mat4 seen;
uniform vec3 eye;
uniform vec3 middle;
uniform bool is_strands;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 place;
out vec3 x;
out vec3 n;
out vec2 uv;
void main() {
    x = position;
    n = normal;
    uv = place;
    if (is_strands) { // across the view, and lit as what they cover together: outwards
        vec3 t = normalize(normal), across = cross(t, eye - position), outwards = position - middle;
        x += place.x * across / max(length(across), 1e-20);
        n = outwards - dot(outwards, t) * t;
    }
    gl_Position = seen * vec4(x, 1.0);
}`;

export class StandInRenderer {
  /** Of the content of readStandIn; null without WebGL 2. */
  static open(canvas, content) {
    const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
    return gl && new StandInRenderer(gl, content);
  }

  constructor(gl, { parts, box: { min, max } }) {
    Object.assign(this, { gl, middle: min.map((low, k) => (low + max[k]) / 2), radius: Math.hypot(...max.map((high, k) => high - min[k])) / 2 || 1 });
    this.program = programOf(gl, VERTEX, `#version 300 es\n${shade}`);
    gl.useProgram(this.program);
    this.at = uniformsOf(gl, this.program);
    this.textures = new Map();  // by image
    const nothing = this._texture({ width: 1, height: 1, pixels: new Uint8Array(4) }, {});  // browsers warn of units without one
    for (const [name, unit] of Object.entries(UNITS)) {
      gl.uniform1i(this.at[name], unit);
      this._bind(name, nothing);
    }
    this.parts = parts.map((part) => this._part(part));
    gl.uniform3fv(this.at.middle, this.middle);
    gl.enable(gl.DEPTH_TEST);
  }

  /** camera: of Orbit. lights: of Lighting.firstLights. exposure: a factor. */
  draw({ camera, lights, exposure, isFilmic }) {
    const { gl, at } = this, { width, height } = gl.canvas;
    gl.viewport(0, 0, width, height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix4fv(at.seen, false, this._seen(camera, width, height));
    gl.uniform3fv(at.eye, camera.position);
    gl.uniform1f(at.exposure, exposure);
    gl.uniform1i(at.is_filmic, Number(isFilmic));
    this._light(lights);
    for (const part of this.parts) this._draw(part);
  }

  close() {
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }

  /** From the asset's space to clip space, of the rays of `camera`. */
  _seen({ position, corner, stepX, stepY }, width, height) {
    const across = stepX.map((value) => value * width), down = stepY.map((value) => value * height);
    const forward = corner.map((value, k) => value + (across[k] + down[k]) / 2), away = this.middle.map((value, k) => value - position[k]);
    const far = Math.max(dot(away, forward) + 1.01 * this.radius, 1e-3 * this.radius), near = Math.max(dot(away, forward) - 1.01 * this.radius, 1e-3 * far);
    const scaled = (axis, factor) => axis.map((value) => (factor * value) / dot(axis, axis)), depth = (far + near) / (far - near);
    const rows = [scaled(across, 2), scaled(down, -2), forward.map((value) => depth * value), forward];
    const last = rows.map((row, k) => -dot(row, position) - (k === 2 ? (2 * far * near) / (far - near) : 0));
    return [0, 1, 2].flatMap((axis) => rows.map((row) => row[axis])).concat(last);
  }

  _light(lights) {
    const { gl, at } = this, suns = lights.filter(({ kind }) => kind === "sun").slice(0, MOST_SUNS), mirror = lights.find(({ kind }) => kind === "mirror");
    gl.uniform1i(at.suns, suns.length);
    if (suns.length) {
      gl.uniform3fv(at.directions, suns.flatMap(({ direction }) => direction));
      gl.uniform3fv(at.irradiances, suns.flatMap(({ colour }) => colour));
    }
    gl.uniform3fv(at.around, mirror ? mirror.radiance.map((value) => value * mirror.rest.unit) : [0, 0, 0]);
    gl.uniform2f(at.turn, Math.cos(mirror?.turn ?? 0), Math.sin(mirror?.turn ?? 0));
    if (mirror && mirror.rest !== this.rest) this._setEnvironment(mirror.rest);
  }

  _setEnvironment(rest) {
    const { gl, at } = this, { texels, width, height, levels } = rest;
    this.rest = rest;
    gl.activeTexture(gl.TEXTURE0 + UNITS.environment);
    gl.bindTexture(gl.TEXTURE_2D, (this.environment ??= gl.createTexture()));
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA16F, width, height * levels, 0, gl.RGBA, gl.HALF_FLOAT, texels);
    for (const name of ["MIN", "MAG"]) gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}_FILTER`], gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    gl.uniform3f(at.levels, height, levels, LEAST_KAPPA);
  }

  _part({ mesh: { positions, normals, uvs, indices }, isStrands = false, roughness, metallic, metallicRoughness, ranges }) {
    const { gl } = this, array = gl.createVertexArray();
    gl.bindVertexArray(array);
    [[positions, 3], [normals, 3], [uvs, 2]].forEach(([values, items], location) => {
      if (!values) return;
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, items, gl.FLOAT, false, 0, 0);
    });
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
    const texture = (image, looks) => image && this._texture(image, looks), linear = { colorSpace: "linear" };
    return {
      array, isStrands, roughness, metallic, levels: texture(metallicRoughness, linear),
      ranges: ranges.map((range) => ({ ...range, texture: texture(range.image, range), map: texture(range.normals, linear), open: texture(range.holes, linear), relief: !range.normals ? 0 : range.normals.values ? 2 : 1 })),
    };
  }

  _texture(image, { colorSpace = "srgb", wrap = ["repeat", "repeat"] }) {
    const { gl } = this, key = JSON.stringify([colorSpace, wrap]), ofImage = this.textures.get(image) ?? new Map();
    this.textures.set(image, ofImage);
    if (ofImage.has(key)) return ofImage.get(key);
    const made = gl.createTexture(), format = colorSpace === "srgb" ? gl.SRGB8_ALPHA8 : gl.RGBA8;
    ofImage.set(key, made);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, made);
    const { width, height } = image, bytes = (own, form, values) => gl.texImage2D(gl.TEXTURE_2D, 0, own, width, height, 0, form, gl.UNSIGNED_BYTE, values);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    if (image.pixels) bytes(format, gl.RGBA, image.pixels);
    else if (image.values) bytes(...[[gl.R8, gl.RED], [gl.RG8, gl.RG], [gl.RGB8, gl.RGB]][image.channels - 1], image.values);
    else gl.texImage2D(gl.TEXTURE_2D, 0, format, gl.RGBA, gl.UNSIGNED_BYTE, image);
    gl.generateMipmap(gl.TEXTURE_2D);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    const modes = { repeat: gl.REPEAT, clamp: gl.CLAMP_TO_EDGE, mirror: gl.MIRRORED_REPEAT };
    wrap.forEach((mode, axis) => gl.texParameteri(gl.TEXTURE_2D, [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T][axis], modes[mode]));
    return made;
  }

  _draw({ array, isStrands, roughness, metallic, levels, ranges }) {
    const { gl, at } = this;
    gl.bindVertexArray(array);
    gl.uniform1i(at.is_strands, Number(isStrands));
    gl.uniform2f(at.constants, roughness, metallic);
    gl.uniform1i(at.has_levels, Number(!!levels));
    if (levels) this._bind("metallic_roughness", levels);
    for (const { triangles: [first, count], factor = [1, 1, 1], texture, map, open, holes, relief, transform = [1, 0, 0, 0, 1, 0] } of ranges) {
      gl.uniform1i(at.relief, relief);
      if (map) this._bind("normals", map);
      gl.uniform1i(at.hole_channels, holes?.channels ?? 0);
      if (open) {
        this._bind("holes", open);
        gl.uniform1f(at.cutoff, holes.cutoff);
      }
      gl.uniform3fv(at.factor, factor);
      gl.uniform1i(at.has_image, Number(!!texture));
      if (texture) this._bind("image", texture);
      gl.uniform3fv(at.to_u, transform.slice(0, 3));
      gl.uniform3fv(at.to_v, transform.slice(3));
      gl.drawElements(gl.TRIANGLES, 3 * count, gl.UNSIGNED_INT, 12 * first);
    }
  }

  _bind(name, texture) {
    this.gl.activeTexture(this.gl.TEXTURE0 + UNITS[name]);
    this.gl.bindTexture(this.gl.TEXTURE_2D, texture);
  }
}

function programOf(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(`the stand-in's shaders do not compile: ${gl.getProgramInfoLog(program)}`);
  return program;
}

/** Locations by name; of arrays without [0]. */
function uniformsOf(gl, program) {
  const names = Array.from({ length: gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) }, (_, k) => gl.getActiveUniform(program, k).name);
  return Object.fromEntries(names.map((name) => [name.replace("[0]", ""), gl.getUniformLocation(program, name)]));
}
