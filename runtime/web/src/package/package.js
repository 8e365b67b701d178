// A package: its manifest, and the parts of one tier, of which only the bytes needed are read.
import { widthOf } from "./blocks.js";
import { entryData, MANIFEST, readDirectory } from "./container.js";
import { readCurves } from "./curves.js";
import { readDecoder } from "./decoder.js";
import { decodeEntry } from "./deflate.js";
import { entriesOf, environmentOf, readHarmonics, VISIBILITY_COLUMNS } from "./environment_form.js";
import { fail } from "./errors.js";
import { variantsOf } from "./extensions.js";
import { packageIn } from "./gltf_package.js";
import { readImage } from "./images.js";
import { checkEntries, readManifest } from "./manifest.js";
import { readMesh } from "./mesh.js";
import { readPlanes } from "./planes.js";
import { samplingOf } from "./sampling.js";
import { checkRecord, readNormalMap, readTransmittance } from "./textures.js";

// A gap up to this is fetched with its neighbours: one request less.
const GAP = 65536;

export class Package {
  /** source: of a package, or of a binary glTF that has one. */
  static async open(source) {
    const opened = new Package();
    opened.source = await packageIn(source);
    opened.directory = await readDirectory(opened.source);
    opened.cache = new Map();
    opened.images = new Map();  // decoded
    opened.manifest = readManifest(await opened._stored(MANIFEST));
    checkEntries(opened.manifest, opened.directory);
    opened.environment = environmentOf(opened.manifest);
    return opened;
  }

  get poster() {
    return this.manifest.extensions?.RNA_poster;
  }

  tier(name) {
    const tier = name ? this.manifest.tiers.find((tier) => tier.name === name) : this.manifest.tiers[0];
    if (!tier) {
      const names = this.manifest.tiers.map((tier) => tier.name).join(", ");
      fail("TIER_UNKNOWN", this.source.name, `no tier ${name}; there are ${names}`);
    }
    return tier;
  }

  /** Bytes of the file that showing the tier takes. */
  bytesOf(name) {
    return this._ranges(this._needed(name, true)).reduce((sum, [start, end]) => sum + end - start, 0);
  }

  /** Begins to fetch all that the poster and the tier take. */
  prefetch(name, wantsLobes) {
    this._fetch([...(this.poster ? [this.poster.image] : []), ...this._needed(name, wantsLobes)]);
  }

  /** The parts of a tier, read and checked: geometry, planes, decoders, textures. wantsLobes: with those of the parts. */
  async load(name, { wantsLobes = false } = {}) {
    const tier = this.tier(name), names = this._entriesOf(tier), data = new Map();
    this._fetch(this._needed(name, wantsLobes));
    for (const entry of names) data.set(entry, await this._data(entry));
    await this._readImages(data);
    const parts = this.manifest.parts.map((part, k) => this._part(part, tier.parts[k], k, data));
    if (wantsLobes && this.environment) await this._addEnvironment(parts, tier, data);
    return { name: tier.name, tier, parts };
  }

  /** The bytes of entries, by name, which are fetched with the images of base colour. */
  async read(names) {
    this._fetch([...new Set([...names, ...this._images()])]);
    return new Map(await Promise.all(names.map(async (name) => [name, await this._data(name)])));
  }

  /** Names of the prints that `variant` may be. */
  get variants() {
    return variantsOf(this.manifest).map(({ name }) => name);
  }

  /** Base colour in the chosen variant of each of the parts, which were loaded. */
  async prints(parts) {
    const data = new Map();
    await this._readImages(data);
    return parts.map(({ mesh }, k) => this._print(k, data, mesh));
  }

  /** Adds what the parts have for whole environments. */
  async _addEnvironment(parts, tier, data) {
    const names = entriesOf(this.environment).filter((name) => !data.has(name));
    for (const name of names) data.set(name, await this._data(name));
    this.environment.forEach((form, k) => { parts[k].environment = this._environment(parts[k], form, tier.parts[k], data); });
  }

