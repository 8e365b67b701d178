// What shaders know of an asset's geometry: all parts in one hierarchy, in the layouts of rna_gpu/wgsl/geometry.wgsl,
// render/surfaces.wgsl and render/textures.wgsl.
import { constants, records } from "../decoder/records.js";
import { finished, inSteps } from "../steps.js";
import { buildHierarchy } from "./bvh.js";
import { SurfaceTable } from "./surface_table.js";

const { RNA_HAS_BEFORE, RNA_HAS_AFTER, RNA_IS_SEGMENT, RNA_SURFACE_SHIFT } = constants;
const PRIMITIVE = records.RnaPrimitive, NODE = records.RnaNode;

/**
 * In steps, between which the page answers. nodes: one of the only instance, then those of the hierarchy. primitives: RnaPrimitive, in the order of the leaves.
 * points: x, y, z, and u or the radius. normals: n, v, of meshes' points. table, images: of the surfaces (SurfaceTable).
 * where: of a primitive's number its place in `primitives`; numbers count through all parts, of which `parts[k].first` is
 * the first of part k, and `parts[k].point` its first point. surfaces: the table, for other prints. extent: the largest coordinate.
 */
export const sceneArrays = (parts) => finished(arraysOf(parts));

function* arraysOf(parts) {
  const counts = parts.map(countsOf);
  const total = (name) => counts.reduce((sum, own) => sum + own[name], 0);
  const arrays = {
    primitives: new Uint32Array(PRIMITIVE.words * total("primitives")),
    points: new Float32Array(4 * total("points")),
    normals: new Float32Array(4 * total("normals")),
    boxes: new Float32Array(6 * total("primitives")),
    surfaces: new SurfaceTable(), parts: [], extent: 0, strands: 0,
  };
  let at = { primitive: 0, point: 0 };
  // Meshes first, so that only their points have normals.
  const order = [...parts.keys()].sort((a, b) => (parts[a].kind === "fiber") - (parts[b].kind === "fiber"));
  for (const k of order) {
    const part = parts[k];
    arrays.parts[k] = { first: at.primitive, point: at.point, fiber: part.kind === "fiber" };
    if (part.kind === "fiber") yield* addCurves(arrays, part.curves, k, at);
    else yield* addMesh(arrays, part, k, at);
    at = { primitive: at.primitive + counts[k].primitives, point: at.point + counts[k].points };
  }
  const { nodes, order: leaves } = yield* buildHierarchy(arrays.boxes, 1);
  const primitives = new Uint32Array(arrays.primitives.length), where = new Uint32Array(leaves.length);
  yield* inSteps(0, leaves.length, (first, end) => {
    for (let to = first; to < end; to++) {
      const from = leaves[to], own = arrays.primitives.subarray(PRIMITIVE.words * from, PRIMITIVE.words * (from + 1));
      primitives.set(own, PRIMITIVE.words * to);
      where[from] = to;
    }
  });
  return { ...arrays, boxes: null, ...arrays.surfaces.arrays(), primitives, nodes: withInstance(nodes), where, box: boxOf(nodes) };
}

function countsOf({ kind, mesh, curves }) {
  if (kind === "surface") {
    const points = mesh.positions.length / 3;
    return { primitives: mesh.indices.length / 3, points, normals: points };
  }
  const points = curves.radii.length;
  return { primitives: points - (curves.offsets.length - 1), points, normals: 0 };
}

function* addMesh(arrays, part, number, { primitive, point }) {
  const { positions, normals, uvs, indices } = part.mesh, { points, boxes, primitives } = arrays;
  yield* inSteps(0, positions.length / 3, (from, to) => {
    for (let k = from; k < to; k++) {
      const at = 4 * (point + k);
      for (let axis = 0; axis < 3; axis++) {
        points[at + axis] = positions[3 * k + axis];
        arrays.normals[at + axis] = normals[3 * k + axis];
        arrays.extent = Math.max(arrays.extent, Math.abs(positions[3 * k + axis]));
      }
      points[at + 3] = uvs ? uvs[2 * k] : 0;
      arrays.normals[at + 3] = uvs ? uvs[2 * k + 1] : 0;
    }
  });
  const surfaces = yield* arrays.surfaces.ofTriangles(part, number);
  yield* inSteps(0, indices.length / 3, (from, to) => {
    for (let k = from; k < to; k++) {
      const corners = [0, 1, 2].map((c) => indices[3 * k + c]);
      const [a, b, c] = corners.map((corner) => corner + point);
      setPrimitive(primitives, primitive + k, a, b, c, surfaces[k] << RNA_SURFACE_SHIFT);
      for (let axis = 0; axis < 3; axis++) {
        const values = corners.map((corner) => positions[3 * corner + axis]);
        boxes[6 * (primitive + k) + axis] = Math.min(...values);
        boxes[6 * (primitive + k) + 3 + axis] = Math.max(...values);
      }
    }
  });
}

function* addCurves(arrays, curves, part, { primitive, point }) {
  const { boxes, primitives } = arrays, { radii, offsets } = curves, surface = arrays.surfaces.ofFibers(part);
  yield* inSteps(0, radii.length, (from, to) => {
    for (let k = from; k < to; k++) {
      const [x, y, z] = curves.points.subarray(3 * k, 3 * k + 3);
      arrays.points.set([x, y, z, radii[k]], 4 * (point + k));
      arrays.extent = Math.max(arrays.extent, Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) + radii[k]);
    }
  });
  let number = primitive;
  for (let strand = 0; strand + 1 < offsets.length; strand++, arrays.strands++) {
    yield;
    for (let k = offsets[strand]; k + 1 < offsets[strand + 1]; k++, number++) {
      const neighbours = (k > offsets[strand] && RNA_HAS_BEFORE) | (k + 2 < offsets[strand + 1] && RNA_HAS_AFTER);
      setPrimitive(primitives, number, point + k, neighbours, arrays.strands, (surface << RNA_SURFACE_SHIFT) | RNA_IS_SEGMENT);
      for (let axis = 0; axis < 3; axis++) {
        const a = curves.points[3 * k + axis], b = curves.points[3 * k + 3 + axis];
        // Half a thousandth more, since the intersection rounds.
        const ra = radii[k] * 1.0005, rb = radii[k + 1] * 1.0005;
        boxes[6 * number + axis] = Math.min(a - ra, b - rb);
        boxes[6 * number + 3 + axis] = Math.max(a + ra, b + rb);
      }
    }
  }
}

/** Record k of the primitives. */
function setPrimitive(words, k, a, b, c, tag) {
  const { members, words: size } = PRIMITIVE, at = size * k;
  words[at + members.a.at] = a;
  words[at + members.b.at] = b;
  words[at + members.c.at] = c;
  words[at + members.tag.at] = tag;
}

/** The nodes behind a leaf with instance 0. */
function withInstance(nodes) {
  const all = new Uint32Array(nodes.length + NODE.words);
  all.set(nodes.subarray(0, NODE.words));
  all[NODE.members.child.at] = 0;
  all[NODE.members.count.at] = 1;
  all.set(nodes, NODE.words);
  return all;
}

function boxOf(nodes) {
  const box = new Float32Array(nodes.buffer, 0, NODE.words), corner = ({ at, count }) => [...box.subarray(at, at + count)];
  return { min: corner(NODE.members.low), max: corner(NODE.members.high) };
}
