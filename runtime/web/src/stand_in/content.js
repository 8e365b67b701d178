// What a stand-in is drawn of: meshes, and for ranges of their triangles the material of glTF that a package has for them.
import { readMesh } from "../package/mesh.js";
import { readNormalMap, readTransmittance } from "../package/textures.js";

/**
 * Of each part { mesh, roughness, metallic, metallicRoughness, ranges }, the last but one an ImageBitmap or null. ranges:
 * { triangles, factor, image, colorSpace, transform, wrap } of base colour, image being an ImageBitmap or as readImage gives it,
 * `normals`, an ImageBitmap, readNormalMap's, or none, and `holes`, readTransmittance's with a cutoff, or none. Null for a package
 * in which a part has no colours by place (RNA_standin_textures or base colour), or emits.
 */
export async function readStandIn(opened) {
  const { parts, extensions = {} } = opened.manifest, textures = extensions.RNA_standin_textures?.parts ?? [];
  if (!parts.every((part, k) => isColoured(part, textures[k]) && !opened.tier().parts[k].emission)) return null;
  const mapsOf = ({ normalMaps = [], transmittance = [] }) => [...normalMaps, ...transmittance].map(({ texture }) => texture);
  const data = await opened.read(parts.flatMap((part, k) => [part.geometry, ...mapsOf(part), ...Object.values(textures[k] ?? {})]));
  const meshes = parts.map(({ geometry }) => ({ mesh: readMesh(data.get(geometry), geometry) }));
  const prints = await opened.prints(meshes), constants = extensions.RNA_standin?.parts ?? [];
  return Promise.all(meshes.map(async ({ mesh }, k) => {
    const images = await decoded(textures[k], data), { baseColor = [0.5, 0.5, 0.5], roughness = 1, metallic = 0 } = constants[k] ?? {};
    const others = images ? { factor: [1, 1, 1], image: images.baseColor } : { factor: baseColor };
    const maps = (parts[k].normalMaps ?? []).map(({ triangles, texture }) => ({ triangles, normals: readNormalMap(data.get(texture), texture) }));
    const holes = (parts[k].transmittance ?? []).map((record) =>
      ({ triangles: record.triangles, holes: { cutoff: 0.5, ...record, ...readTransmittance(data.get(record.texture), record, record.texture) } }));
    const records = prints[k].map((record) => ({ factor: [1, 1, 1], ...record }));
    const ranges = rangesOf(mesh.indices.length / 3, [{ ...others, normals: images?.normal }, ...records, ...maps, ...holes]);
    return { mesh, roughness, metallic, metallicRoughness: images?.metallicRoughness ?? null, ranges };
  }));
}

const isColoured = ({ kind, baseColor }, textures) => kind === "surface" && !!(baseColor || textures);

/** Images by member, or null. */
async function decoded(names, data) {
  if (!names) return null;
  const decode = async ([member, name]) =>
    [member, await createImageBitmap(new Blob([data.get(name)]), { colorSpaceConversion: "none", premultiplyAlpha: "none" })];
  return Object.fromEntries(await Promise.all(Object.entries(names).map(decode)));
}

/** Of so many triangles those between which no record begins or ends, with what records have of them: later ones go before. */
function rangesOf(count, records) {
  const borders = records.flatMap(({ triangles: [first, size] = [0, count] }) => [first, first + size]);
  const edges = [...new Set(borders)].sort((a, b) => a - b);
  return edges.slice(1).map((end, k) => {
    const first = edges[k], holds = ({ triangles: [from, size] = [0, count] }) => from <= first && first < from + size;
    return { ...Object.assign({}, ...records.filter(holds)), triangles: [first, end - first] };
  });
}

/** { min, max } of all parts' positions. */
export function boxOf(content) {
  const min = [Infinity, Infinity, Infinity], max = [-Infinity, -Infinity, -Infinity];
  for (const { mesh: { positions } } of content) {
    for (let k = 0; k < positions.length; k++) {
      min[k % 3] = Math.min(min[k % 3], positions[k]);
      max[k % 3] = Math.max(max[k % 3], positions[k]);
    }
  }
  return { min, max };
}
