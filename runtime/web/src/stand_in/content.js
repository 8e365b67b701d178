// What a stand-in is drawn of: meshes, and for ranges of their triangles the material of glTF that a package has for them.
import { readMesh } from "../package/mesh.js";

/**
 * Of each part { mesh, roughness, metallic, relief, ranges }. relief: { metallicRoughness, normal }, ImageBitmaps, or null.
 * ranges: { triangles, factor, image, colorSpace, transform, wrap } of base colour, image being an ImageBitmap or as readImage
 * gives it. Null for a package in which a part has no colours by place (RNA_standin_textures or base colour), is not opaque,
 * has relief of its own, or emits.
 */
export async function readStandIn(opened) {
  const { parts, extensions = {} } = opened.manifest, textures = extensions.RNA_standin_textures?.parts ?? [];
  if (!parts.every((part, k) => isColoured(part, textures[k]) && !opened.tier().parts[k].emission)) return null;
  const data = await opened.read(parts.flatMap(({ geometry }, k) => [geometry, ...Object.values(textures[k] ?? {})]));
  const meshes = parts.map(({ geometry }) => ({ mesh: readMesh(data.get(geometry), geometry) }));
  const prints = await opened.prints(meshes), constants = extensions.RNA_standin?.parts ?? [];
  return Promise.all(meshes.map(async ({ mesh }, k) => {
    const images = await decoded(textures[k], data), { baseColor = [0.5, 0.5, 0.5], roughness = 1, metallic = 0 } = constants[k] ?? {};
    const others = images ? { factor: [1, 1, 1], image: images.baseColor } : { factor: baseColor };
    return { mesh, roughness, metallic, relief: images, ranges: rangesOf(prints[k], mesh.indices.length / 3, others) };
  }));
}

const isColoured = ({ kind, transmittance, normalMaps, baseColor }, textures) =>
  kind === "surface" && !transmittance && !normalMaps && !!(baseColor || textures);

/** Images by member, or null. */
async function decoded(names, data) {
  if (!names) return null;
  const decode = async ([member, name]) =>
    [member, await createImageBitmap(new Blob([data.get(name)]), { colorSpaceConversion: "none", premultiplyAlpha: "none" })];
  return Object.fromEntries(await Promise.all(Object.entries(names).map(decode)));
}

/** The records, and what lies between them. others: colours of triangles of no record. */
function rangesOf(records, count, others) {
  const ranges = [], add = (first, end, looks) => first < end && ranges.push({ ...looks, triangles: [first, end - first] });
  let at = 0;
  for (const record of [...records].sort((a, b) => a.triangles[0] - b.triangles[0])) {
    const [first, size] = record.triangles;
    add(at, first, others);
    add(first, first + size, record);
    at = first + size;
  }
  add(at, count, others);
  return ranges;
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
