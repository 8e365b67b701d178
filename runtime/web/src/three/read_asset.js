// From the bytes of a package to plain arrays, as the GPU takes them. It runs in a worker, or where there is none in the
// page: it knows nothing of three.js.
import { packDecoder, planeWords } from "../decoder/pack_decoder.js";
import { constants } from "../decoder/records.js";
import { sceneArrays } from "../geometry/scene_arrays.js";
import { Package } from "../package/package.js";
import { BlobSource } from "../package/source.js";
import { cross, times, unit } from "../vectors.js";

/** The data that `RnaAsset` shows. wanted: a tier's name, or null for all. variant: its name, or null for the package's own print. */
export async function readAsset(bytes, name, wanted = null, variant = null) {
  const opened = await Package.open(new BlobSource(new Blob([bytes]), name));
  if (variant !== null && !opened.variants.includes(variant)) {
    throw new Error(`setVariant: expected ${opened.variants.map((one) => JSON.stringify(one)).join(" or ") || "a package with variants"}, found ${JSON.stringify(variant)}`);
  }
  opened.variant = variant;
  const names = wanted ? [opened.tier(wanted).name] : opened.manifest.tiers.map((tier) => tier.name);
  const loaded = [];
  for (const tier of names) loaded.push(await opened.load(tier));
  const { parts } = loaded[0], arrays = await sceneArrays(parts);
  return {
    name: opened.manifest.name, manifest: opened.manifest, box: arrays.box, geometry: shared(arrays),
    parts: parts.map((part, k) => ({ name: part.name, kind: part.kind, hasUVs: !!part.mesh?.uvs, ...drawn(k, arrays) })),
    tiers: loaded.map(tierOf),
    notes: notesOf(parts),
  };
}

/** The arrays' own buffers, to be handed over rather than copied. */
export function buffersOf(value, buffers = new Set()) {
  if (ArrayBuffer.isView(value)) buffers.add(value.buffer);
  else if (value && typeof value === "object") Object.values(value).forEach((one) => buffersOf(one, buffers));
  return [...buffers];
}

/** Of all parts: normals lie behind the points; of the surfaces the base colour. */
function shared({ nodes, primitives, points, normals, surfaces, extent, strands }) {
  const both = new Float32Array(points.length + normals.length);
  both.set(points);
  both.set(normals, points.length);
  for (const { piece, label } of surfaces.textures) if (label === undefined) surfaces.pieces[piece] = new Uint32Array(0);
  return { nodes, primitives, points: both, surfaces: { ...surfaces }, normalsAt: points.length / 4, extent, hasSegments: strands > 0 };
}

/** The rasterised geometry of a part: `primitive` has the number of each corner's triangle or segment. */
function drawn(k, arrays) {
  const { first, fiber } = arrays.parts[k], next = arrays.parts.map((part) => part.first).filter((start) => start > first);
  const count = Math.min(arrays.primitives.length / 4, ...next) - first;
  const numbers = arrays.where.subarray(first, first + count);
  return fiber ? boxes(numbers, arrays) : triangles(numbers, arrays);
}

function triangles(numbers, { primitives, points, normals }) {
  const corners = 3 * numbers.length;
  const attributes = { position: new Float32Array(3 * corners), normal: new Float32Array(3 * corners), primitive: new Uint32Array(corners) };
  numbers.forEach((number, k) => {
    for (let c = 0; c < 3; c++) {
      const point = 4 * primitives[4 * number + c], to = 3 * (3 * k + c);
      for (let axis = 0; axis < 3; axis++) {
        attributes.position[to + axis] = points[point + axis];
        attributes.normal[to + axis] = normals[point + axis];
      }
      attributes.primitive[3 * k + c] = number;
    }
  });
  return attributes;
}

// How much wider: corners are rasterised on a grid, and a box thinner than a pixel must not miss what the strand covers.
const PAD = 1.1;
// Corners of a box's triangles, seen from outside: the sides, then the two ends.
const BOX = [0, 1, 2, 3].flatMap((p) => { const q = (p + 1) % 4; return [p, q, q + 4, p, q + 4, p + 4]; }).concat(0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7);

/** A box about each segment, round ends included; `begin` in fiber.wgsl finds the segment in it. */
function boxes(numbers, { primitives, points }) {
  const corners = 8 * numbers.length;
  const attributes = { position: new Float32Array(3 * corners), normal: new Float32Array(3 * corners), primitive: new Uint32Array(corners), index: new Uint32Array(BOX.length * numbers.length) };
  numbers.forEach((number, k) => {
    const first = 4 * primitives[4 * number], [a, b] = [points.subarray(first, first + 4), points.subarray(first + 4, first + 8)];
    const { along, sides } = frameOf(a, b);
    for (let c = 0; c < 8; c++) {
      const end = c < 4 ? a : b, away = PAD * (c < 4 ? -end[3] : end[3]), to = 3 * (8 * k + c), side = sides[c % 4];
      for (let axis = 0; axis < 3; axis++) {
        attributes.position[to + axis] = end[axis] + away * along[axis] + Math.SQRT2 * PAD * end[3] * side[axis];
        attributes.normal[to + axis] = side[axis];
      }
      attributes.primitive[8 * k + c] = number;
    }
    attributes.index.set(BOX.map((corner) => 8 * k + corner), BOX.length * k);
  });
  return attributes;
}

/** Unit vectors along a segment and to the corners of its box. */
function frameOf(a, b) {
  const along = unit([0, 1, 2].map((axis) => b[axis] - a[axis]));
  const u = unit(cross(along, Math.abs(along[0]) > 0.7 ? [0, 1, 0] : [1, 0, 0])), v = cross(along, u);
  return { along, sides: [u, v, times(u, -1), times(v, -1)] };
}

/** work: multiply-adds a query; those of int8 decoders count half. */
function tierOf({ name, tier, parts }) {
  const isInt8 = tier.parts.every(({ decoderPrecision }) => decoderPrecision === "int8");
  const work = (tier.cost?.multiplyAdds ?? Infinity) * (isInt8 ? 0.5 : 1);
  return { name, validation: tier.validation, work, parts: parts.map(decoders) };
}

function decoders(part) {
  const make = (decoder) => {
    const { weights, record, groups } = packDecoder(part, decoder, decoder.inputs), fits = weights.length / 4 <= constants.UNIFORM_WEIGHTS;
    const padded = fits ? new Float32Array(4 * constants.UNIFORM_WEIGHTS) : weights;
    if (fits) padded.set(weights);
    return { weights: padded, record, groups, uniform: fits };
  };
  const stored = [0, 1, 2].map((k) => planeWords(part.planes, k)), bytes = stored[0].byteLength, planes = new Uint8Array(3 * bytes);
  stored.forEach((plane, k) => planes.set(new Uint8Array(plane.buffer, plane.byteOffset, bytes), k * bytes));
  return { lengths: part.lengths, planes: new Uint32Array(planes.buffer), decoders: Object.fromEntries(Object.entries(part.decoders).map(([form, decoder]) => [form, make(decoder)])) };
}

/** The contents of the package that this module does not show. */
function notesOf(parts) {
  const notes = [];
  if (parts.some(({ transmittance }) => transmittance.length)) notes.push("holes and panes are shown opaque");
  if (parts.some(({ normalMaps }) => normalMaps.length)) notes.push("normal maps are not applied");
  return notes;
}
