// rna_gpu's shaders as a module, for builds.
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url)), SHADERS = join(here, "../rna_gpu/wgsl");

/** The parts of `entries`, names of compositions and files: compositions, and the files that they need. */
export function shaders(entries) {
  const read = (path) => JSON.parse(readFileSync(path, "utf8"));
  const compositions = {
    ...read(join(SHADERS, "compositions.json")), ...read(join(SHADERS, "render/compositions.json")),
    ...read(join(here, "src/webgpu/compositions.json")),
  };
  const filesOf = (name) => (name.endsWith(".wgsl") ? [name] : compositions[name].flatMap(filesOf));
  const files = [...new Set(entries.flatMap(filesOf))].sort();
  const sharedFiles = Object.fromEntries(files.map((name) => [name, readFileSync(join(SHADERS, name), "utf8")]));
  const complete = Object.fromEntries(Object.entries(compositions).filter(([, parts]) => parts.flatMap(filesOf).every((name) => name in sharedFiles)));
  return `export const compositions = ${JSON.stringify(complete)};\nexport const sharedFiles = ${JSON.stringify(sharedFiles)};\n`;
}