  /** { inputs, lobes, harmonics or null, planes, and the decoder }. The tier's planes are taken where they are the same. */
  _environment(part, form, ofTier, data) {
    const { inputs, lobes, visibility } = form, points = (part.mesh?.positions ?? part.curves.points).length / 3;
    const isTiers = ["planes", "resolution", "channels", "planePrecision"].every((name) => form[name] === ofTier[name]);
    const planes = isTiers ? part.planes : readPlanes(data.get(form.planes), form, form.planes);
    const harmonics = visibility ? readHarmonics(data.get(visibility), points, visibility) : null;
    const more = visibility ? VISIBILITY_COLUMNS : 0;
    return { inputs, lobes, harmonics, planes, ...decoderOf(data, form, form, "environment", 9 * lobes, more) };
  }

  /** The poster's PNG, or null. */
  async posterImage() {
    if (!this.poster) return null;
    this._fetch([this.poster.image]);
    return new Blob([await this._data(this.poster.image)], { type: "image/png" });
  }

  /** Lets go of bytes that were fetched for a tier. */
  forget() {
    this.cache.clear();
    this.images.clear();
  }

  _part(part, tierPart, k, data) {
    const { kind, bounds, geometry } = part, where = `/parts/${k}`;
    const bytes = data.get(geometry);
    const result = { name: part.name, kind, bounds: roundedBounds(bounds), inputs: tierPart.inputs, sampling: samplingOf(this.manifest, k), lengths: tierPart.nearby?.lengths };
    if (kind === "surface") result.mesh = readMesh(bytes, geometry);
    else result.curves = readCurves(bytes, geometry);
    result.transmittance = (part.transmittance ?? []).map((record) => {
      const texture = readTransmittance(data.get(record.texture), record, record.texture);
      checkRecord(record, texture, result.mesh, where, "TRANSMITTANCE");
      return { ...record, texture };
    });
    result.normalMaps = (part.normalMaps ?? []).map((record) => {
      const texture = readNormalMap(data.get(record.texture), record.texture);
      checkRecord(record, texture, result.mesh, where, "NORMAL_MAP");
      return { ...record, texture };
    });
    result.baseColor = this._print(k, data, result.mesh);
    result.planes = readPlanes(data.get(tierPart.planes), tierPart, tierPart.planes);
    result.decoders = this._decoders(tierPart, data);
    return result;
  }

  /**
   * By the name of their form: of transport, or of visible and of shadowed light; and of emission. With their colours, the column
   * where factors of base colour begin, and of nearby light the columns of a set and the means of each colour.
   */
  _decoders(tierPart, data) {
    const { nearby, usesBaseColor, shadowed, emission } = tierPart;
    const make = (record, form, names) => {
      const colours = names.length, columns = 3 * colours, all = columns * (usesBaseColor ? 2 : 1);
      const decoder = decoderOf(data, tierPart, record, form, nearby ? 4 * all : all), factors = usesBaseColor ? columns : 0;
      const counted = nearby && { nearbyColumns: all, means: names.flatMap((name) => [...nearby[name], 0]) };
      return { ...decoder, ...counted, inputs: record.inputs, colours, factors };
    };
    return {
      ...(shadowed
        ? { visible: make(tierPart, "visible", ["visible"]), shadowed: make(shadowed, "shadowed", ["shadowed"]) }
        : { transport: make(tierPart, "transport", ["visible", "shadowed"]) }),
      ...(emission && { emission: { ...decoderOf(data, tierPart, emission, "emission", 3), inputs: emission.inputs, colours: 1 } }),
    };
  }

  /** Base colour of a part, with its images. */
  _print(k, data, mesh) {
    const packagePrint = this.manifest.parts[k].baseColor ?? [];
    return this._records(k).map((record, j) => {
      const image = record.image === undefined ? null : data.get(record.image);
      checkRecord(record, image, mesh, `/parts/${k}`, "BASE_COLOR");
      return { ...record, image, label: image && stemOf(packagePrint[j].image ?? record.image) };
    });
  }

  /** Records of base colour of a part, in the chosen variant. */
  _records(k) {
    const chosen = variantsOf(this.manifest).find(({ name }) => name === this.variant)?.parts[k];
    return (this.manifest.parts[k].baseColor ?? []).map((record, j) => (chosen?.[j] ? { ...chosen[j], triangles: record.triangles } : record));
  }

