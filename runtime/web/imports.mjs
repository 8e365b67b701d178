// What the element imports that are no files: rna_gpu's shaders; and in place of all of three what its reader of EXR needs.
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { shaders } from "./shaders.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const ENTRIES = ["surface", "fiber", "evaluate", "weights_uniform.wgsl", "weights_storage.wgsl", "hit", "light", "nearby", "queue", "columns", "environment_lobes.wgsl"];

export const imports = {
  name: "imports",
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^three$/ }, () => ({ path: join(here, "src/light/parts_of_three.js") }));
    onResolve({ filter: /^rna_gpu\/wgsl$/ }, ({ path }) => ({ path, namespace: "shaders" }));
    onLoad({ filter: /.*/, namespace: "shaders" }, () => ({ contents: shaders(ENTRIES) }));
  },
};
