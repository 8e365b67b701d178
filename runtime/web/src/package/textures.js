// Textures of transmittance and normal maps (spec, 4.4 and 4.5); where records of them and of base colour are.
import { fail } from "./errors.js";
import { isMetadata, isTensor, readHeader, takeTensors } from "./tensors.js";

const WIDEST = 8192;

/** { values, height, width, channels } of the one tensor `name`, U8 with one of `channels`. */
function readTexture(bytes, name, channels, where, code) {
  const header = readHeader(bytes, where, code);
  const tensor = header.tensors[name];
  if (!isMetadata(header.metadata)) fail(code, where, "__metadata__ is no object");
  if (Object.keys(header.tensors).join() !== name || !isTensor(tensor)) fail(code, where, `not one tensor ${name}`);
  const [height, width, depth] = tensor.shape;
  const fits = tensor.shape.length === 3 && [height, width].every((side) => side >= 1 && side <= WIDEST);
  if (tensor.dtype !== "U8" || !fits || !channels.includes(depth)) {
    fail(code, where, `found ${tensor.dtype} [${tensor.shape}], expected U8 [H, W, ${channels.join(" or ")}]`);
  }
  if (header.data % 64) fail(code, where, "data does not start at a multiple of 64");
  const [values] = takeTensors(bytes, header, [name], where, code);
  return { values, height, width, channels: depth };
}

export function readTransmittance(bytes, record, where) {
  const code = "TRANSMITTANCE_TEXTURE";
  const texture = readTexture(bytes, "transmittance", [1, 3], where, code);
  if (record.cutoff !== undefined && texture.channels !== 1) fail(code, where, "a cutoff of a coloured texture");
  return texture;
}

export function readNormalMap(bytes, where) {
  return readTexture(bytes, "normals", [2], where, "NORMAL_MAP_TEXTURE");
}

/** Fails where a record names triangles, or coordinates, that the mesh has not. texture: null where it needs none. */
export function checkRecord({ triangles: [first, count] }, texture, mesh, where, kind) {
  if (first + count > mesh.indices.length / 3) {
    fail(`${kind}_RANGE`, where, `triangles ${first} to ${first + count} of ${mesh.indices.length / 3}`);
  }
  const needs = texture && (kind !== "TRANSMITTANCE" || texture.width * texture.height > 1);
  if (needs && !mesh.uvs) fail(`${kind}_UV`, where, "the mesh has no texture coordinates");
}
