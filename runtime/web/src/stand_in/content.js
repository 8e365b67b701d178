// What a stand-in is drawn of: meshes, and for ranges of their triangles the material of glTF that a package has for them.
import { readCurves } from "../package/curves.js";
import { readMesh } from "../package/mesh.js";
import { readNormalMap, readTransmittance } from "../package/textures.js";

/**
 * { parts, box, isPlain }. Of each part { mesh, isStrands, roughness, metallic, metallicRoughness, ranges }, the last but one an
 * ImageBitmap or null. ranges: { triangles, factor, image, colorSpace, transform, wrap } of base colour, image being an ImageBitmap
 * or as readImage gives it, `normals`, an ImageBitmap, readNormalMap's, or none, and `holes`, readTransmittance's with a cutoff, or
 * none. isPlain: some part emits, or has no colours by place (RNA_standin_textures or base colour) and has the constants of
 * RNA_standin. Null without these, and for a plain one unless `takesPlain`.
 */
export async function readStandIn(opened, takesPlain) {
  const { parts, extensions = {} } = opened.manifest, textures = extensions.RNA_standin_textures?.parts ?? [], constants = extensions.RNA_standin?.parts;
  const isPlain = !parts.every((part, k) => isColoured(part, textures[k]) && !opened.tier().parts[k].emission);
  if (isPlain && !(takesPlain && constants)) return null;
  const mapsOf = ({ normalMaps = [], transmittance = [] }) => [...normalMaps, ...transmittance].map(({ texture }) => texture);
  const data = await opened.read(parts.flatMap((part, k) => [part.geometry, ...mapsOf(part), ...Object.values(textures[k] ?? {})]));
  const geometries = parts.map(({ kind, geometry }) => (kind === "fiber" ? ribbons(readCurves(data.get(geometry), geometry)) : { mesh: readMesh(data.get(geometry), geometry) }));
  const prints = await opened.prints(geometries);
  const shown = await Promise.all(geometries.map(async (geometry, k) => {
    const images = await decoded(textures[k], data), { baseColor = [0.5, 0.5, 0.5], roughness = 1, metallic = 0 } = constants?.[k] ?? {};
    const others = images ? { factor: [1, 1, 1], image: images.baseColor } : { factor: baseColor };
    const maps = (parts[k].normalMaps ?? []).map(({ triangles, texture }) => ({ triangles, normals: readNormalMap(data.get(texture), texture) }));
    const holes = (parts[k].transmittance ?? []).map((record) =>
      ({ triangles: record.triangles, holes: { cutoff: 0.5, ...record, ...readTransmittance(data.get(record.texture), record, record.texture) } }));
    const records = prints[k].map((record) => ({ factor: [1, 1, 1], ...record }));
    const ranges = rangesOf(geometry.mesh.indices.length / 3, [{ ...others, normals: images?.normal }, ...records, ...maps, ...holes]);
    return { ...geometry, roughness, metallic, metallicRoughness: images?.metallicRoughness ?? null, ranges };
  }));
  return { parts: shown, box: boxOf(geometries), isPlain };
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

/** Two triangles a segment, which the shader turns to the eye: normals are tangents here, and u is how far a point is beside the middle. */
function ribbons({ points, radii, offsets }) {
  const count = radii.length, positions = new Float32Array(6 * count), normals = new Float32Array(6 * count), uvs = new Float32Array(4 * count), indices = [];
  for (let strand = 0; strand + 1 < offsets.length; strand++) {
    const first = offsets[strand], last = offsets[strand + 1] - 1;
    for (let k = first; k <= last; k++) {
      const before = 3 * Math.max(first, k - 1), after = 3 * Math.min(last, k + 1);
      for (let side = 0; side < 2; side++) {
        for (let axis = 0; axis < 3; axis++) {
          positions[6 * k + 3 * side + axis] = points[3 * k + axis];
          normals[6 * k + 3 * side + axis] = points[after + axis] - points[before + axis];
        }
        uvs[4 * k + 2 * side] = side ? radii[k] : -radii[k];
      }
      if (k < last) indices.push(2 * k, 2 * k + 1, 2 * k + 2, 2 * k + 2, 2 * k + 1, 2 * k + 3);
    }
  }
  return { mesh: { positions, normals, uvs, indices: Uint32Array.from(indices) }, isStrands: true };
}

/** { min, max } of all parts' positions. */
function boxOf(content) {
  const min = [Infinity, Infinity, Infinity], max = [-Infinity, -Infinity, -Infinity];
  for (const { mesh: { positions } } of content) {
    for (let k = 0; k < positions.length; k++) {
      min[k % 3] = Math.min(min[k % 3], positions[k]);
      max[k % 3] = Math.max(max[k % 3], positions[k]);
    }
  }
  return { min, max };
}
