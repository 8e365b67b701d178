// Surfaces and their textures, as rna_gpu's table has them.
import { constants, packed, records } from "../decoder/records.js";
import { levelsOf } from "../package/images.js";
import { finished } from "../steps.js";

const { NONE, OF_MATERIAL, OF_NEURAL, OF_FIBERS, IS_SOLID, LETS_THROUGH, HAS_CUTOFF, BASE } = constants;
const WRAPS = ["repeat", "clamp", "mirror"], MIXES_SRGB = 256;  // of the form of textures
const TEXTURES = records.Surface.members.textures.count;
const NOTHING = new Uint32Array(0), WHITE = [1, 1, 1], AS_IS = [1, 0, 0, 0, 1, 0];

export class SurfaceTable {
  #made = new Map();  // by image and colour space: its piece

  /** tint: linear RGB, a factor of all base colours. given: members of another one, as a worker hands them over. */
  constructor(given) {
    Object.assign(this, { surfaces: [], textures: [], pieces: [], tint: WHITE }, given);
  }

  ofFibers({ sampling }, part) {
    return this._add({ kind: OF_FIBERS, part, ...sampling[0].lobes });
  }

  /** materials: of readGlass. */
  ofGlass(materials) {
    return materials.map(({ ior, tint, absorption }) => this._add({ kind: OF_MATERIAL, flags: IS_SOLID, base_color: tint, ior: [ior, 0], absorption }));
  }

  /** In steps, the surface of each triangle of a mesh: those of the same records share it. */
  *ofTriangles({ mesh, normalMaps, transmittance, baseColor, sampling }, part) {
    const count = mesh.indices.length / 3, lists = [normalMaps, transmittance, baseColor, untilNext(sampling, count)];
    const numbers = lists.map((list) => recordOf(list, count)), known = new Map(), result = new Uint32Array(count);
    for (let k = 0; k < count; k++) {
      const row = numbers.map((list) => list[k]), key = row.join();
      if (!known.has(key)) {
        known.set(key, yield* this._ofRecords(part, ...lists.map((list, j) => list[row[j]])));
        this.surfaces[known.get(key)].record = row[2];
      }
      result[k] = known.get(key);
    }
    return result;
  }

  /** In steps, other records of base colour in the place of those of each part. */
  *reprint(prints) {
    for (const surface of this.surfaces) {
      const color = surface.factor && prints[surface.part][surface.record];
      if (!color) continue;
      surface.factor = color.factor ?? WHITE;
      surface.textures[BASE] = color.image ? yield* this._print(color) : NONE;
    }
    const used = new Set(this.surfaces.map(({ textures }) => textures[BASE]));
    this.textures.forEach((texture, k) => {
      if (texture.label !== undefined && !used.has(k)) delete texture.label;
    });
  }

  /** { table, images, texturesAt, hasBaseColor, transmits }: rows of surfaces, then of textures; texels, a word each. */
  arrays() {
    const { surfaces, textures, pieces, tint } = this, starts = [0];
    for (const piece of pieces) starts.push(starts.at(-1) + piece.length);
    const rows = [
      ...surfaces.map(({ factor, record, ...surface }) => packed("Surface", { ...surface, ...(factor && { base_color: factor.map((value, c) => value * tint[c]) }) })),
      ...textures.map(({ piece, width, height, form, row_u, row_v }) =>
        packed("Texture", { place: starts[piece], size: (height << 16) | width, form, row_u, row_v })),
    ];
    const table = Uint32Array.from(rows.flatMap((row) => [...row])), images = new Uint32Array(starts.at(-1));
    pieces.forEach((piece, k) => images.set(piece, starts[k]));
    return {
      table, images, texturesAt: (surfaces.length * records.Surface.words) / 4, hasBaseColor: surfaces.some(({ factor }) => factor),
      transmits: surfaces.some(({ flags }) => flags & LETS_THROUGH),
    };
  }

  /** The names of the images of base colour. */
  get labels() {
    return [...new Set(this.textures.map(({ label }) => label).filter((label) => label !== undefined))];
  }

  /** Another picture, { pixels, width, height }, in place of the images with that label; null: the package's own. */
  async setImage(label, picture) {
    for (const texture of this.textures.filter((one) => one.label === label)) {
      const { piece, width, height } = texture, levels = picture && (await finished(levelsOf(picture, texture.colorSpace)));
      texture.first ??= { piece, width, height };
      // A piece of its own, in the place of the last one that was given.
      texture.given ??= this.pieces.push(NOTHING) - 1;
      this.pieces[texture.given] = levels ?? NOTHING;
      Object.assign(texture, levels ? { piece: texture.given, width: picture.width, height: picture.height } : texture.first);
    }
  }

  _add(surface) {
    return this.surfaces.push({ normal_map: NONE, base_color: WHITE, textures: Array(TEXTURES).fill(NONE), ...surface }) - 1;
  }

  *_ofRecords(part, map, pane, color, { lobes }) {
    const number = this._add({ kind: OF_NEURAL, part, ...lobes }), surface = this.surfaces[number];
    if (map) surface.normal_map = this._texture(map.texture);
    if (pane) {
      surface.flags = LETS_THROUGH | (pane.cutoff == null ? 0 : HAS_CUTOFF);
      Object.assign(surface, { through: this._texture(pane.texture), cutoff: pane.cutoff ?? 0, ior: pane.ior ?? [0, 0] });
    }
    if (color) surface.factor = color.factor ?? WHITE;
    if (color?.image) surface.textures[BASE] = yield* this._print(color);
    return number;
  }

  /** Number of a texture; a texel is a word of three bytes, one channel stands for grey. */
  _texture({ values, width, height, channels }) {
    const texels = new Uint32Array(width * height);
    for (let k = 0; k < texels.length; k++) {
      const [r, g = r, b = channels === 1 ? r : 0] = values.subarray(channels * k, channels * (k + 1));
      texels[k] = r | (g << 8) | (b << 16);
    }
    const piece = this.pieces.push(texels) - 1;
    return this.textures.push({ piece, width, height, form: 0, row_u: [1, 0, 0], row_v: [0, 1, 0] }) - 1;
  }

  /** Number of the texture of a record of base colour, with all levels. */
  *_print({ image, label, colorSpace = "srgb", wrap = ["repeat", "repeat"], transform = AS_IS }) {
    const made = this.#made.get(image) ?? {}, [u, v] = wrap.map((name) => WRAPS.indexOf(name));
    made[colorSpace] ??= this.pieces.push(yield* levelsOf(image, colorSpace)) - 1;
    this.#made.set(image, made);
    return this.textures.push({
      piece: made[colorSpace], width: image.width, height: image.height, form: u | (v << 2) | (colorSpace === "srgb" ? MIXES_SRGB : 0),
      row_u: transform.slice(0, 3), row_v: transform.slice(3), label, colorSpace,
    }) - 1;
  }
}

/** Mixtures with the triangles that have them, up to the first ones of the next. */
function untilNext(sampling, count) {
  return sampling.map(({ first, lobes }, k) => ({ triangles: [first, (sampling[k + 1]?.first ?? count) - first], lobes }));
}

/** Of each triangle the number of its record, -1 for none. */
function recordOf(records, count) {
  const result = new Int32Array(count).fill(-1);
  records.forEach(({ triangles: [first, count] }, k) => result.fill(k, first, first + count));
  return result;
}
