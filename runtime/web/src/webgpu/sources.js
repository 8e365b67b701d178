// The WGSL of the viewer: rna_gpu's files as they stand there, put together as its compositions say, and the viewer's own
// kernels.
import { compositions, sharedFiles } from "rna_gpu/wgsl";  // by build.mjs
import { declare, lightKinds } from "../decoder/records.js";
import band from "./shaders/band.wgsl";
import columns from "./shaders/columns.wgsl";
import hit from "./shaders/hit.wgsl";
import light from "./shaders/light.wgsl";
import look from "./shaders/look.wgsl";
import lobes from "./shaders/lobes.wgsl";
import pastGlass from "./shaders/past_glass.wgsl";
import nearby from "./shaders/nearby.wgsl";
import queue from "./shaders/queue.wgsl";
import show from "./shaders/show.wgsl";
import withoutGlass from "./shaders/without_glass.wgsl";
import withoutPastGlass from "./shaders/without_past_glass.wgsl";
import withoutSegments from "./shaders/without_segments.wgsl";
import withoutBaseColor from "./shaders/without_base_color.wgsl";
import withoutTextures from "./shaders/without_textures.wgsl";

for (const text of [band, lobes, queue, show]) declare(text);

export { sharedFiles };

/** The files of a composition, or of parts of one; a file stands for itself. */
const filesOf = (name) => (name in sharedFiles ? [name] : compositions[name].flatMap(filesOf));
const joined = (names, files = sharedFiles) => [...new Set(names.flatMap(filesOf))].map((name) => files[name]).join("\n");

/** A module as rna_gpu/shaders.py composes it: constants, then the files of the parts. */
export function compose(constants, ...parts) {
  const lines = Object.entries(constants).map(([name, value]) => `const ${name}: u32 = ${value}u;\n`);
  return lines.join("") + joined(parts);
}

/** The kernels of rays, for assets that have segments, textures, base colour, glass beside them, or not. */
export function rayKernels({ hasSegments, hasTextures, hasBaseColor, hasGlass }) {
  const instead = { ...sharedFiles };
  if (!hasSegments) instead["segment.wgsl"] = withoutSegments;
  if (!hasTextures) Object.assign(instead, { "normal_maps.wgsl": withoutTextures, "render/transmittance.wgsl": "" });
  if (!hasGlass) instead["render/solid_glass.wgsl"] = withoutGlass;
  if (!hasBaseColor) instead["render/base_color.wgsl"] = withoutBaseColor;
  const ofLight = [joined(compositions.light, instead), band, lightKinds, light, hasGlass ? pastGlass : withoutPastGlass];
  return {
    hit: joined(compositions.hit, instead) + band + hit, light: ofLight.join("\n"), nearby: joined(compositions.nearby, instead) + band + nearby,
  };
}

export const sources = {
  columns: joined(compositions.columns) + band + columns, lobes: `${sharedFiles["environment_lobes.wgsl"]}\n${sharedFiles["row_records.wgsl"]}\n${lobes}`,
  look: joined(compositions.queue) + band + look, queue: joined(compositions.queue) + band + queue, show,
};
