// What shaders know of an asset's geometry: all parts in one hierarchy, as arrays of words.
import { buildHierarchy } from "./bvh.js";

const SEGMENT = 0x80000000;
const HAS_BEFORE = 1, HAS_AFTER = 2;

/**
 * nodes, primitives (4 words each, in the order of the leaves), places (x, y, z, and u or the radius), normals (n,
 * v), records of textures, their texels; and numbers.
 *
 * A primitive is its three corners and its number, or point, neighbours and strand of a segment and its
 * number with the top bit set. Numbers count through all parts: `parts[k].first` is the first of part k.
 */
export function sceneArrays(parts) {
  const counts = parts.map(countsOf);
  const total = (name) => counts.reduce((sum, own) => sum + own[name], 0);
  const arrays = {
    primitives: new Uint32Array(4 * total("primitives")),
    places: new Float32Array(4 * total("vertices")),
    normals: new Float32Array(4 * total("corners")),
    boxes: new Float32Array(6 * total("primitives")),
    records: [], texels: [], parts: [], largest: 0, strands: 0,
  };
  let at = { primitive: 0, vertex: 0 };
  // Meshes first, so that only their vertices have normals.
  const order = [...parts.keys()].sort((a, b) => (parts[a].kind === "fiber") - (parts[b].kind === "fiber"));
  for (const k of order) {
    const part = parts[k];
    arrays.parts[k] = { first: at.primitive, count: counts[k].primitives, fiber: part.kind === "fiber" };
    if (part.kind === "fiber") addCurves(arrays, part.curves, at);
    else addMesh(arrays, part, at);
    at = { primitive: at.primitive + counts[k].primitives, vertex: at.vertex + counts[k].vertices };
  }
  const { nodes, order: leaves } = buildHierarchy(arrays.boxes);
  const primitives = new Uint32Array(arrays.primitives.length);
  leaves.forEach((from, to) => primitives.set(arrays.primitives.subarray(4 * from, 4 * from + 4), 4 * to));
  const where = new Uint32Array(leaves.length);  // of a number, the place in `primitives`
  leaves.forEach((from, to) => { where[from] = to; });
  return {
    ...arrays, boxes: null, primitives, nodes, where,
    texels: joined(arrays.texels), records: Uint32Array.from(arrays.records.flat()), recordCount: arrays.records.length,
    epsilon: arrays.largest * 2 ** -18, box: boxOf(nodes),
  };
}

function countsOf({ kind, mesh, curves }) {
  if (kind === "surface") {
    const vertices = mesh.positions.length / 3;
    return { primitives: mesh.indices.length / 3, vertices, corners: vertices };
  }
  const points = curves.radii.length;
  return { primitives: points - (curves.offsets.length - 1), vertices: points, corners: 0 };
}

function addMesh(arrays, { mesh, transmittance, normalMaps }, { primitive, vertex }) {
  const { positions, normals, uvs, indices } = mesh, { places, boxes, primitives } = arrays;
  for (let k = 0; k < positions.length / 3; k++) {
    const at = 4 * (vertex + k);
    for (let axis = 0; axis < 3; axis++) {
      places[at + axis] = positions[3 * k + axis];
      arrays.normals[at + axis] = normals[3 * k + axis];
      arrays.largest = Math.max(arrays.largest, Math.abs(positions[3 * k + axis]));
    }
    places[at + 3] = uvs ? uvs[2 * k] : 0;
    arrays.normals[at + 3] = uvs ? uvs[2 * k + 1] : 0;
  }
  for (let k = 0; k < indices.length / 3; k++) {
    const corners = [0, 1, 2].map((c) => indices[3 * k + c]);
    primitives.set([...corners.map((corner) => corner + vertex), primitive + k], 4 * (primitive + k));
    for (let axis = 0; axis < 3; axis++) {
      const values = corners.map((corner) => positions[3 * corner + axis]);
      boxes[6 * (primitive + k) + axis] = Math.min(...values);
      boxes[6 * (primitive + k) + 3 + axis] = Math.max(...values);
    }
  }
  for (const record of transmittance) addRecord(arrays, record, primitive, 0);
  for (const record of normalMaps) addRecord(arrays, record, primitive, 1);
}

const FLOAT = new Float32Array(1), BITS = new Uint32Array(FLOAT.buffer);

function bitsOf(value) {
  FLOAT[0] = value;
  return BITS[0];
}

/** Twelve words: kind, first, end, offset of texels; width, height, channels, cutoff; two indices of refraction. */
function addRecord(arrays, { triangles: [first, count], texture, cutoff, ior }, primitive, kind) {
  const offset = arrays.texels.reduce((sum, own) => sum + own.length, 0);
  arrays.texels.push(texture.values);
  arrays.records.push([
    kind, primitive + first, primitive + first + count, offset,
    texture.width, texture.height, texture.channels, bitsOf(cutoff ?? -1),
    bitsOf(ior?.[0] ?? 0), bitsOf(ior?.[1] ?? 0), 0, 0,
  ]);
}

function joined(pieces) {
  const result = new Uint8Array(pieces.reduce((sum, own) => sum + own.length, 0));
  let at = 0;
  for (const piece of pieces) {
    result.set(piece, at);
    at += piece.length;
  }
  return result;
}

function addCurves(arrays, { points, radii, offsets }, { primitive, vertex }) {
  const { places, boxes, primitives } = arrays;
  for (let k = 0; k < radii.length; k++) {
    const [x, y, z] = points.subarray(3 * k, 3 * k + 3);
    places.set([x, y, z, radii[k]], 4 * (vertex + k));
    arrays.largest = Math.max(arrays.largest, Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) + radii[k]);
  }
  let number = primitive;
  for (let strand = 0; strand + 1 < offsets.length; strand++, arrays.strands++) {
    for (let k = offsets[strand]; k + 1 < offsets[strand + 1]; k++, number++) {
      const neighbours = (k > offsets[strand] && HAS_BEFORE) | (k + 2 < offsets[strand + 1] && HAS_AFTER);
      primitives.set([vertex + k, neighbours, arrays.strands, (number | SEGMENT) >>> 0], 4 * number);
      for (let axis = 0; axis < 3; axis++) {
        const a = points[3 * k + axis], b = points[3 * k + 3 + axis];
        // Half a thousandth more, since the intersection rounds.
        const ra = radii[k] * 1.0005, rb = radii[k + 1] * 1.0005;
        boxes[6 * number + axis] = Math.min(a - ra, b - rb);
        boxes[6 * number + 3 + axis] = Math.max(a + ra, b + rb);
      }
    }
  }
}

function boxOf(nodes) {
  const box = new Float32Array(nodes.buffer, 0, 6);
  return { min: [...box.subarray(0, 3)], max: [...box.subarray(3, 6)] };
}
