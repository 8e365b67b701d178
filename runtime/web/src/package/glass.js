// The smooth glass beside a package: binary glTF of the form that rna-capture writes.
import { NotSupported } from "./errors.js";
import { checkValues, readAccessor, readChunks } from "./mesh.js";
import { otherFile } from "./other_files.js";

const MOST_ROUGHNESS = 0.1;
const UNSIGNED = [5123, 5125];

/**
 * { mesh, materials, materialOf }: of all triangles together the mesh, and the number of each one's material: ior, what is
 * left of light at an interface (tint) and absorption inside, 1/m. name: for lines of errors.
 */
export function readGlass(bytes, name) {
  const other = otherFile(bytes);
  if (other) throw new NotSupported(`${name}: expected a .glb, found ${other}`);
  const { json, bin } = readChunks(bytes, name), read = (index) => readAccessor(json, bin, index, name);
  const refuse = (form) => { throw new NotSupported(`${name}: expected ${form}, as rna-capture writes it`); };
  const nodes = (json.nodes ?? []).filter(({ mesh }) => mesh !== undefined);
  if (nodes.some((node) => ["matrix", "translation", "rotation", "scale", "skin"].some((key) => key in node))) refuse("a mesh that stands where the asset does, without a transform");
  const pieces = nodes.flatMap(({ mesh }) => json.meshes[mesh].primitives).map(({ attributes, indices, material, mode = 4 }) => {
    const forms = [[attributes.POSITION, "VEC3", [5126]], [attributes.NORMAL, "VEC3", [5126]], [indices, "SCALAR", UNSIGNED]];
    const isRight = forms.every(([index, type, components]) => {
      const accessor = json.accessors?.[index];
      return accessor && accessor.type === type && components.includes(accessor.componentType);
    });
    if (mode !== 4 || !isRight) refuse("triangles with positions, normals and indices");
    return { positions: read(attributes.POSITION), normals: read(attributes.NORMAL), indices: read(indices), material };
  });
  if (!pieces.length) refuse("a mesh");
  const materials = pieces.map(({ material }) => materialOf(json.materials?.[material]) ?? refuse("smooth glass, of KHR_materials_transmission 1 and KHR_materials_volume"));
  return { ...together(pieces, name), materials };
}

/** null for what is no smooth solid glass. */
function materialOf({ pbrMetallicRoughness: { baseColorFactor = [1, 1, 1], metallicFactor = 1, roughnessFactor = 1, ...textures } = {}, extensions = {} } = {}) {
  const { KHR_materials_transmission: passes, KHR_materials_volume: volume, KHR_materials_ior: { ior = 1.5 } = {} } = extensions;
  const isSolid = passes?.transmissionFactor === 1 && volume?.thicknessFactor > 0 && metallicFactor === 0 && roughnessFactor <= MOST_ROUGHNESS;
  if (!isSolid || !(ior >= 1) || [textures, passes, volume].some((record) => Object.keys(record).some((key) => key.endsWith("Texture")))) return null;
  const { attenuationColor = [1, 1, 1], attenuationDistance = Infinity } = volume;
  const absorption = attenuationColor.map((left) => -Math.log(Math.max(left, 1e-6)) / attenuationDistance);
  return { ior, tint: baseColorFactor.slice(0, 3), absorption };
}

/** One mesh of all pieces, and of each triangle the number of its piece. */
function together(pieces, name) {
  const count = pieces.reduce((sum, { positions }) => sum + positions.length, 0), triangles = pieces.flatMap(({ indices }, k) => Array(indices.length / 3).fill(k));
  const mesh = { positions: new Float32Array(count), normals: new Float32Array(count), uvs: null, indices: new Uint32Array(3 * triangles.length) };
  let point = 0, index = 0;
  for (const { positions, normals, indices } of pieces) {
    checkValues({ positions, normals, uvs: null, indices }, name);
    mesh.positions.set(positions, point);
    mesh.normals.set(normals, point);
    mesh.indices.set(indices.map((k) => k + point / 3), index);
    point += positions.length;
    index += indices.length;
  }
  return { mesh, materialOf: triangles };
}
