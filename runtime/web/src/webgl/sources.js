// The GLSL files, put together.
import { constants, records } from "../decoder/records.js";
import blocks from "./shaders/blocks.glsl";
import combine from "./shaders/combine.glsl";
import decodeMain from "./shaders/decode.glsl";
import decoder from "./shaders/decoder.glsl";
import hit from "./shaders/hit.glsl";
import intersect from "./shaders/intersect.glsl";
import light from "./shaders/light.glsl";
import normals from "./shaders/normals.glsl";
import points from "./shaders/points.glsl";
import random from "./shaders/random.glsl";
import scene from "./shaders/scene.glsl";
import show from "./shaders/show.glsl";
import trace from "./shaders/trace.glsl";

const { LETS_THROUGH, HAS_CUTOFF } = constants, { Surface, Texture } = records;
// Of rna_gpu's table: rows of four words.
const rows = `precision highp int;
const int SURFACE_ROWS = ${Surface.words / 4}, THROUGH_ROW = ${Surface.members.through.at / 4}, TEXTURE_ROWS = ${Texture.words / 4};
const uint LETS_THROUGH = ${LETS_THROUGH}u, HAS_CUTOFF = ${HAS_CUTOFF}u;
`;
const geometry = [rows, scene, intersect, points, trace].join("\n");
const withRandom = (text) => text.replace("#include random", random);

export const sources = {
  hit: geometry + withRandom(hit),
  light: geometry + withRandom(light),
  normals: geometry + normals,
  decode: (records, groups) => [rows, scene, records, `const int GROUPS = ${groups};`, decoder, blocks, decodeMain].join("\n"),
  clear: "precision highp float; layout(location = 0) out vec4 a; layout(location = 1) out vec4 b; void main() { a = b = vec4(0.0); }",
  combine,
  show,
};
