// What shaders know of an asset's geometry: all parts in one hierarchy, in the layouts of rna_gpu/wgsl/geometry.wgsl,
// render/surfaces.wgsl and render/textures.wgsl.
import { buildHierarchy } from "./bvh.js";
import { SurfaceTable } from "./surface_table.js";

const HAS_BEFORE = 1, HAS_AFTER = 2;

/**
 * nodes: one of the only instance, then those of the hierarchy. primitives: 4 words each, in the order of the leaves.
 * points: x, y, z, and u or the radius. normals: n, v, of meshes' points. table, images: of the surfaces (SurfaceTable).
 * where: of a primitive's number its place in `primitives`; numbers count through all parts, of which `parts[k].first` is
 * the first of part k. extent: the largest coordinate.
 */
export function sceneArrays(parts) {
  const counts = parts.map(countsOf);
  const total = (name) => counts.reduce((sum, own) => sum + own[name], 0);
  const arrays = {
    primitives: new Uint32Array(4 * total("primitives")),
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
    arrays.parts[k] = { first: at.primitive, fiber: part.kind === "fiber" };
    if (part.kind === "fiber") addCurves(arrays, part.curves, k, at);
    else addMesh(arrays, part, k, at);
    at = { primitive: at.primitive + counts[k].primitives, point: at.point + counts[k].points };
  }
  const { nodes, order: leaves } = buildHierarchy(arrays.boxes, 1);
  const primitives = new Uint32Array(arrays.primitives.length), where = new Uint32Array(leaves.length);
  leaves.forEach((from, to) => {
    primitives.set(arrays.primitives.subarray(4 * from, 4 * from + 4), 4 * to);
    where[from] = to;
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

function addMesh(arrays, part, number, { primitive, point }) {
  const { positions, normals, uvs, indices } = part.mesh, { points, boxes, primitives } = arrays;
  for (let k = 0; k < positions.length / 3; k++) {
    const at = 4 * (point + k);
    for (let axis = 0; axis < 3; axis++) {
      points[at + axis] = positions[3 * k + axis];
      arrays.normals[at + axis] = normals[3 * k + axis];
      arrays.extent = Math.max(arrays.extent, Math.abs(positions[3 * k + axis]));
    }
    points[at + 3] = uvs ? uvs[2 * k] : 0;
    arrays.normals[at + 3] = uvs ? uvs[2 * k + 1] : 0;
  }
  const surfaces = arrays.surfaces.ofTriangles(part, number);
  for (let k = 0; k < indices.length / 3; k++) {
    const corners = [0, 1, 2].map((c) => indices[3 * k + c]);
    primitives.set([...corners.map((corner) => corner + point), 2 * surfaces[k]], 4 * (primitive + k));
    for (let axis = 0; axis < 3; axis++) {
      const values = corners.map((corner) => positions[3 * corner + axis]);
      boxes[6 * (primitive + k) + axis] = Math.min(...values);
      boxes[6 * (primitive + k) + 3 + axis] = Math.max(...values);
    }
  }
}

function addCurves(arrays, curves, part, { primitive, point }) {
  const { boxes, primitives } = arrays, { radii, offsets } = curves, surface = arrays.surfaces.ofFibers(part);
  for (let k = 0; k < radii.length; k++) {
    const [x, y, z] = curves.points.subarray(3 * k, 3 * k + 3);
    arrays.points.set([x, y, z, radii[k]], 4 * (point + k));
    arrays.extent = Math.max(arrays.extent, Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) + radii[k]);
  }
  let number = primitive;
  for (let strand = 0; strand + 1 < offsets.length; strand++, arrays.strands++) {
    for (let k = offsets[strand]; k + 1 < offsets[strand + 1]; k++, number++) {
      const neighbours = (k > offsets[strand] && HAS_BEFORE) | (k + 2 < offsets[strand + 1] && HAS_AFTER);
      primitives.set([point + k, neighbours, arrays.strands, 2 * surface + 1], 4 * number);
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

/** The nodes behind a leaf with instance 0. */
function withInstance(nodes) {
  const all = new Uint32Array(nodes.length + 8);
  all.set(nodes.subarray(0, 8));
  all[3] = 0;
  all[7] = 1;
  all.set(nodes, 8);
  return all;
}

function boxOf(nodes) {
  const box = new Float32Array(nodes.buffer, 0, 8);
  return { min: [...box.subarray(0, 3)], max: [...box.subarray(4, 7)] };
}
