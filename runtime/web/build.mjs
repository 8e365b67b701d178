// Builds the pages from the sources: node build.mjs [OUT]. The same sources give the same bytes.
import { build } from "esbuild";
import { copyFileSync, mkdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { imports } from "./imports.mjs";

const here = dirname(fileURLToPath(import.meta.url));
// By page: the folder of OUT and of the sources where it goes, its file there, and what is there beside its main.js and page.css.
const PAGES = {
  viewer: { folder: "viewer", site: "../rna_view/site", file: "index.html", more: [{ in: "src/element/rna_viewer.js", out: "rna-viewer" }] },
  gallery: { folder: "viewer", site: "../rna_view/site", file: "gallery.html", more: [] },
  preview: { folder: "preview", site: "../rna_render/preview/site", file: "index.html", more: [] },
};

for (const [name, { folder, site, file, more }] of Object.entries(PAGES)) {
  const out = process.argv[2] ? join(process.argv[2], folder) : join(here, site);
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
    loader: { ".wgsl": "text", ".glsl": "text" },
    plugins: [imports],
    logLevel: "warning",
  });
  copyFileSync(join(here, `src/${name}/index.html`), join(out, file));
}
