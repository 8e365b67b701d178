// What shaders know of an asset's geometry: all parts in one hierarchy, and the glass beside it in another, in the layouts of rna_gpu/wgsl/geometry.wgsl,
// render/surfaces.wgsl and render/textures.wgsl.
import { constants, records } from "../decoder/records.js";
import { finished, inSteps } from "../steps.js";
import { buildHierarchy } from "./bvh.js";
import { SurfaceTable } from "./surface_table.js";

const { RNA_HAS_BEFORE, RNA_HAS_AFTER, RNA_IS_SEGMENT, RNA_SURFACE_SHIFT } = constants;
const PRIMITIVE = records.RnaPrimitive, NODE = records.RnaNode;

/**
 * In steps, between which the page answers. parts: of a tier. glass: of readGlass, or null. nodes: one above the
 * instances, which are the asset and the glass, then those of the asset and from `glassRoot` on of the glass. primitives: RnaPrimitive, in the order of the leaves.
 * points: x, y, z, and u or the radius. normals: n, v, of meshes' points. table, images: of the surfaces (SurfaceTable).
 * where: of a primitive's number its place in `primitives`; numbers count through all parts, of which `parts[k].first` is
 * the first of part k, and `parts[k].point` its first point. surfaces: the table, for other prints. extent: the largest coordinate.
 */
export const sceneArrays = (parts, glass = null) => finished(arraysOf(parts, glass));

function* arraysOf(parts, glass) {
  const counts = [...parts, ...(glass ? [glass] : [])].map(countsOf);
  const total = (name) => counts.reduce((sum, count) => sum + count[name], 0);
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
    if (part.kind === "fiber") yield* addCurves(arrays, part, k, at);
    else yield* addMesh(arrays, part.mesh, yield* arrays.surfaces.ofTriangles(part, k), at);
    at = { primitive: at.primitive + counts[k].primitives, point: at.point + counts[k].points };
  }
  if (glass) {
    const surfaces = arrays.surfaces.ofGlass(glass.materials);
    yield* addMesh(arrays, glass.mesh, glass.materialOf.map((k) => surfaces[k]), at);
  }
  const bodies = [yield* buildHierarchy(arrays.boxes.subarray(0, 6 * at.primitive), 1)];
  const glassRoot = glass && 1 + bodies[0].nodes.length / NODE.words;
  if (glass) bodies.push(yield* buildHierarchy(arrays.boxes.subarray(6 * at.primitive), glassRoot, at.primitive));
  const leaves = joined(bodies.map(({ order }) => order));
  const primitives = new Uint32Array(arrays.primitives.length), where = new Uint32Array(leaves.length);
  yield* inSteps(0, leaves.length, (first, end) => {
    for (let to = first; to < end; to++) {
      const from = leaves[to], record = arrays.primitives.subarray(PRIMITIVE.words * from, PRIMITIVE.words * (from + 1));
      primitives.set(record, PRIMITIVE.words * to);
      where[from] = to;
    }
  });
  const above = nodeAbove(bodies), nodes = joined([above, ...bodies.map((body) => body.nodes)]);
  return { ...arrays, boxes: null, ...arrays.surfaces.arrays(), primitives, nodes, where, glassRoot, box: boxOf(above) };
}

function countsOf({ mesh, curves }) {
  if (mesh) {
    const points = mesh.positions.length / 3;
    return { primitives: mesh.indices.length / 3, points, normals: points };
  }
  const points = curves.radii.length;
  return { primitives: points - (curves.offsets.length - 1), points, normals: 0 };
}

/** surfaces: number of each triangle's. */
function* addMesh(arrays, { positions, normals, uvs, indices }, surfaces, { primitive, point }) {
  const { points, boxes, primitives } = arrays;
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

function* addCurves(arrays, part, k, { primitive, point }) {
  const { boxes, primitives } = arrays, { curves } = part, { radii, offsets } = curves, surface = arrays.surfaces.ofFibers(part, k);
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

/** A leaf with an instance of each hierarchy, whose box is about all of them. */
function nodeAbove(bodies) {
  const { low, high, child, count } = NODE.members, all = new Uint32Array(NODE.words), box = new Float32Array(all.buffer);
  const boxes = bodies.map(({ nodes }) => boxOf(nodes));
  for (let axis = 0; axis < 3; axis++) {
    box[low.at + axis] = Math.min(...boxes.map(({ min }) => min[axis]));
    box[high.at + axis] = Math.max(...boxes.map(({ max }) => max[axis]));
  }
  all[child.at] = 0;
  all[count.at] = bodies.length;
  return all;
}

function joined(lists) {
  const all = new Uint32Array(lists.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const list of lists) {
    all.set(list, at);
    at += list.length;
  }
  return all;
}

function boxOf(nodes) {
  const box = new Float32Array(nodes.buffer, 0, NODE.words), corner = ({ at, count }) => [...box.subarray(at, at + count)];
  return { min: corner(NODE.members.low), max: corner(NODE.members.high) };
}
