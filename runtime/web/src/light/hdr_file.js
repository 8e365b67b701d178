// Radiance pictures (.hdr), as runtime/rna_render/lights/files/radiance_hdr.py reads them.
// G. Ward, The RADIANCE Picture File Format, and Real Pixels (Graphics Gems II, 1991).
import { NotSupported } from "../package/errors.js";
import { checkImageSize } from "./image_limits.js";

const MAX_HEADER_BYTES = 65536, NEW_CODE_WIDTHS = [8, 0x7fff];
const SIZE = /^([-+])([XY]) +(\d{1,9}) +([-+])([XY]) +(\d{1,9})$/;
const NUMBER = /^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/;
const SPACE = /^[ \t\r\x0b\f]+|[ \t\r\x0b\f]+$/g;

const broken = (message) => new NotSupported(`broken HDR image${message}`);

/** { rgb, width, height }, row 0 at the top, divided by the header's EXPOSURE. */
export function readHdr(bytes) {
  const header = readHeader(bytes);
  const { count, length, columns, back, exposure } = header;
  const rgbe = readPixels(bytes, header), scale = 1 / exposure;
  const [width, height] = columns ? [count, length] : [length, count], rgb = new Float32Array(3 * width * height);
  for (let line = 0; line < count; line++) {
    const across = back[0] ? count - 1 - line : line;
    for (let k = 0; k < length; k++) {
      const along = back[1] ? length - 1 - k : k, from = 4 * (line * length + k);
      const to = 3 * (columns ? along * width + across : across * width + along), exponent = rgbe[from + 3];
      // Without the half step that Real Pixels adds to a mantissa, as most readers have it.
      const step = exponent > 0 ? scale * 2 ** (exponent - 136) : 0;
      for (let c = 0; c < 3; c++) rgb[to + c] = rgbe[from + c] * step;
    }
  }
  return { rgb, width, height };
}

function readHeader(bytes) {
  const lines = [];
  let at = 0, end = -1;
  while (end < 0 || lines.length < end + 2) {
    const stop = bytes.subarray(0, MAX_HEADER_BYTES).indexOf(10, at);
    if (stop < 0) throw broken(": it has no header");
    lines.push(Array.from(bytes.subarray(at, stop), (code) => String.fromCharCode(code)).join(""));
    at = stop + 1;
    if (end < 0 && lines.at(-1).replace(/\r+$/, "") === "") end = lines.length - 1;
  }
  let exposure = 1;
  for (const line of lines.slice(1, end)) {
    const split = line.indexOf("="), [name, value] = split < 0 ? [line, ""] : [line.slice(0, split), line.slice(split + 1)];
    const key = name.replace(SPACE, ""), text = value.replace(SPACE, "");
    if (key === "FORMAT" && text !== "32-bit_rle_rgbe") throw broken(`: format '${text}', expected 32-bit_rle_rgbe`);
    if (key === "EXPOSURE") exposure *= NUMBER.test(text) ? Number(text) || 1 : 0;  // FreeImage writes 0
  }
  if (!(exposure > 0 && exposure < Infinity)) throw broken(": EXPOSURE is not a positive number");
  const size = lines[end + 1].replace(SPACE, ""), match = SIZE.exec(size);
  if (match === null || match[2] === match[5]) {
    throw broken(`: size '${size.slice(0, 40)}', expected such as '-Y height +X width'`);
  }
  const count = Number(match[3]), length = Number(match[6]), columns = match[2] === "X";
  const back = [match[1] + match[2], match[4] + match[5]].map((axis) => axis === "+Y" || axis === "-X");
  checkImageSize(...(columns ? [count, length] : [length, count]), bytes.length);
  return { offset: at, count, length, columns, back, exposure };
}

function readPixels(bytes, { offset, count, length }) {
  const rgbe = new Uint8Array(4 * count * length);
  let at = offset;
  try {
    for (let line = 0; line < count; line++) at = readLine(bytes, at, rgbe.subarray(4 * line * length), length, line);
  } catch (error) {
    // Flat pixels may look like either code: a first one of 2, 2, less than 128.
    if (bytes.length - offset === rgbe.length) return bytes.subarray(offset);
    throw error;
  }
  return rgbe;
}

function readLine(bytes, at, line, length, row) {
  const wide = length >= NEW_CODE_WIDTHS[0] && length <= NEW_CODE_WIDTHS[1] && at + 4 <= bytes.length;
  if (wide && bytes[at] === 2 && bytes[at + 1] === 2 && bytes[at + 2] < 128) {
    if (bytes[at + 2] * 256 + bytes[at + 3] !== length) throw broken(`, line ${row}: a run goes past the line's end`);
    return readComponents(bytes, at + 4, line, length, row);
  }
  return readFlat(bytes, at, line, length, row);
}

/** The newer code: the four components one after another, each in runs and dumps. */
function readComponents(bytes, at, line, length, row) {
  for (let component = 0; component < 4; component++) {
    for (let x = 0; x < length;) {
      if (at + 2 > bytes.length) throw broken(`, line ${row}: the file ends there`);
      const run = bytes[at] > 128, count = run ? bytes[at] - 128 : bytes[at];
      if (count === 0) throw broken(`, line ${row}: a run of no pixels`);
      if (x + count > length) throw broken(`, line ${row}: a run goes past the line's end`);
      if (at + 1 + (run ? 1 : count) > bytes.length) throw broken(`, line ${row}: the file ends there`);
      for (let k = 0; k < count; k++) line[4 * (x + k) + component] = bytes[at + 1 + (run ? 0 : k)];
      x += count;
      at += run ? 2 : 1 + count;
    }
  }
  return at;
}

/** Flat pixels and the older code: (1, 1, 1, n) repeats the pixel before n << shift times. */
function readFlat(bytes, at, line, length, row) {
  let x = 0, shift = 0;
  while (x < length) {
    if (at + 4 > bytes.length) throw broken(`, line ${row}: the file ends there`);
    if (bytes[at] === 1 && bytes[at + 1] === 1 && bytes[at + 2] === 1) {
      if (x === 0) throw broken(`, line ${row}: a run repeats a pixel, but there is none before it`);
      const count = shift > 16 ? Infinity : bytes[at + 3] * 2 ** shift;
      if (x + count > length) throw broken(`, line ${row}: a run goes past the line's end`);
      for (let k = 0; k < count; k++) line.copyWithin(4 * (x + k), 4 * (x - 1), 4 * x);
      x += count;
      shift += 8;
    } else {
      line.set(bytes.subarray(at, at + 4), 4 * x);
      x += 1;
      shift = 0;
    }
    at += 4;
  }
  return at;
}
