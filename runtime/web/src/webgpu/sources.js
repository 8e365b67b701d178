// The WGSL of the decoder and of what rays meet, which is rna_gpu's, file by file as it stands there; and that of
// the viewer's kernels.
import compositions from "../../../rna_gpu/wgsl/compositions.json";
import argumentsFile from "../../../rna_gpu/wgsl/arguments.wgsl";
import blocks from "../../../rna_gpu/wgsl/blocks.wgsl";
import decoder from "../../../rna_gpu/wgsl/decoder.wgsl";
import evaluate from "../../../rna_gpu/wgsl/evaluate.wgsl";
import directions from "../../../rna_gpu/wgsl/render/directions.wgsl";
import fiber from "../../../rna_gpu/wgsl/fiber.wgsl";
import fiberBlocks from "../../../rna_gpu/wgsl/fiber_blocks.wgsl";
import part from "../../../rna_gpu/wgsl/part.wgsl";
import partRecords from "../../../rna_gpu/wgsl/part_records.wgsl";
import planes from "../../../rna_gpu/wgsl/planes.wgsl";
import segment from "../../../rna_gpu/wgsl/segment.wgsl";
import surface from "../../../rna_gpu/wgsl/surface.wgsl";
import surfaceBlocks from "../../../rna_gpu/wgsl/surface_blocks.wgsl";
import triangle from "../../../rna_gpu/wgsl/triangle.wgsl";
import visibility from "../../../rna_gpu/wgsl/visibility.wgsl";
import weightsStorage from "../../../rna_gpu/wgsl/weights_storage.wgsl";
import weightsUniform from "../../../rna_gpu/wgsl/weights_uniform.wgsl";
import band from "./shaders/band.wgsl";
import hit from "./shaders/hit.wgsl";
import light from "./shaders/light.wgsl";
import points from "./shaders/points.wgsl";
import queue from "./shaders/queue.wgsl";
import random from "./shaders/random.wgsl";
import scene from "./shaders/scene.wgsl";
import show from "./shaders/show.wgsl";
import trace from "./shaders/trace.wgsl";

export const sharedFiles = {
  "arguments.wgsl": argumentsFile, "blocks.wgsl": blocks, "decoder.wgsl": decoder, "evaluate.wgsl": evaluate,
  "fiber.wgsl": fiber, "fiber_blocks.wgsl": fiberBlocks, "part.wgsl": part, "part_records.wgsl": partRecords, "planes.wgsl": planes, "segment.wgsl": segment,
  "surface.wgsl": surface, "surface_blocks.wgsl": surfaceBlocks, "triangle.wgsl": triangle, "visibility.wgsl": visibility, "weights_storage.wgsl": weightsStorage,
  "weights_uniform.wgsl": weightsUniform, "render/directions.wgsl": directions,
};

/** A module as rna_gpu/shaders.py composes it: constants, then the files of the parts. */
export function compose(constants, ...parts) {
  const names = parts.flatMap((name) => (name.endsWith(".wgsl") ? [name] : compositions[name]));
  const lines = Object.entries(constants).map(([name, value]) => `const ${name}: u32 = ${value}u;\n`);
  return lines.join("") + [...new Set(names)].map((name) => sharedFiles[name]).join("\n");
}

const rays = [scene, triangle, segment, visibility, points, trace, random, band];

/** The kernels of rays, for assets that have segments, or textures, or not. */
export function rayKernels({ hasSegments, hasTextures }) {
  const flags = `const HAS_SEGMENTS = ${hasSegments};\nconst HAS_TEXTURES = ${hasTextures};\n`;
  return { hit: flags + [...rays, hit].join("\n"), light: flags + [...rays, directions, light].join("\n") };
}

export const sources = { queue, show };
