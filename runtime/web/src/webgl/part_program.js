// The decoder of one part as a shader, its planes and weights in textures.
import { BLOCKS, blockNamed } from "../package/blocks.js";
import { NotSupported } from "../package/errors.js";
import { plain, Program, table } from "./context.js";
import { sources } from "./sources.js";

const groups = (width) => Math.ceil(width / 4);

/** Planes of four channels a layer, and the scale of each channel. */
export function uploadPlanes(gl, { values, scales, resolution, channels, precision }) {
  const layers = groups(channels), most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  if (resolution > most) throw new NotSupported(`planes of ${resolution} texels a side; this device has ${most}`);
  const wide = precision === "float32";
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, wide ? gl.RGBA32F : gl.RGBA16F, resolution, resolution, 3 * layers);
  plain(gl, gl.TEXTURE_2D_ARRAY);
  const type = precision === "float16" ? gl.HALF_FLOAT : gl.FLOAT;
  const Layer = precision === "float16" ? Uint16Array : Float32Array;
  const one = new Layer(4 * resolution * resolution), area = resolution * resolution;
  for (let layer = 0; layer < 3 * layers; layer++) {
    const plane = Math.floor(layer / layers), first = 4 * (layer % layers), used = Math.min(4, channels - first);
    for (let texel = 0; texel < area; texel++) {
      const from = (plane * area + texel) * channels + first;
      for (let c = 0; c < used; c++) one[4 * texel + c] = values[from + c];
    }
    gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, layer, resolution, resolution, 1, gl.RGBA, type, one);
  }
  const factors = new Float32Array(4 * 48).fill(1);
  for (let k = 0; scales && k < 3; k++) {
    for (let c = 0; c < channels; c++) factors[4 * (k * layers + (c >> 2)) + (c & 3)] = scales[k * channels + c];
  }
  return { target: gl.TEXTURE_2D_ARRAY, texture, factors };
}

/** Weights of a decoder in the order of decoder.glsl, and the numbers that it wants. */
export function packDecoder(decoder) {
  const texels = [], layers = [], steps = [];
  let count = 0;
  const add = (values) => {
    texels.push(values);
    count += values.length / 4;
    return count - values.length / 4;
  };
  const row = (values) => Float32Array.from({ length: 4 * groups(values.length) }, (_, k) => values[k] ?? 0);
  const gainAt = decoder.int8 ? add(row(decoder.gain)) : 0;
  if (decoder.int8) add(row(decoder.offset));
  for (const { weight, bias, rows, columns, step, scales } of decoder.layers) {
    const weights = new Float32Array(16 * groups(rows) * groups(columns));
    for (let i = 0; i < rows; i++) {
      for (let o = 0; o < columns; o++) {
        weights[4 * ((o >> 2) * 4 * groups(rows) + i) + (o & 3)] = weight[i * columns + o];
      }
    }
    const at = add(weights), biasAt = add(row(bias));
    layers.push(groups(rows), groups(columns), at, biasAt);
    steps.push(step ?? 0, decoder.int8 ? add(row(scales)) : 0);
  }
  const matrixAt = decoder.matrix ? add(packedMatrix(decoder)) : -1;
  const values = new Float32Array(4 * count);
  let at = 0;
  for (const piece of texels) {
    values.set(piece, at);
    at += piece.length;
  }
  const widest = Math.max(...decoder.layers.flatMap(({ rows, columns }) => [groups(rows), groups(columns)]));
  return { values, layers, steps, gainAt, matrixAt, widest };
}

/** Two texels a row of the matrix. */
function packedMatrix({ matrix, outputs }) {
  const rows = matrix.length / outputs, result = new Float32Array(8 * 4 * groups(rows));
  for (let k = 0; k < rows; k++) for (let o = 0; o < outputs; o++) result[8 * k + o] = matrix[k * outputs + o];
  return result;
}

/** Ready to answer for one part; `inputs` are the decoder's blocks. */
export class PartProgram {
  constructor(gl, number, part, decoder, inputs, planes) {
    const packed = packDecoder(decoder);
    this.weights = table(gl, packed.values, 1024);
    this.planes = planes;
    const defines = { COLUMNS: decoder.columns, LAYERS: decoder.layers.length, GROUPS: packed.widest, BLOCKS: BLOCKS.length };
    BLOCKS.forEach(({ name }, k) => { defines[`BLOCK_${name.toUpperCase()}`] = k; });
    const head = Object.entries(defines).map(([name, value]) => `#define ${name} ${value}\n`).join("");
    this.program = new Program(gl, head + sources.decode);
    this.uniforms = {
      part: ["1i", number], isFiber: ["1i", Number(part.kind === "fiber")], hasLight: ["1i", Number(decoder.outputs === 6)],
      resolution: ["1i", part.planes.resolution], channels: ["1i", part.planes.channels],
      scales: ["4fv", planes.factors], boundsMin: ["3fv", part.bounds.min], boundsMax: ["3fv", part.bounds.max],
      blockCount: ["1i", inputs.length], blocks: ["1iv", inputs.map((name) => BLOCKS.indexOf(blockNamed(name)))],
      layerCount: ["1i", decoder.layers.length], layers: ["4iv", packed.layers], steps: ["2fv", packed.steps],
      isInt8: ["1i", Number(decoder.int8)], gainAt: ["1i", packed.gainAt],
      limits: ["3f", decoder.low, decoder.high, decoder.top],
      matrixAt: ["1i", packed.matrixAt], unitOf: ["1f", decoder.unit], outputs: ["1i", decoder.outputs],
    };
  }

  get textures() {
    return { planes: this.planes, weights: this.weights };
  }

  delete(gl) {
    this.program.delete();
    gl.deleteTexture(this.weights.texture);
  }
}
