// Builds runtime/rna_view/site from the sources: node build.mjs [OUT]. The same sources give the same bytes.
import { build } from "esbuild";
import { copyFileSync, mkdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "../rna_view/site");
mkdirSync(out, { recursive: true });
await build({
  absWorkingDir: here,
  entryPoints: ["src/main.js"],
  outfile: join(out, "viewer.js"),
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  legalComments: "eof",
  loader: { ".glsl": "text", ".wgsl": "text" },
  logLevel: "warning",
});
for (const name of ["index.html", "viewer.css"]) copyFileSync(join(here, name), join(out, name));
