// The GLSL files, put together.
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

const geometry = [scene, intersect, points, trace].join("\n");
const withRandom = (text) => text.replace("#include random", random);

export const sources = {
  hit: geometry + withRandom(hit),
  light: geometry + withRandom(light),
  normals: geometry + normals,
  decode: [scene, blocks, decoder, decodeMain].join("\n"),
  clear: "precision highp float; layout(location = 0) out vec4 a; layout(location = 1) out vec4 b; void main() { a = b = vec4(0.0); }",
  combine,
  show,
};
