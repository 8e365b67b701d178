// Frames a second of the viewer on this machine's GPU, in node by Dawn (npm install webgpu): the page's own stage, engine
// and shaders on a canvas that is a texture.
//
//     node build.mjs OUT.mjs && node OUT.mjs --size 1280x720 --out OUT PACKAGE...
//
// Writes OUT/frames.json, and OUT/NAME.png of each package: above, a picture while it turns; below, the still.
import { mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { parseArgs } from "node:util";
import { create, globals } from "webgpu";
import { Stage } from "../../runtime/web/src/element/stage.js";
import { read } from "../../runtime/web/src/webgpu/gpu_device.js";
import { writePng } from "./png.mjs";

const SUN = { sunAzimuth: 40, sunHeight: 45, sun: 2 };  // of the page
const BACKDROP = [0.051, 0.056, 0.063];
const STEP = Math.PI / 180;  // of the turn from frame to frame, radians
const SAMPLES = 16;          // of a still
const WARM_UP = 5;           // pictures that are not timed

/** The browser's parts that Stage needs: WebGPU, a canvas, a place that it fills. */
function makeBrowser(width, height) {
  const gpu = create([]), named = { ...globals, navigator: { gpu }, devicePixelRatio: 1 };
  gpu.getPreferredCanvasFormat = () => "rgba8unorm";
  for (const [name, value] of Object.entries(named)) Object.defineProperty(globalThis, name, { value, configurable: true });
  globalThis.ResizeObserver = class { observe() {} };
  globalThis.document = { createElement: () => new Canvas() };
  return { clientWidth: width, clientHeight: height, replaceChildren() {} };
}

class Canvas extends EventTarget {
  getContext() {
    return {
      configure: (options) => { this.options = options; },
      getCurrentTexture: () => (this.texture ??= this.options.device.createTexture({ ...this.options, size: [this.width, this.height] })),
    };
  }

  /** RGBA, 8 bits, rows from the top. */
  async pixels() {
    const { device } = this.options, { width, height } = this, stride = Math.ceil(width / 64) * 256;
    const rows = device.createBuffer({ size: stride * height, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.COPY_SRC });
    const encoder = device.createCommandEncoder();
    encoder.copyTextureToBuffer({ texture: this.texture }, { buffer: rows, bytesPerRow: stride }, [width, height]);
    device.queue.submit([encoder.finish()]);
    const all = Buffer.from(await read(device, rows, stride * height));
    return Buffer.concat(Array.from({ length: height }, (_, y) => all.subarray(y * stride, y * stride + 4 * width)));
  }
}

const lines = { say: (text, calm) => text && !calm && console.error(text) };

async function openStage(place, path) {
  const settings = { tier: null, variantName: null, sun: SUN, ground: true };
  const stage = new Stage(place, lines, settings), loaded = once(stage, "load");
  stage.setBackdrop(BACKDROP);
  stage.reset();
  const begun = performance.now();
  if (!(await stage.begin())) throw new Error("no WebGPU here");
  await stage.open(new File([readFileSync(path)], basename(path)));
  if (!stage.shown) throw new Error(`${path} was not shown`);
  await loaded;
  return { stage, load: performance.now() - begun };
}

const once = (target, name) => new Promise((resolve) => target.addEventListener(name, resolve, { once: true }));

/** Picture after picture by `change`, each seen before the next: ms of each, and the sizes as one in so many. */
async function moving(stage, change, { repeats, seconds }) {
  const times = [], scales = new Set(), { viewer, engine } = stage;
  await engine.done();
  const until = performance.now() + 1e3 * seconds;
  for (let k = -WARM_UP; k < repeats && (k < 3 || performance.now() < until); k++) {
    const begun = performance.now(), shown = once(viewer, "shown");
    change(k);
    await shown;
    await engine.done();
    if (k < 0) continue;
    times.push(performance.now() - begun);
    scales.add(viewer.stats.scale);
  }
  return { ...summary(times), scales: [...scales] };
}

/** Stills one after the other: ms to the first picture in full size, of a sample, and to so many samples. */
async function stills(stage, { repeats, seconds }) {
  const first = [], sample = [], sharp = [], { viewer, engine } = stage, until = performance.now() + 1e3 * seconds;
  for (let k = -1; k < repeats && (k < 1 || performance.now() < until); k++) {
    const begun = performance.now();
    let last = begun, isFull = false;
    viewer.restart();
    for (;;) {
      await once(viewer, "shown");
      const now = performance.now(), { scale, rounds } = viewer.stats;
      if (k >= 0 && scale === 1 && !isFull) first.push(now - begun);
      if (k >= 0 && scale === 1 && rounds > 1) sample.push(now - last);
      isFull ||= scale === 1;
      last = now;
      if (scale === 1 && rounds >= SAMPLES) break;
    }
    await engine.done();
    if (k >= 0) sharp.push(performance.now() - begun);
  }
  return { first_full_size: summary(first), sample: summary(sample), [`still_of_${SAMPLES}_samples`]: summary(sharp) };
}

/** ms of a sample where nothing waits for the GPU between the bands of the picture: what its arithmetic takes. */
async function queued(stage, { seconds }) {
  const { viewer, engine, orbit } = stage, { width, height } = engine.target, times = [];
  const camera = { ...orbit.camera(width, height), jitter: 1 }, rows = Math.max(1, Math.floor(engine.bandPixels / width));
  viewer.pause();
  await engine.done();
  const until = performance.now() + 1e3 * seconds;
  for (let k = 0; k < SAMPLES && (k < 2 || performance.now() < until); k++) {
    const begun = performance.now();
    for (let from = 0; from < height; from += rows) viewer._band(camera, k, viewer.lights, from, Math.min(height, from + rows));
    await engine.done();
    if (k > 0) times.push(performance.now() - begun);
  }
  return summary(times);
}

const rounded = (value) => Number(value.toPrecision(4));

function summary(times) {
  const sorted = [...times].sort((a, b) => a - b), at = (share) => rounded(sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))]);
  return sorted.length ? { count: sorted.length, median_ms: at(0.5), fastest_ms: at(0), slowest_ms: at(1) } : { count: 0 };
}

