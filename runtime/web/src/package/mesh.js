// Meshes (spec, 4.1): binary glTF in the profile of packages, quantised or not.
import { parseJson } from "./json.js";
import { fail } from "./errors.js";
import { checkProfile } from "./mesh_profile.js";
import { typed } from "./tensors.js";

const COMPONENTS = { 5122: Int16Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };
const ITEMS = { SCALAR: 1, VEC2: 2, VEC3: 3 };

/** { positions, normals, uvs or null, indices }. */
export function readMesh(bytes, where) {
  const { json, bin } = readChunks(bytes, where);
  const quantised = checkProfile(json, where);
  const buffer = json.buffers[0].byteLength;
  if (buffer > bin.length || bin.length - buffer > 3) {
    fail("GEOMETRY_RANGE", where, `a buffer of ${buffer} bytes in a chunk of ${bin.length}`);
  }
  const primitive = json.meshes[0].primitives[0];
  const read = (index) => readAccessor(json, bin.subarray(0, buffer), index, where);
  const stored = {
    positions: read(primitive.attributes.POSITION), normals: read(primitive.attributes.NORMAL),
    uvs: "TEXCOORD_0" in primitive.attributes ? read(primitive.attributes.TEXCOORD_0) : null,
    indices: read(primitive.indices),
  };
  checkCounts(stored, where);
  checkBounds(json.accessors[primitive.attributes.POSITION], stored.positions, quantised, where);
  const mesh = quantised ? restored(stored, json.nodes[0]) : stored;
  mesh.indices = Uint32Array.from(stored.indices);
  checkValues(mesh, where);
  return mesh;
}

/** { json, bin } of a binary glTF. */
export function readChunks(bytes, where) {
  const code = "GEOMETRY_CONTAINER";
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  if (bytes.length < 20 || data.getUint32(0, true) !== 0x46546c67 || data.getUint32(4, true) !== 2) {
    fail(code, where, "no binary glTF 2.0");
  }
  if (data.getUint32(8, true) !== bytes.length) fail(code, where, "the length in the header is not that of the entry");
  const chunks = [];
  for (let at = 12; at < bytes.length;) {
    if (at + 8 > bytes.length) fail(code, where, "a chunk is cut short");
    const length = data.getUint32(at, true), type = data.getUint32(at + 4, true);
    if (length % 4 || at + 8 + length > bytes.length) fail(code, where, `a chunk of ${length} bytes`);
    chunks.push([type, bytes.subarray(at + 8, at + 8 + length)]);
    at += 8 + length;
  }
  if (chunks.map(([type]) => type).join() !== [0x4e4f534a, 0x004e4942].join()) {
    fail(code, where, "not the chunks JSON and BIN");
  }
  if (chunks[0][1].length > 65536) fail(code, where, "JSON of more than 64 KiB");
  return { json: parseJson(chunks[0][1], where, code), bin: chunks[1][1] };
}

/** The values of an accessor. */
export function readAccessor(json, bin, index, where) {
  const accessor = json.accessors[index];
  if (!accessor) fail("GEOMETRY_RANGE", where, `no accessor ${index}`);
  const view = json.bufferViews[accessor.bufferView];
  if (!view) fail("GEOMETRY_RANGE", where, `no buffer view ${accessor.bufferView}`);
  const Type = COMPONENTS[accessor.componentType], items = ITEMS[accessor.type];
  const element = Type.BYTES_PER_ELEMENT * items, stride = view.byteStride ?? element;
  const start = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
  const needed = (accessor.byteOffset ?? 0) + stride * (accessor.count - 1) + element;
  if (needed > view.byteLength || (view.byteOffset ?? 0) + view.byteLength > bin.length) {
    fail("GEOMETRY_RANGE", where, `accessor ${index} reaches past its bytes`);
  }
  if (start % 4) fail("GEOMETRY_RANGE", where, `accessor ${index} is not aligned`);
  const values = stride === element ? typed(Type, bin, start, items * accessor.count) : new Type(items * accessor.count);
  if (stride !== element) {
    const all = typed(Type, bin, start, Math.floor(needed - (accessor.byteOffset ?? 0)) / Type.BYTES_PER_ELEMENT);
    const step = stride / Type.BYTES_PER_ELEMENT;
    for (let k = 0; k < accessor.count; k++) for (let c = 0; c < items; c++) values[items * k + c] = all[step * k + c];
  }
  return Object.assign(values, { items });
}

function checkCounts({ positions, normals, uvs, indices }, where) {
  const count = positions.length / 3;
  if (normals.length !== positions.length || (uvs && uvs.length !== 2 * count) || !count) {
    fail("GEOMETRY_ARRAY", where, "attributes of different counts");
  }
  if (indices.length % 3 || !indices.length) fail("GEOMETRY_ARRAY", where, "part of a triangle");
}

function checkBounds(accessor, positions, quantised, where) {
  const right = ["min", "max"].every((side) => {
    if (accessor[side]?.length !== 3) return false;
    for (let axis = 0; axis < 3; axis++) {
      let extreme = positions[axis];
      for (let k = axis; k < positions.length; k += 3) {
        if (side === "min" ? positions[k] < extreme : positions[k] > extreme) extreme = positions[k];
      }
      const stated = quantised ? accessor[side][axis] : Math.fround(accessor[side][axis]);
      if (stated !== extreme && Number.isFinite(extreme)) return false;
    }
    return true;
  });
  if (!right) fail("GEOMETRY_BOUNDS", where, "min and max of POSITION are not those of its values");
}

/** A quantised mesh in metres, in float64, rounded once. */
function restored({ positions, normals, uvs }, { translation, scale }) {
  return {
    positions: Float32Array.from(positions, (q, k) => translation[k % 3] + scale[0] * q),
    normals: Float32Array.from(normals, (q) => Math.max(q / 32767, -1)),
    uvs: uvs && (uvs instanceof Uint16Array ? Float32Array.from(uvs, (q) => q / 65535) : uvs),
  };
}

/** Fails for what is not finite, indices without a vertex, normals that are no directions. */
export function checkValues({ positions, normals, uvs, indices }, where) {
  for (const values of [positions, normals, uvs ?? []]) {
    for (let k = 0; k < values.length; k++) {
      if (!Number.isFinite(values[k])) fail("GEOMETRY_NOT_FINITE", where, "an attribute is not finite");
    }
  }
  const count = positions.length / 3;
  for (let k = 0; k < indices.length; k++) {
    if (indices[k] >= count) fail("GEOMETRY_INDEX", where, `vertex ${indices[k]} of ${count}`);
  }
  for (let k = 0; k < normals.length; k += 3) {
    const length = Math.hypot(normals[k], normals[k + 1], normals[k + 2]);
    if (Math.abs(length - 1) > 1e-3) fail("GEOMETRY_NORMAL", where, `a normal of length ${length}`);
  }
}
