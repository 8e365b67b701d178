// Surfaces and their textures, as rna_gpu's table has them.
import { constants, packed } from "../decoder/records.js";

const { NONE, OF_NEURAL, OF_FIBERS, LETS_THROUGH, HAS_CUTOFF } = constants;

export class SurfaceTable {
  constructor() {
    Object.assign(this, { surfaces: [], textures: [], images: [], imagesLength: 0 });
  }

  ofFibers(part) {
    return this._add({ kind: OF_FIBERS, part });
  }

  /** The surface of each triangle of a mesh: those of one normal map and one pane share it. */
  ofTriangles({ mesh, transmittance, normalMaps }, part) {
    const count = mesh.indices.length / 3, panes = recordOf(transmittance, count), maps = recordOf(normalMaps, count);
    const known = new Map(), result = new Uint32Array(count);
    for (let k = 0; k < count; k++) {
      const key = `${maps[k]} ${panes[k]}`;
      if (!known.has(key)) known.set(key, this._ofRecords(part, normalMaps[maps[k]], transmittance[panes[k]]));
      result[k] = known.get(key);
    }
    return result;
  }

  /** { table, images, texturesAt, hasTextures, transmits }: rows of surfaces, then of textures; texels, a word each. */
  arrays() {
    const words = this.surfaces.map((surface) => packed("Surface", surface));
    const table = Uint32Array.from([...words, ...this.textures].flatMap((row) => [...row]));
    const images = new Uint32Array(this.imagesLength);
    let at = 0;
    for (const piece of this.images) {
      images.set(piece, at);
      at += piece.length;
    }
    return {
      table, images, texturesAt: words.reduce((sum, row) => sum + row.length / 4, 0), hasTextures: this.textures.length > 0,
      transmits: this.surfaces.some(({ flags }) => flags & LETS_THROUGH),
    };
  }

  _add(surface) {
    return this.surfaces.push({ normal_map: NONE, ...surface }) - 1;
  }

  _ofRecords(part, map, pane) {
    const surface = { kind: OF_NEURAL, part };
    if (map) surface.normal_map = this._texture(map.texture);
    if (pane) {
      surface.flags = LETS_THROUGH | (pane.cutoff == null ? 0 : HAS_CUTOFF);
      Object.assign(surface, { through: this._texture(pane.texture), cutoff: pane.cutoff ?? 0, ior: pane.ior ?? [0, 0] });
    }
    return this._add(surface);
  }

  /** Number of a texture; a texel is a word of three bytes, one channel stands for grey. */
  _texture({ values, width, height, channels }) {
    const texels = new Uint32Array(width * height), place = this.imagesLength;
    for (let k = 0; k < texels.length; k++) {
      const [r, g = r, b = channels === 1 ? r : 0] = values.subarray(channels * k, channels * (k + 1));
      texels[k] = r | (g << 8) | (b << 16);
    }
    this.images.push(texels);
    this.imagesLength += texels.length;
    return this.textures.push(packed("Texture", { place, size: (height << 16) | width, row_u: [1, 0, 0], row_v: [0, 1, 0] })) - 1;
  }
}

/** Of each triangle the number of its record, -1 for none. */
function recordOf(records, count) {
  const result = new Int32Array(count).fill(-1);
  records.forEach(({ triangles: [first, own] }, k) => result.fill(k, first, first + own));
  return result;
}
