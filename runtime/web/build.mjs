// Builds the pages from the sources: node build.mjs [OUT]. The same sources give the same bytes.
import { build } from "esbuild";
import { copyFileSync, mkdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { imports } from "./imports.mjs";

const here = dirname(fileURLToPath(import.meta.url));
// By page: where it goes, and what is there beside its main.js and page.css.
const PAGES = {
  viewer: { site: "../rna_view/site", more: [{ in: "src/element/rna_viewer.js", out: "rna-viewer" }] },
  preview: { site: "../rna_render/preview/site", more: [] },
};

for (const [name, { site, more }] of Object.entries(PAGES)) {
  const out = process.argv[2] ? join(process.argv[2], name) : join(here, site);
  mkdirSync(out, { recursive: true });
  await build({
    absWorkingDir: here,
    entryPoints: [{ in: `src/${name}/main.js`, out: name }, { in: `src/${name}/page.css`, out: name }, ...more],
    outdir: out,
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2022",
    legalComments: "eof",
    loader: { ".wgsl": "text" },
    plugins: [imports],
    logLevel: "warning",
  });
  copyFileSync(join(here, `src/${name}/index.html`), join(out, "index.html"));
}