  /** Entries of the images of base colour. */
  _images() {
    const all = this.manifest.parts.flatMap((_, k) => this._records(k).map(({ image }) => image));
    return new Set(all.filter((image) => image !== undefined));
  }

  async _readImages(data) {
    for (const entry of this._images()) {
      if (!this.images.has(entry)) this.images.set(entry, await readImage(data.get(entry) ?? (await this._data(entry)), entry));
      data.set(entry, this.images.get(entry));
    }
  }

  _entriesOf(tier) {
    const names = [...this._images()];
    for (const part of this.manifest.parts) {
      names.push(part.geometry);
      for (const record of [...(part.transmittance ?? []), ...(part.normalMaps ?? [])]) names.push(record.texture);
    }
    for (const part of tier.parts) {
      names.push(part.planes, part.decoder);
      for (const record of [part.shadowed, part.emission]) if (record) names.push(record.decoder);
    }
    return [...new Set(names)];
  }

  /** Entries that showing the tier takes. */
  _needed(name, wantsLobes) {
    return [...new Set([...this._entriesOf(this.tier(name)), ...entriesOf((wantsLobes && this.environment) || [])])];
  }

  /** Byte ranges that hold the entries, neighbours together. */
  _ranges(names) {
    const spans = names.map((name) => this.directory.get(name)).sort((a, b) => a.header - b.header);
    const ranges = [];
    for (const { header, end } of spans) {
      const last = ranges.at(-1);
      if (last && header - last[1] <= GAP) last[1] = end;
      else ranges.push([header, end]);
    }
    return ranges;
  }

  /** Begins to fetch those that are not there yet, all at once. */
  _fetch(names) {
    const missing = names.filter((name) => !this.cache.has(name)), ranges = this._ranges(missing);
    if (!missing.length) return;
    this.source.expect(ranges);
    for (const [start, end] of ranges) {
      const bytes = this.source.read(start, end), isInside = (entry) => entry.header >= start && entry.end <= end;
      const inside = missing.filter((name) => isInside(this.directory.get(name)));
      for (const name of inside) this.cache.set(name, { bytes, start });
      bytes.catch(() => inside.forEach((name) => this.cache.delete(name)));  // whoever waits for them tells
    }
  }

  async _stored(name) {
    const entry = this.directory.get(name), { bytes, start } = this.cache.get(name) ?? {};
    const stored = bytes ? (await bytes).subarray(entry.header - start, entry.end - start) : await this.source.read(entry.header, entry.end);
    return entryData(entry, stored);
  }

  /** The entry as the rest of the spec knows it: checked, decoded where it is coded. */
  async _data(name) {
    const stored = await this._stored(name);
    await checkHash(stored, this.manifest.entries[name].sha256, name);
    const coding = this.manifest.extensions?.RNA_deflate?.entries[name];
    if (!coding) return stored;
    const decoded = await decodeEntry(stored, coding, name);
    await checkHash(decoded, coding.sha256, name);
    return decoded;
  }
}

/** The name of an image: of textures/label.png, label. */
const stemOf = (entry) => entry.split("/").pop().replace(/\.[^.]*$/, "");

/** more: columns behind those of the blocks. */
function decoderOf(data, part, record, output, outputs, more = 0) {
  const columns = record.inputs.reduce((sum, block) => sum + widthOf(block, part.channels), more);
  const options = { columns, outputs, output, precision: record.decoderPrecision };
  return readDecoder(data.get(record.decoder), options, record.decoder);
}

function roundedBounds({ min, max }) {
  return { min: min.map(Math.fround), max: max.map(Math.fround) };
}

/** Where the browser has no SHA-256 (plain HTTP), the CRC-32 was checked already. */
async function checkHash(bytes, expected, name) {
  if (!globalThis.crypto?.subtle) return;
  const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  const actual = [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  if (actual !== expected) fail("ENTRY_HASH", name, "the bytes do not have the declared SHA-256");
}
