// Which JSON a mesh may have (spec, 4.1): the tables of members, as schemas.
import { fail } from "./errors.js";
import { checkSchema } from "./schema.js";

const string = { type: "string" }, numbers = { type: "array", items: { type: "number" } };
const integer = (minimum) => ({ type: "integer", minimum, maximum: 2 ** 32 - 1 });
const one = (items) => ({ type: "array", minItems: 1, maxItems: 1, items });
const record = (required, optional = {}) => ({
  type: "object", properties: { ...required, ...optional }, required: Object.keys(required), additionalProperties: false,
});
const three = { type: "array", minItems: 3, maxItems: 3, items: { type: "number" } };
const KHR = { const: "KHR_mesh_quantization" };

function documentOf(quantised) {
  const types = quantised ? [5122, 5123, 5125, 5126] : [5125, 5126];
  const accessor = record(
    { bufferView: integer(0), componentType: { enum: types }, count: integer(1), type: { enum: ["SCALAR", "VEC2", "VEC3"] } },
    { byteOffset: integer(0), normalized: quantised ? { type: "boolean" } : { const: false }, min: numbers, max: numbers, name: string },
  );
  const view = record(
    { buffer: { const: 0 }, byteLength: integer(1) },
    { byteOffset: integer(0), target: { enum: [34962, 34963] }, name: string, ...(quantised && { byteStride: { enum: [4, 8] } }) },
  );
  const attributes = record({ POSITION: integer(0), NORMAL: integer(0) }, { TEXCOORD_0: integer(0) });
  const primitive = record({ attributes, indices: integer(0) }, { mode: { const: 4 } });
  return record(
    {
      asset: record({ version: { const: "2.0" } }, { generator: string, copyright: string }),
      scenes: one(record({ nodes: one({ const: 0 }) }, { name: string })),
      nodes: one(record({ mesh: { const: 0 }, ...(quantised && { translation: three, scale: three }) }, { name: string })),
      meshes: one(record({ primitives: one(primitive) }, { name: string })),
      buffers: one(record({ byteLength: integer(1) }, { name: string })),
      accessors: { type: "array", minItems: 3, maxItems: 4, items: accessor },
      bufferViews: { type: "array", minItems: 1, maxItems: 4, items: view },
      ...(quantised && { extensionsUsed: one(KHR), extensionsRequired: one(KHR) }),
    },
    { scene: { const: 0 }, extras: {} },
  );
}

const PLAIN = documentOf(false), QUANTISED = documentOf(true);

/** Fails where the document is outside the profile; whether it is a quantised one. */
export function checkProfile(json, where) {
  const quantised = "extensionsUsed" in json || "extensionsRequired" in json;
  try {
    checkSchema(quantised ? QUANTISED : PLAIN, json);
  } catch (error) {
    fail("GEOMETRY_PROFILE", where, `${error.where}: not as meshes of packages are`);
  }
  if (quantised) checkScale(json.nodes[0], where);
  checkAccessors(json, quantised, where);
  return quantised;
}

function checkScale({ scale: [x, y, z] }, where) {
  if (!(x > 0 && x === y && x === z)) fail("GEOMETRY_PROFILE", where, `the scale ${[x, y, z]}`);
}

function checkAccessors(json, quantised, where) {
  const { attributes, indices } = json.meshes[0].primitives[0];
  const expected = quantised
    ? {
      POSITION: [["VEC3"], [[5123, false, 8]]], NORMAL: [["VEC3"], [[5122, true, 8]]],
      TEXCOORD_0: [["VEC2"], [[5126, false, undefined], [5123, true, 4]]],
      indices: [["SCALAR"], [[5123, false, undefined], [5125, false, undefined]]],
    }
    : {
      POSITION: [["VEC3"], [[5126, false]]], NORMAL: [["VEC3"], [[5126, false]]],
      TEXCOORD_0: [["VEC2"], [[5126, false]]], indices: [["SCALAR"], [[5125, false]]],
    };
  for (const [name, index] of [...Object.entries(attributes), ["indices", indices]]) {
    const accessor = json.accessors[index];
    const view = accessor && json.bufferViews[accessor.bufferView];
    if (!view) continue;  // a fault of ranges
    const [types, forms] = expected[name];
    const right = types.includes(accessor.type) && forms.some(([component, normalized, stride]) =>
      accessor.componentType === component && (accessor.normalized ?? false) === normalized && view.byteStride === stride);
    if (!right) fail("GEOMETRY_PROFILE", where, `the accessor of ${name}`);
  }
  const small = json.accessors[indices]?.componentType === 5123;
  if (small && json.accessors[attributes.POSITION]?.count >= 65535) {
    fail("GEOMETRY_PROFILE", where, "indices of 16 bits for too many vertices");
  }
}
