// Builds the package rna-viewer into OUT: node build.mjs OUT. The same sources give the same bytes.
import { build } from "esbuild";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { imports } from "../imports.mjs";
import { shortenSources } from "../source_maps.mjs";
import { flag, propertyOf, READERS } from "../src/element/attributes.js";

const here = dirname(fileURLToPath(import.meta.url)), web = join(here, ".."), root = join(web, "../.."), out = process.argv[2];
const docs = readFileSync(join(root, "docs/element.md"), "utf8");

/** [name, meaning] of what a table of docs/element.md lists; the name is empty for the default slot. */
const rows = (heading) => docs.split(`## ${heading}\n`)[1].split("\n\n").map((text) => text.trim()).find((text) => text.startsWith("|"))
  .split("\n").slice(2).flatMap((row) => {
    const [cell, meaning] = row.split("|").slice(1).map((text) => text.trim()), names = [...cell.matchAll(/`([^`]+)`/g)].map(([, name]) => name);
    const plain = meaning.replace(/\[([^\]]*)\]\([^)]*\)/g, "$1").replaceAll("`", "");
    return (names.length ? names : [""]).map((name) => [name, plain]);
  });

const said = new Map(rows("Attributes"));
const attributes = Object.entries(READERS).map(([name, read]) => {
  if (!said.has(name)) throw new Error(`docs/element.md does not say what ${name} means`);
  return { name, fieldName: propertyOf(name), description: said.get(name), type: { text: read === flag ? "boolean" : "string" } };
});
const declaration = { name: "RnaViewer", module: "rna-viewer.js" };
const manifest = {
  schemaVersion: "1.0.0",
  modules: [{
    kind: "javascript-module", path: "rna-viewer.js",
    declarations: [{
      kind: "class", customElement: true, name: "RnaViewer", tagName: "rna-viewer", superclass: { name: "HTMLElement" }, attributes,
      events: rows("Events").map(([name, description]) => ({ name, description, type: { text: "CustomEvent" } })),
      slots: rows("Slots").map(([name, description]) => ({ name, description })),
      cssParts: [...docs.match(/Parts for `::part\(\)`: ([^.]*)\./)[1].matchAll(/`([^`]+)`/g)].map(([, name]) => ({ name })),
    }],
    exports: [
      { kind: "js", name: "RnaViewer", declaration },
      { kind: "custom-element-definition", name: "rna-viewer", declaration },
    ],
  }],
};

mkdirSync(out, { recursive: true });
await build({
  absWorkingDir: web, entryPoints: { "rna-viewer": "src/element/rna_viewer.js" }, outdir: out, bundle: true, minify: true, format: "esm",
  target: "es2022", legalComments: "eof", loader: { ".wgsl": "text", ".glsl": "text" }, plugins: [imports], logLevel: "warning", sourcemap: true,
});
shortenSources(join(out, "rna-viewer.js.map"), web);
writeFileSync(join(out, "custom-elements.json"), `${JSON.stringify(manifest, null, 1)}\n`);
for (const name of ["package.json", "README.md", "rna-viewer.d.ts", "react.js", "react.d.ts"]) copyFileSync(join(here, name), join(out, name));
copyFileSync(join(root, "LICENSE"), join(out, "LICENSE"));
