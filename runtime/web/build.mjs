// Builds the pages from the sources: node build.mjs [OUT]. The same sources give the same bytes.
import { build } from "esbuild";
import { copyFileSync, mkdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const PAGES = { viewer: "../rna_view/site", preview: "../rna_render/preview/site" };

for (const [name, own] of Object.entries(PAGES)) {
  const out = process.argv[2] ? join(process.argv[2], name) : join(here, own);
  mkdirSync(out, { recursive: true });
  await build({
    absWorkingDir: here,
    entryPoints: [{ in: `src/${name}/main.js`, out: name }, { in: `src/${name}/page.css`, out: name }],
    outdir: out,
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2022",
    legalComments: "eof",
    loader: { ".glsl": "text", ".wgsl": "text" },
    logLevel: "warning",
  });
  copyFileSync(join(here, `src/${name}/index.html`), join(out, "index.html"));
}