async function measure(place, path, out, limits) {
  const { stage, load } = await openStage(place, path), { viewer, engine, canvas, opened, shown } = stage;
  const camera = await moving(stage, () => {
    stage.orbit.turn(STEP, 0);
    viewer.restart(true);
  }, limits);
  const turning = await moving(stage, (k) => stage.turnTable(k * STEP, true), limits), turned = await canvas.pixels();
  stage.turnTable(0, false);
  const still = await stills(stage, limits);
  viewer.show();
  writePng(join(out, `${basename(path, ".rna")}.png`), Buffer.concat([turned, await canvas.pixels()]), canvas.width);
  const adapter = (({ vendor, architecture, description }) => ({ vendor, architecture, description }))(engine.device.adapterInfo);
  const result = {
    asset: opened.manifest.name, tier: shown.name, adapter, lights: viewer.lights.length, lights_while_turning: viewer.firstLights?.length ?? viewer.lights.length,
    load_ms: rounded(load), camera_moves: camera, turning, frames_per_second: rounded(1e3 / turning.median_ms), ...still,
    sample_queued: await queued(stage, limits),
  };
  stage.close();
  return result;
}

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { size: { type: "string", default: "1280x720" }, out: { type: "string", default: "." }, repeats: { type: "string", default: "40" }, seconds: { type: "string", default: "3" } },
});
const [width, height] = values.size.split("x").map(Number), limits = { repeats: Number(values.repeats), seconds: Number(values.seconds) };
mkdirSync(values.out, { recursive: true });
const place = makeBrowser(width, height), file = join(values.out, "frames.json");
const results = { size: [width, height], node: process.version, assets: {} };
for (const path of positionals) {
  results.assets[basename(path, ".rna")] = await measure(place, path, values.out, limits);
  writeFileSync(`${file}.new`, JSON.stringify(results, null, 1) + "\n");
  renameSync(`${file}.new`, file);
}
console.log(JSON.stringify(results, null, 1));
process.exit(0);  // Dawn's device waits for more work
