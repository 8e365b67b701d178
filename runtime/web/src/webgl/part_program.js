// The decoder of one part as a shader, its planes and weights in textures.
import { packDecoder, planeWords } from "../decoder/pack_decoder.js";
import { records } from "../decoder/records.js";
import { NotSupported } from "../package/errors.js";
import { plain, Program, table } from "./context.js";
import { sources } from "./sources.js";

/** Planes of four channels a layer. */
export function uploadPlanes(gl, planes) {
  const { resolution, channels, precision } = planes, layers = Math.ceil(channels / 4), most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  if (resolution > most) throw new NotSupported(`planes of ${resolution} texels a side; this device has ${most}`);
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  const inner = precision === "float32" ? gl.RGBA32F : gl.RGBA16F, type = precision === "float16" ? gl.HALF_FLOAT : gl.FLOAT;
  gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, inner, resolution, resolution, 3 * layers);
  plain(gl, gl.TEXTURE_2D_ARRAY);
  const one = new (precision === "float16" ? Uint16Array : Float32Array)(4 * resolution * resolution);
  for (let plane = 0; plane < 3; plane++) {
    const words = planeWords(planes, plane);
    for (let layer = 0; layer < layers; layer++) {
      for (let k = 0; k < one.length; k++) one[k] = words[4 * ((k >> 2) * layers + layer) + (k & 3)];
      gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, plane * layers + layer, resolution, resolution, 1, gl.RGBA, type, one);
    }
  }
  return { target: gl.TEXTURE_2D_ARRAY, texture };
}

/** The members of a record, in the layout std140. */
function membersOf(name) {
  return Object.entries(records[name].members).map(([member, { type, record, count }]) => {
    const [one, vector] = type === "f32" ? ["float", "vec"] : ["uint", "uvec"];
    if (record) return `${record} ${member}${count > 1 ? `[${count}]` : ""};`;
    if (count > 4) return `${vector}4 ${member}[${Math.ceil(count / 4)}];`;
    return `${count > 1 ? vector + count : one} ${member};`;
  }).join(" ");
}

const RECORDS = `struct RnaLayer { ${membersOf("RnaLayer")} };
layout(std140) uniform Part { ${membersOf("RnaPart")} } part;
`;

/** Ready to answer for one part; `inputs` are the decoder's blocks. */
export class PartProgram {
  constructor(gl, number, part, decoder, inputs, planes) {
    const { weights, record, groups } = packDecoder(part, decoder, inputs);
    this.weights = table(gl, weights, 1024);
    this.planes = planes;
    this.record = gl.createBuffer();
    gl.bindBuffer(gl.UNIFORM_BUFFER, this.record);
    gl.bufferData(gl.UNIFORM_BUFFER, record, gl.STATIC_DRAW);
    this.program = new Program(gl, sources.decode(RECORDS, groups));
    this.uniforms = {
      number: ["1i", number], isFiber: ["1i", Number(part.kind === "fiber")], hasLight: ["1i", Number(decoder.outputs === 6)],
    };
  }

  get textures() {
    return { planes: this.planes, weights: this.weights };
  }

  delete(gl) {
    this.program.delete();
    gl.deleteBuffer(this.record);
    gl.deleteTexture(this.weights.texture);
  }
}
