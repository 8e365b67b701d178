// Environments in OpenEXR files: pixels by three, the choice of part and window as in
// runtime/rna_render/lights/files/environment_exr.py. docs/scene.md has the table.
import { EXRLoader } from "three/addons/loaders/EXRLoader.js";
import { NotSupported } from "../package/errors.js";
import { checkImageSize, MAX_IMAGE_VALUES } from "./image_limits.js";
import { FloatType } from "./parts_of_three.js";

// OpenEXR file layout: flags of the version field, numbers of compressions and of pixel types.
const FLAG_TILES = 0x200, FLAG_DEEP = 0x800, FLAG_PARTS = 0x1000;
const COMPRESSIONS = ["NO", "RLE", "ZIPS", "ZIP", "PIZ", "PXR24", "B44", "B44A", "DWAA", "DWAB"];
const UINT = 0, FLOAT = 2, RIPMAP = 2, MAX_ATTRIBUTES = 4096;
const CHROMA = ["RY", "BY"];

/** { rgb, width, height } of the first part with R, G and B (or Y), row 0 at the top of the display window. */
export function readExr(bytes) {
  const { parts, flags } = readHeaders(bytes), number = picture(parts), part = parts[number];
  checkLayout(part, parts.length, flags);
  for (const window of [part.dataWindow, part.displayWindow]) checkImageSize(...sizeOf(window), bytes.length);
  const values = parts.reduce((sum, one) => sum + Math.max(0, valuesOf(one)), 0);
  if (values > MAX_IMAGE_VALUES) {
    throw new NotSupported(`has ${values} values in all its channels; at most ${MAX_IMAGE_VALUES}`);
  }
  const data = part.dataWindow, display = part.displayWindow;
  const left = Math.max(data[0], display[0]), right = Math.min(data[2], display[2]);
  const top = Math.max(data[1], display[1]), bottom = Math.min(data[3], display[3]);
  if (left > right || top > bottom) throw new NotSupported("its data window lies outside its display window");
  checkTypes(part);
  const loader = new EXRLoader().setDataType(FloatType).setPart(number);
  const image = loader.parse(readableByThree(bytes, part).buffer);
  const [width, height] = sizeOf(display), [stored] = sizeOf(data), rgb = new Float32Array(3 * width * height);
  for (let y = top; y <= bottom; y++) {
    const row = data[3] - y;  // three has rows from the bottom
    for (let x = left; x <= right; x++) {
      const from = 4 * (row * stored + x - data[0]), to = 3 * ((y - display[1]) * width + x - display[0]);
      for (let c = 0; c < 3; c++) rgb[to + c] = image.data[from + c];
    }
  }
  return { rgb, width, height };
}

function sizeOf([left, top, right, bottom]) {
  return [right - left + 1, bottom - top + 1];
}

function valuesOf({ dataWindow, channels }) {
  const [width, height] = sizeOf(dataWindow);
  return Math.max(0, width) * Math.max(0, height) * channels.length;
}

/** The channels that are red, green and blue. */
function coloursOf({ channels }) {
  const names = new Set(channels.map(({ name }) => name));
  if (names.has("R") && names.has("G") && names.has("B")) return ["R", "G", "B"];
  return names.has("Y") && !CHROMA.some((name) => names.has(name)) ? ["Y"] : [];
}

function picture(parts) {
  const number = parts.findIndex((part) => coloursOf(part).length > 0);
  if (number >= 0) return number;
  const names = [...new Set(parts.flatMap(({ channels }) => channels.map(({ name }) => name)))].sort();
  if (["Y", ...CHROMA].every((name) => names.includes(name))) {
    throw new NotSupported("has luminance and chroma (Y, RY, BY): save it with R, G and B");
  }
  const more = names.length > 12 ? ` and ${names.length - 12} more` : "";
  throw new NotSupported(`has no channels R, G and B, nor Y; it has ${names.slice(0, 12).join(", ") || "none"}${more}`);
}

