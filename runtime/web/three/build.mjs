// Builds the package rna-three into OUT: node build.mjs OUT. The same sources give the same bytes.
import { build } from "esbuild";
import { copyFileSync, mkdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { shaders } from "../shaders.mjs";
import { shortenSources } from "../source_maps.mjs";

const here = dirname(fileURLToPath(import.meta.url)), web = join(here, ".."), out = process.argv[2];
const SHADERS = ["surface", "fiber", "trace", "visibility.wgsl", "images.wgsl", "render/directions.wgsl", "render/ggx.wgsl", "render/lobes.wgsl", "render/nearby_light.wgsl"];
const COMMON = {
  absWorkingDir: web, bundle: true, minify: true, target: "es2022", legalComments: "eof", loader: { ".wgsl": "text" }, logLevel: "warning",
};

/** The worker as text: it needs no address of its own, which bundlers and other sites would get wrong. */
async function workerSource() {
  const { outputFiles } = await build({ ...COMMON, entryPoints: ["src/three/worker.js"], format: "iife", write: false });
  return outputFiles[0].text;
}

const plugin = {
  name: "imports",
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^(rna_gpu\/wgsl|worker_source)$/ }, ({ path }) => ({ path, namespace: "made" }));
    onLoad({ filter: /wgsl$/, namespace: "made" }, () => ({ contents: shaders(SHADERS) }));
    onLoad({ filter: /worker_source$/, namespace: "made" }, async () => ({ contents: await workerSource(), loader: "text" }));
  },
};

mkdirSync(out, { recursive: true });
await build({
  ...COMMON, entryPoints: { "rna-three": "src/three/index.js" }, outdir: out, format: "esm", external: ["three", "three/*"], plugins: [plugin], sourcemap: true,
});
shortenSources(join(out, "rna-three.js.map"), web);
for (const name of ["package.json", "README.md", "rna-three.d.ts"]) copyFileSync(join(here, name), join(out, name));
copyFileSync(join(web, "../../LICENSE"), join(out, "LICENSE"));
