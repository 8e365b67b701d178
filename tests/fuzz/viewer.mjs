// Packages through the viewer's reader, in Node: node viewer.mjs SRC < MUTATIONS
//
// SRC: the folder runtime/web/src/package. Reads packages, each behind its size in four bytes, and prints
// JSON: verdicts ("accepted", or the code of a refusal), warnings, and failures, each [number, text]: any
// exception but a refusal, and any asset with an index, a range or a size that does not fit.
import { register } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

// The sources import JSON as the bundler does, without an attribute.
const hooks = `import { readFile } from "node:fs/promises";
export async function load(url, context, next) {
  if (!url.endsWith(".json")) return next(url, context);
  return { format: "module", shortCircuit: true, source: "export default " + await readFile(new URL(url), "utf8") };
}`;
register(`data:text/javascript,${encodeURIComponent(hooks)}`);

const folder = resolve(process.argv[2]);
const load = (name) => import(pathToFileURL(join(folder, name)));
const { Package } = await load("package.js");
const { BlobSource } = await load("source.js");
const { NotSupported, PackageError } = await load("errors.js");

const SLOW_MS = 20000;

// Node decodes no images: each is black, of one size.
globalThis.createImageBitmap = async () => ({ width: 4, height: 3 });
globalThis.OffscreenCanvas = class {
  getContext(kind) {
    const getImageData = (x, y, width, height) => ({ data: new Uint8ClampedArray(4 * width * height) });
    return kind === "2d" ? { drawImage() {}, getImageData } : null;
  }
};

// Each entry in a buffer of its own size: a view past its end, inside the package, is a RangeError.
const read = Package.prototype._data;
Package.prototype._data = async function exactly(name) {
  return (await read.call(this, name)).slice();
};

function expect(right, text) {
  if (!right) throw new Error(text);
}

function checkTexture({ triangles: [first, count], texture }, mesh) {
  const { values, height, width, channels } = texture;
  expect(first + count <= mesh.indices.length / 3, "a record past the mesh");
  expect(values.length === height * width * channels, "a texture of another size");
}

function checkBaseColor({ triangles: [first, count], image }, mesh) {
  expect(first + count <= mesh.indices.length / 3, "base colour past the mesh");
  expect(!image || (mesh.uvs && image.pixels.length === 4 * image.width * image.height), "an image of another size");
}

function checkPart({ mesh, curves, transmittance, normalMaps, baseColor, planes, decoders, environment }) {
  if (mesh) {
    expect(mesh.positions.length === mesh.normals.length, "normals of another count");
    expect(!mesh.uvs || mesh.uvs.length / 2 === mesh.positions.length / 3, "uvs of another count");
    expect(mesh.indices.every((index) => 3 * index + 2 < mesh.positions.length), "a vertex that is not there");
    [...transmittance, ...normalMaps].forEach((record) => checkTexture(record, mesh));
    baseColor.forEach((record) => checkBaseColor(record, mesh));
  } else {
    expect(curves.points.length === 3 * curves.radii.length, "radii of another count");
    expect(curves.offsets.every((offset) => offset <= curves.radii.length), "a point that is not there");
  }
  expect((mesh?.positions ?? curves.points).every(Number.isFinite), "a position that is not finite");
  expect(planes.values.length === 3 * planes.resolution ** 2 * planes.channels, "planes of another size");
  if (environment?.harmonics) {
    expect(environment.harmonics.length * 3 === 16 * (mesh?.positions ?? curves.points).length, "harmonics of another count");
  }
  for (const { layers } of [...Object.values(decoders), environment].filter(Boolean)) {
    for (const { weight, bias, rows, columns } of layers) {
      expect(weight.length === rows * columns && bias.length === columns, "a layer of another size");
    }
  }
}

/** "accepted", or the code of the refusal; warnings go to `lines`. */
async function verdict(bytes, lines) {
  try {
    const opened = await Package.open(new BlobSource(new Blob([bytes]), "mutation"));
    lines.push(...opened.manifest.warnings);
    for (const { name } of opened.manifest.tiers) {
      const { parts } = await opened.load(name, { wantsLobes: true });
      parts.forEach(checkPart);
    }
    await opened.posterImage();
    return "accepted";
  } catch (error) {
    if (error instanceof PackageError) return error.code;
    if (error instanceof NotSupported) return "NOT_SUPPORTED";
    throw error;
  }
}

async function* mutations() {
  let rest = Buffer.alloc(0);
  for await (const piece of process.stdin) {
    rest = rest.length ? Buffer.concat([rest, piece]) : piece;
    let at = 0;
    while (rest.length - at >= 4 && rest.length - at - 4 >= rest.readUInt32LE(at)) {
      const size = rest.readUInt32LE(at);
      yield Uint8Array.from(rest.subarray(at + 4, at + 4 + size));
      at += 4 + size;
    }
    rest = rest.subarray(at);
  }
}

const report = { verdicts: [], warnings: [], failures: [] };
for await (const bytes of mutations()) {
  const started = performance.now(), lines = [];
  let outcome = "failed";
  try {
    outcome = await verdict(bytes, lines);
    expect(performance.now() - started < SLOW_MS, `more than ${SLOW_MS} ms`);
  } catch (error) {
    report.failures.push([report.verdicts.length, `${error.name}: ${error.message}`.slice(0, 300)]);
  }
  report.verdicts.push(outcome);
  report.warnings.push(lines);
}
console.log(JSON.stringify(report));
