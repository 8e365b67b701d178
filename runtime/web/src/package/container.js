// The ZIP archive of a package (spec, 2 and 10). Headers are checked before any data is used; of an
// entry that is not read only the central header is seen.
import { fail } from "./errors.js";
import { modelFile, otherFile } from "./other_files.js";

const END = 22, CENTRAL = 46, LOCAL = 30, ALIGNMENT = 64, MOST = 256;
const NAME = /^[A-Za-z0-9_-][A-Za-z0-9._-]*(\/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$/;
export const MANIFEST = "manifest.json";
const LARGEST_MANIFEST = 2 ** 20;

const view = (bytes) => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

/** Entries by name, each { name, header, end, size, crc }: bytes header to end are its own. */
export async function readDirectory(source) {
  const { size } = source;
  if (size === 0) fail("FILE_EMPTY", source.name, "the file has no bytes");
  if (size > 2 ** 32 - 2) fail("FILE_TOO_LARGE", source.name, `${size} bytes`);
  const { count, start } = await readEnd(source);
  const bytes = await source.read(start, size - END);
  const entries = readHeaders(bytes, count, start, source.name);
  checkPlaces(entries, start, source.name);
  return new Map(entries.map((entry) => [entry.name, entry]));
}

async function readEnd(source) {
  const { size, name } = source;
  const head = await source.read(0, Math.min(512, size)), other = otherFile(head) ?? modelFile(head);
  if (other) fail("ZIP_NOT_ZIP", name, `expected a package, found ${other}`);
  const isZip = size >= 4 && view(head).getUint32(0, true) === 0x04034b50;
  const code = isZip ? "ZIP_TRUNCATED" : "ZIP_NOT_ZIP";
  if (size < END) fail(code, name, "shorter than the end record of a ZIP archive");
  const end = view(await source.read(size - END, size));
  const empty = size === END && end.getUint32(0, true) === 0x06054b50;
  if (end.getUint32(0, true) !== 0x06054b50) await noEnd(source, code);
  const short = (at) => end.getUint16(at, true);
  if ([4, 6, 8, 10].some((at) => short(at) === 0xffff)) fail("ZIP_ZIP64", name, "a ZIP64 archive");
  if (short(4) || short(6)) fail("ZIP_ZIP64", name, "an archive of several disks");
  const count = short(10), length = end.getUint32(12, true), start = end.getUint32(16, true);
  if (count > MOST) fail("ZIP_TOO_MANY", name, `${count} entries; at most ${MOST}`);
  if (short(8) !== count || short(20) !== 0 || start + length !== size - END) {
    fail("ZIP_DIRECTORY", name, "the end record does not fit the central directory");
  }
  if (empty || count === 0) fail("ZIP_ORDER", name, `${MANIFEST} is not the first entry`);
  return { count, start };
}

/** An end record with a comment behind it is a fault of its own. */
async function noEnd(source, code) {
  const tail = await source.read(Math.max(0, source.size - END - 65535), source.size);
  const data = view(tail);
  for (let at = tail.length - END; at >= 0; at--) {
    if (data.getUint32(at, true) !== 0x06054b50) continue;
    if (at + END + data.getUint16(at + 20, true) !== tail.length) continue;
    fail("ZIP_DIRECTORY", source.name, "the archive has a comment");
  }
  fail(code, source.name, "the file does not end with the end record of a ZIP archive");
}

function readHeaders(bytes, count, start, file) {
  const data = view(bytes), entries = [], seen = new Set();
  let at = 0;
  for (let k = 0; k < count; k++) {
    if (at + CENTRAL > bytes.length || data.getUint32(at, true) !== 0x02014b50) {
      fail("ZIP_DIRECTORY", file, `the central directory has no header ${k}`);
    }
    const length = data.getUint16(at + 28, true);
    if (at + CENTRAL + length > bytes.length || data.getUint32(at + 30, true)) {
      fail("ZIP_DIRECTORY", file, `header ${k} of the central directory is malformed`);
    }
    const raw = bytes.subarray(at + CENTRAL, at + CENTRAL + length);
    const name = String.fromCharCode(...raw);
    checkHeader(data, at, name, file);
    if (!NAME.test(name) || name.includes("\n") || length > 200) {
      fail("ZIP_NAME", file, `an entry is called ${JSON.stringify(name.slice(0, 80))}`);
    }
    const folded = name.toLowerCase();
    if (seen.has(folded)) fail("ZIP_DUPLICATE", name, "the name is there twice");
    seen.add(folded);
    entries.push({
      name, size: data.getUint32(at + 24, true), crc: data.getUint32(at + 16, true),
      header: data.getUint32(at + 42, true), central: bytes.subarray(at, at + CENTRAL + length),
    });
    at += CENTRAL + length;
  }
  if (at !== bytes.length) fail("ZIP_DIRECTORY", file, "bytes behind the last central header");
  for (const { name, header, size } of entries) {
    if (header + LOCAL + name.length + size > start) {
      fail("ZIP_TRUNCATED", name, `${size} bytes reach past the entries`);
    }
  }
  return entries;
}

function checkHeader(data, at, name, file) {
  const short = (offset) => data.getUint16(at + offset, true);
  const long = (offset) => data.getUint32(at + offset, true);
  const where = JSON.stringify(name.slice(0, 80));
  if (long(42) === 0xffffffff || long(20) === 0xffffffff || long(24) === 0xffffffff) {
    fail("ZIP_ZIP64", file, `${where} needs ZIP64`);
  }
  if (short(34)) fail("ZIP_ZIP64", file, `${where} is on another disk`);
  if (short(8) & 1) fail("ZIP_ENCRYPTED", file, `${where} is encrypted`);
  const fixed = [[4, 20], [6, 20], [8, 0], [12, 0], [14, 0x21], [36, 0]];
  if (fixed.some(([offset, value]) => short(offset) !== value) || long(38)) {
    fail("ZIP_HEADER", file, `${where}: a version, flag, time or attribute is not the fixed one`);
  }
  if (short(10)) fail("ZIP_COMPRESSED", file, `${where} is compressed`);
  if (long(20) !== long(24)) fail("ZIP_SIZE", file, `${where} has two sizes`);
}

function checkPlaces(entries, start, file) {
  const sorted = [...entries].sort((a, b) => a.header - b.header);
  let at = 0;
  sorted.forEach((entry, k) => {
    entry.end = k + 1 < sorted.length ? sorted[k + 1].header : start;
    entry.extra = entry.end - entry.header - LOCAL - entry.name.length - entry.size;
    if (entry.extra < 0) fail("ZIP_OVERLAP", entry.name, "shares bytes with the next entry");
    if (entry.header !== at) fail("ZIP_GAP", file, `bytes ${at} to ${entry.header} are no entry's`);
    at = entry.end;
  });
  const manifest = sorted[0];
  if (manifest.name !== MANIFEST) fail("ZIP_ORDER", file, `${MANIFEST} is not the first entry`);
  if (manifest.size > LARGEST_MANIFEST) {
    fail("MANIFEST_TOO_LARGE", MANIFEST, `${manifest.size} bytes; at most ${LARGEST_MANIFEST}`);
  }
}

/** The data of an entry, from `bytes`, those from its header to its end. */
export function entryData(entry, bytes) {
  const data = view(bytes), { name } = entry;
  const nameLength = entry.name.length;
  if (bytes.length < entry.end - entry.header) fail("ZIP_TRUNCATED", name, "the file ends within it");
  const same = data.getUint32(0, true) === 0x04034b50 && data.getUint16(26, true) === nameLength
    && equal(bytes.subarray(4, 26), entry.central.subarray(6, 28))
    && equal(bytes.subarray(LOCAL, LOCAL + nameLength), entry.central.subarray(CENTRAL));
  if (!same) fail("ZIP_LOCAL_HEADER", name, "local and central header differ");
  const extra = data.getUint16(28, true), at = LOCAL + nameLength;
  checkPadding(bytes.subarray(at, at + extra), extra, name);
  if ((entry.header + at + extra) % ALIGNMENT) {
    fail("ZIP_ALIGNMENT", name, `data at byte ${entry.header + at + extra}, no multiple of ${ALIGNMENT}`);
  }
  if (extra !== entry.extra) {
    fail(extra > entry.extra ? "ZIP_OVERLAP" : "ZIP_GAP", name, "its data does not end where the next entry starts");
  }
  const content = bytes.subarray(at + extra, at + extra + entry.size);
  if (crc32(content) !== entry.crc) fail("ZIP_CRC", name, "the bytes do not have the CRC-32 of the header");
  return content;
}

function checkPadding(extra, length, name) {
  if (length === 0) return;
  const right = length >= 4 && extra.length === length && extra[0] === 0x52 && extra[1] === 0x4e
    && extra[2] + 256 * extra[3] === length - 4 && extra.subarray(4).every((byte) => byte === 0);
  if (!right) fail("ZIP_EXTRA", name, "the extra field is not zero padding");
}

const equal = (a, b) => a.length === b.length && a.every((byte, k) => byte === b[k]);

// Four tables: four bytes a step (Kounavis and Berry, "A Systematic Approach to Building High
// Performance Software-Based CRC Generators", 2005).
const TABLES = Array.from({ length: 4 }, () => new Uint32Array(256));
for (let byte = 0; byte < 256; byte++) {
  let c = byte;
  for (let k = 0; k < 8; k++) c = c & 1 ? (c >>> 1) ^ 0xedb88320 : c >>> 1;
  TABLES[0][byte] = c >>> 0;
}
for (let k = 1; k < 4; k++) {
  for (let byte = 0; byte < 256; byte++) {
    const before = TABLES[k - 1][byte];
    TABLES[k][byte] = (before >>> 8) ^ TABLES[0][before & 255];
  }
}

export function crc32(bytes) {
  const [t0, t1, t2, t3] = TABLES;
  let c = 0xffffffff, at = 0;
  for (; at + 4 <= bytes.length; at += 4) {
    c ^= bytes[at] | (bytes[at + 1] << 8) | (bytes[at + 2] << 16) | (bytes[at + 3] << 24);
    c = t3[c & 255] ^ t2[(c >>> 8) & 255] ^ t1[(c >>> 16) & 255] ^ t0[c >>> 24];
  }
  for (; at < bytes.length; at++) c = t0[(c ^ bytes[at]) & 255] ^ (c >>> 8);
  return (c ^ 0xffffffff) >>> 0;
}
