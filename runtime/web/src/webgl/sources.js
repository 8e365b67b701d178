// The GLSL files, put together.
import { constants, lightKinds, records } from "../decoder/records.js";
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

const { Surface, Texture, RnaPrimitive } = records;
const isUsed = ([name]) => name.startsWith("RNA_") || ["NONE", "LETS_THROUGH", "HAS_CUTOFF"].includes(name);

/** Of a record of rna_gpu's in rows of four words: the row and the column of each of these members. */
const places = (prefix, { members }, names) => names.map((name) => {
  const { at } = members[name], own = `${prefix}_${name.toUpperCase()}`;
  return `const int ${own}_ROW = ${at >> 2}, ${own} = ${at & 3};\n`;
}).join("");

const rows = `precision highp int;
const int SURFACE_ROWS = ${Surface.words / 4}, TEXTURE_ROWS = ${Texture.words / 4};
${places("SURFACE", Surface, ["part", "flags", "normal_map", "through", "cutoff", "ior"])}
${places("TEXTURE", Texture, ["place", "size"])}
${places("PRIMITIVE", RnaPrimitive, ["a", "b", "c", "tag"])}
${Object.entries(constants).filter(isUsed).map(([name, value]) => `const uint ${name} = ${value}u;`).join("\n")}
${lightKinds((name, number) => `const int ${name} = ${number};`)}
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
