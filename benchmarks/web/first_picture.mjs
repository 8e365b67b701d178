// Seconds until a page shows an asset that can be turned: <rna-viewer>'s stand-in against model-viewer's picture, of one .glb
// that carries a package, in pairs of fresh pages of one Chromium. In a folder of its own:
//
//     npm install puppeteer-core @google/model-viewer && node first_picture.mjs --pairs 5 --out FILE.json toy.glb -- --disable-gpu
//
// `rna-info toy.rna --glb toy.glb` writes the file. What is behind -- are flags of Chromium.
import { readFileSync, renameSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { cpus, loadavg } from "node:os";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";

const flagsAt = process.argv.indexOf("--"), flags = flagsAt < 0 ? [] : process.argv.slice(flagsAt + 1);
const { values, positionals } = parseArgs({
  args: process.argv.slice(2, flagsAt < 0 ? undefined : flagsAt), allowPositionals: true,
  options: { pairs: { type: "string", default: "5" }, out: { type: "string" }, chromium: { type: "string", default: "/usr/bin/chromium" }, seconds: { type: "string", default: "300" } },
});
if (positionals.length !== 1) throw new Error("expected one .glb that carries a package");
const here = dirname(fileURLToPath(import.meta.url)), modules = join(process.cwd(), "node_modules"), peer = join(modules, "@google/model-viewer");
const { default: puppeteer } = await import(join(modules, "puppeteer-core/lib/esm/puppeteer/puppeteer-core.js"));
const versionOf = (folder) => JSON.parse(readFileSync(join(folder, "package.json"))).version;

/** The tag, its script, and the event with which its asset is seen. */
const VIEWERS = {
  "rna-viewer": { script: join(here, "../../runtime/rna_view/site/rna-viewer.js"), event: "stand-in" },
  "model-viewer": { script: join(peer, "dist/model-viewer.min.js"), event: "load" },
};

const pageOf = (name) => `<!doctype html><script>
  document.addEventListener("${VIEWERS[name].event}", ({ target }) => {
    if (target.localName === "${name}") requestAnimationFrame(() => { globalThis.seen = performance.now(); });
  }, true);
</script><script type="module" src="${name}.js"></script>
<${name} src="asset.glb" loading="eager" camera-controls style="display: block; width: 640px; height: 400px"></${name}>`;

const TYPES = { html: "text/html", js: "text/javascript", glb: "model/gltf-binary" };
const files = new Map([["asset.glb", readFileSync(positionals[0])]]);
for (const [name, { script }] of Object.entries(VIEWERS)) files.set(`${name}.js`, readFileSync(script)).set(`${name}.html`, Buffer.from(pageOf(name)));

/** Ranges, too, as most hosts have them. */
const server = createServer(({ url, headers }, answer) => {
  const name = url.slice(1), file = files.get(name);
  if (!file) return void answer.writeHead(404).end();
  const range = /^bytes=(\d+)-(\d+)$/.exec(headers.range ?? ""), [first, last] = range ? range.slice(1).map(Number) : [0, file.length - 1];
  const content = { "Content-Type": TYPES[name.split(".").pop()], "Accept-Ranges": "bytes" };
  answer.writeHead(range ? 206 : 200, range ? { ...content, "Content-Range": `bytes ${first}-${last}/${file.length}` } : content);
  answer.end(file.subarray(first, last + 1));
});
await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
const address = `http://127.0.0.1:${server.address().port}/`;

async function seconds(browser, name) {
  const context = await browser.createBrowserContext(), page = await context.newPage();
  await page.goto(`${address}${name}.html`, { waitUntil: "domcontentloaded" });
  const seen = await page.waitForFunction("globalThis.seen", { timeout: 1e3 * Number(values.seconds), polling: 50 });
  const time = (await seen.jsonValue()) / 1e3;
  await context.close();
  return Number(time.toFixed(3));
}

const median = (numbers) => [...numbers].sort((a, b) => a - b)[Math.floor(numbers.length / 2)];
const browser = await puppeteer.launch({ executablePath: values.chromium, args: ["--no-sandbox", ...flags], protocolTimeout: 1e6 });
const stamp = {
  command: `node first_picture.mjs --pairs ${values.pairs} ${basename(positionals[0])} -- ${flags.join(" ")}`, date: new Date().toISOString(),
  cpu: cpus()[0].model, cores: cpus().length, load: loadavg().map((load) => Number(load.toFixed(2))), browser: await browser.version(), "model-viewer": versionOf(peer),
};
const times = { "rna-viewer": [], "model-viewer": [] }, names = Object.keys(times);
for (let pair = 0; pair < Number(values.pairs); pair++) {
  for (const name of pair % 2 ? names.toReversed() : names) {
    times[name].push(await seconds(browser, name));
    console.error(`${name} ${times[name].at(-1)} s`);
  }
}
const ratios = times["rna-viewer"].map((time, k) => Number((time / times["model-viewer"][k]).toFixed(3)));
const text = `${JSON.stringify({ stamp, seconds: times, medians: Object.fromEntries(names.map((name) => [name, median(times[name])])), ratios, ratio: median(ratios) }, null, 1)}\n`;
if (values.out) {
  writeFileSync(`${values.out}.new`, text);
  renameSync(`${values.out}.new`, values.out);
}
console.log(text);
await browser.close();
server.close();
