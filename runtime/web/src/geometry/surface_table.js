// Surfaces and their textures, as rna_gpu/wgsl/render/surfaces.wgsl and textures.wgsl have them.

export const SURFACE_ROWS = 9;  // of four words
const TEXTURE_ROWS = 3, NONE = 0xffffffff;
const NEURAL = 1, FIBERS = 2;                         // kinds
const LETS_THROUGH = 2, HAS_CUTOFF = 8;               // flags
const KIND = 0, PART = 1, FLAGS = 2, MAP = 3, THROUGH = 28, CUTOFF = 29, IOR = 30;  // words of a surface

export class SurfaceTable {
  constructor() {
    Object.assign(this, { surfaces: [], textures: [], images: [], imagesLength: 0 });
  }

  ofFibers(part) {
    return this._add(FIBERS, part).number;
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

  /** { table, images, surfaceCount, hasTextures, transmits }: rows of surfaces, then of textures; texels, a word each. */
  arrays() {
    const table = Uint32Array.from([...this.surfaces, ...this.textures].flatMap((row) => [...row]));
    const images = new Uint32Array(this.imagesLength);
    let at = 0;
    for (const piece of this.images) {
      images.set(piece, at);
      at += piece.length;
    }
    return {
      table, images, surfaceCount: this.surfaces.length, hasTextures: this.textures.length > 0,
      transmits: this.surfaces.some((row) => row[FLAGS] & LETS_THROUGH),
    };
  }

  _add(kind, part) {
    const words = new Uint32Array(4 * SURFACE_ROWS);
    words[KIND] = kind;
    words[PART] = part;
    words[MAP] = NONE;
    return { words, number: this.surfaces.push(words) - 1 };
  }

  _ofRecords(part, map, pane) {
    const { words, number } = this._add(NEURAL, part), floats = new Float32Array(words.buffer);
    if (map) words[MAP] = this._texture(map.texture);
    if (pane) {
      words[FLAGS] = LETS_THROUGH | (pane.cutoff == null ? 0 : HAS_CUTOFF);
      words[THROUGH] = this._texture(pane.texture);
      floats[CUTOFF] = pane.cutoff ?? 0;
      floats.set(pane.ior ?? [0, 0], IOR);
    }
    return number;
  }

  /** Number of a texture; a texel is a word of three bytes, one channel stands for grey. */
  _texture({ values, width, height, channels }) {
    const words = new Uint32Array(4 * TEXTURE_ROWS), floats = new Float32Array(words.buffer), texels = new Uint32Array(width * height);
    for (let k = 0; k < texels.length; k++) {
      const [r, g = r, b = channels === 1 ? r : 0] = values.subarray(channels * k, channels * (k + 1));
      texels[k] = r | (g << 8) | (b << 16);
    }
    words.set([this.imagesLength, (height << 16) | width]);
    floats[4] = floats[9] = 1;  // its transform
    this.images.push(texels);
    this.imagesLength += texels.length;
    return this.textures.push(words) - 1;
  }
}

/** Of each triangle the number of its record, -1 for none. */
function recordOf(records, count) {
  const result = new Int32Array(count).fill(-1);
  records.forEach(({ triangles: [first, own] }, k) => result.fill(k, first, first + own));
  return result;
}
