// node build.mjs OUT.mjs: frames.mjs with the viewer's modules and shaders in one file, as build.mjs of the pages makes them.
// esbuild comes from runtime/web (npm ci there).
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "../../runtime/web/node_modules/esbuild/lib/main.js";
import { imports } from "../../runtime/web/imports.mjs";

await build({
  absWorkingDir: dirname(fileURLToPath(import.meta.url)),
  entryPoints: ["frames.mjs"],
  outfile: join(process.cwd(), process.argv[2]),
  bundle: true,
  format: "esm",
  platform: "node",
  external: ["webgpu"],
  loader: { ".wgsl": "text" },
  plugins: [imports],
});