function checkLayout(part, count, flags) {
  const deep = part.type ? part.type.startsWith("deep") : (flags & FLAG_DEEP) !== 0;
  const tiled = part.type ? part.type === "tiledimage" : (flags & FLAG_TILES) !== 0;
  const say = (message) => { throw new NotSupported(message); };
  if (deep) say("is a deep image, with any number of samples a pixel: flatten it");
  if (part.envmap) say("is a cube map: convert it to latitude and longitude");
  if (part.channels.some(({ x, y }) => x !== 1 || y !== 1)) {
    say("has channels of fewer texels than others: save them all at full size");
  }
  if (COMPRESSIONS[part.compression] === undefined) {
    say(`has compression ${part.compression}, expected one of ${COMPRESSIONS.join(", ")}`);
  }
  if (tiled && count > 1) say("has tiles in one of several parts: save it with scan lines");
  if (tiled && part.levels === RIPMAP) say("has tiles of several sizes by row and column: save it with one size");
}

function checkTypes(part) {
  const wanted = coloursOf(part), types = new Set();
  for (const { name, type } of part.channels) if (wanted.includes(name)) types.add(["uint32", "float16", "float32"][type]);
  if (types.size > 1 || types.has("uint32")) {
    throw new NotSupported(`has colours of type ${[...types].sort().join(", ")}, expected float16 or float32`);
  }
}

/**
 * The file's bytes, changed in what three takes wrongly: whole numbers count as floats, which are as long; channels
 * that are no colour, but that three knows, have another name.
 */
function readableByThree(bytes, part) {
  const copy = bytes.slice(), wanted = coloursOf(part), type = part.channels.find(({ name }) => name === wanted[0]).type;
  const byName = ["DWAA", "DWAB"].includes(COMPRESSIONS[part.compression]);  // names say how they are coded
  for (const channel of part.channels) {
    if (channel.type === UINT && COMPRESSIONS[part.compression] !== "PXR24") copy[channel.typeAt] = FLOAT;
    const known = ["A", "Y", "RY", "BY"].includes(channel.name) && !wanted.includes(channel.name);
    if (known && !(byName && channel.type === type)) for (let k = 0; k < channel.name.length; k++) copy[channel.at + k] |= 0x20;
  }
  return copy;
}

function readHeaders(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length), flags = view.getUint32(4, true);
  const reader = { bytes, view, at: 8 }, parts = [];
  do {
    const part = readPart(reader);
    if (part === null) break;
    parts.push(part);
  } while (flags & FLAG_PARTS);
  if (!parts.length) throw new NotSupported("broken EXR image: it has no header");
  return { parts, flags };
}

/** One part's attributes that are needed; null at the end of the parts. */
function readPart(reader) {
  const part = { channels: null, compression: null, dataWindow: null, displayWindow: null, type: "", envmap: 0, levels: 0 };
  const { view } = reader;
  for (let count = 0; ; count++) {
    const name = text(reader);
    if (name === "") {
      if (count === 0) return null;
      break;
    }
    const type = text(reader);
    const size = view.getInt32(reader.at, true), at = reader.at + 4;
    if (size < 0 || at + size > reader.bytes.length || count > MAX_ATTRIBUTES) {
      throw new NotSupported("broken EXR image: an attribute goes past the file's end");
    }
    if (name === "channels") part.channels = readChannels({ ...reader, at });
    if (name === "compression") part.compression = view.getUint8(at);
    if (name === "dataWindow" || name === "displayWindow") part[name] = [0, 4, 8, 12].map((k) => view.getInt32(at + k, true));
    if (name === "type") part.type = String.fromCharCode(...reader.bytes.subarray(at, at + Math.min(size, 64)));
    if (name === "envmap" && type === "envmap") part.envmap = view.getUint8(at);
    if (name === "tiles") part.levels = view.getUint8(at + 8) & 15;
    reader.at = at + size;
  }
  const missing = ["channels", "compression", "dataWindow", "displayWindow"].find((name) => part[name] === null);
  if (missing !== undefined) throw new NotSupported(`broken EXR image: it has no ${missing}`);
  return part;
}

function readChannels(reader) {
  const channels = [];
  for (;;) {
    const at = reader.at, name = text(reader);
    if (name === "") return channels;
    const typeAt = reader.at, { view } = reader;
    channels.push({ name, at, typeAt, type: view.getInt32(typeAt, true), x: view.getInt32(typeAt + 8, true), y: view.getInt32(typeAt + 12, true) });
    reader.at += 16;
  }
}

function text(reader) {
  const end = reader.bytes.indexOf(0, reader.at);
  if (end < 0 || end - reader.at > 255) throw new NotSupported("broken EXR image: its header does not end");
  const result = new TextDecoder("utf-8", { fatal: true }).decode(reader.bytes.subarray(reader.at, end));
  reader.at = end + 1;
  return result;
}
